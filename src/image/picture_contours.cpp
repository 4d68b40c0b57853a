// SPDX-License-Identifier: GPL-3.0-or-later
#include "image/picture_contours.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>

#include "base/vector_math.h"
#include "image/picture_scale.h"
#include "isolux/quick_contours.h"
#include "surface/named_surface.h"

namespace truelux {
namespace {

/// Between points at which a level is looked for [px].
constexpr double kSpacing = 3;

/// Points of a surface as places in its picture.
class PicturePlaces {
 public:
  PicturePlaces(const SurfaceFrame& frame, int width, int height)
      : frame_(frame),
        width_(width / mpq_class(frame.a_most - frame.a_least)),
        height_(height / mpq_class(frame.b_most - frame.b_least)) {}

  [[nodiscard]] std::array<double, 2> At(const Point3& p) const {
    const SurfaceFrame::Coordinates c = frame_.Of(p);
    const mpq_class x = (c.a - frame_.a_least) * width_;
    const mpq_class y = (frame_.b_most - c.b) * height_;
    return {x.get_d(), y.get_d()};
  }

  /// How long a pixel is, the shorter side [length].
  [[nodiscard]] double PixelSize() const {
    const auto length = [](const RationalVector& v) {
      return LengthOf({v.x.get_d(), v.y.get_d(), v.z.get_d()});
    };
    return std::min(length(frame_.u) / width_.get_d(),
                    length(frame_.v) / height_.get_d());
  }

 private:
  const SurfaceFrame& frame_;
  mpq_class width_;   ///< pixels a unit of a
  mpq_class height_;  ///< and of b
};

}  // namespace

std::vector<PictureContour> FindPictureContours(const Oracle& oracle,
                                                const std::string& surface,
                                                const IrradianceImage& image,
                                                const PictureStyle& style,
                                                int threads,
                                                const Watch& watch) {
  const PictureScale shown = PictureScaleOf(image, style);
  // No contour has the level 0.
  const auto levels = std::span(shown.scale.ticks()).subspan(1);
  const NamedSurface named = SurfaceNamed(oracle.scene(), surface);
  const PicturePlaces places(named.frame, image.values.width(),
                             image.values.height());
  std::vector<PictureContour> drawn;
  for (const IsoluxContour& contour :
       QuickContoursOf(oracle, surface, levels, shown.channel,
                       kSpacing * places.PixelSize(), threads, watch)) {
    PictureContour& line = drawn.emplace_back();
    line.level = contour.level;
    for (const IsoluxVertex& vertex : contour.vertices)
      line.path.push_back(places.At(vertex.at));
    if (contour.is_closed) line.path.push_back(line.path.front());
  }
  return drawn;
}

}  // namespace truelux
