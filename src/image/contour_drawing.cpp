// SPDX-License-Identifier: GPL-3.0-or-later
#include "image/contour_drawing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "draw/gap_label.h"
#include "draw/label_places.h"
#include "draw/paper_path.h"
#include "draw/stroke_text.h"
#include "image/line_drawing.h"

namespace truelux {
namespace {

constexpr double kLight = 0.6;
constexpr Rgba8 kWhite = {255, 255, 255, 255};
constexpr Rgba8 kBlack = {0, 0, 0, 255};

/// Smaller pictures have no room for numbers.
constexpr int kLabelledFrom = 160;
/// The picture whose lines and labels are one unit large [px].
constexpr double kUnitPicture = 600;
constexpr double kLineWidth = 1.3;
/// The height of digits by the size of the labels' font.
constexpr double kDigits = 0.72;

class ContourPainter {
 public:
  ContourPainter(Raster<Rgba8>& picture,
                 std::span<const PictureContour> contours)
      : picture_(picture),
        unit_(std::max(
            1.0, std::min(picture.width(), picture.height()) / kUnitPicture)) {
    for (const PictureContour& contour : contours) {
      if (levels_.empty() || levels_.back() != contour.level) {
        levels_.push_back(contour.level);
        texts_.push_back(fmt::format("{:.4g}", contour.level));
      }
      LabelledLine& line = lines_.emplace_back();
      line.series = levels_.size() - 1;
      for (const auto& [x, y] : contour.path)
        line.path.push_back({x / unit_, y / unit_});
    }
  }

  void Paint(const ColourScale& scale) {
    if (std::min(picture_.width(), picture_.height()) >= kLabelledFrom) {
      const LabelBox frame = {0, 0, picture_.width() / unit_,
                              picture_.height() / unit_};
      labels_ = PlaceGapLabels(lines_, texts_, {}, frame);
    }
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      std::vector<PaperPath> paths;
      for (const LabelledLine& line : lines_) {
        if (line.series != i) continue;
        for (const PaperPath& part : OutsideLabels(line.path, labels_))
          paths.push_back(Large(part));
      }
      for (const GapLabel& label : labels_) {
        if (label.series == i) AddText(label, paths);
      }
      DrawLines(picture_, paths, kLineWidth * unit_,
                scale.At(levels_[i]) < kLight ? kWhite : kBlack);
    }
  }

 private:
  [[nodiscard]] PaperPath Large(PaperPath path) const {
    for (PaperPoint& p : path)
      p = {p.x * unit_, p.y * unit_};
    return path;
  }

  void AddText(const GapLabel& label, std::vector<PaperPath>& paths) const {
    const std::string& text = texts_[label.series];
    const double height = kDigits * kGapFont;
    const double angle = label.angle * std::numbers::pi / 180;
    for (PaperPath& stroke : TextStrokes(text)) {
      for (PaperPoint& p : stroke) {
        const double along = height * (p.x - 0.5 * StrokeTextWidth(text));
        const double down = height * (p.y + 0.5);
        p = {label.middle.x + std::cos(angle) * along - std::sin(angle) * down,
             label.middle.y + std::sin(angle) * along + std::cos(angle) * down};
      }
      paths.push_back(Large(std::move(stroke)));
    }
  }

  Raster<Rgba8>& picture_;
  double unit_;
  std::vector<double> levels_;
  std::vector<std::string> texts_;  ///< by level
  std::vector<LabelledLine> lines_;
  std::vector<GapLabel> labels_;
};

}  // namespace

void DrawContours(Raster<Rgba8>& picture,
                  std::span<const PictureContour> contours,
                  const ColourScale& scale) {
  ContourPainter(picture, contours).Paint(scale);
}

}  // namespace truelux
