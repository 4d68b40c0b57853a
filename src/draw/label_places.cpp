// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/label_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace truelux {
namespace {

/// By the font's size, generously.
constexpr double kCharacterWidth = 0.58;
/// Between a label and the ends of its line [px].
constexpr double kMargin = 2.5;
/// A longer line gets a label each so many pixels.
constexpr double kLabelStep = 420;
/// Labels of one series are at least so far from each other [px].
constexpr double kApart = 150;

/// Points of all lines by cells of the picture.
class Crowd {
 public:
  explicit Crowd(const LabelBox& frame) : frame_(frame) {
    columns_ = 1 + static_cast<std::size_t>(
                       std::max(0.0, (frame.right - frame.left) / kCell));
    rows_ = 1 + static_cast<std::size_t>(
                    std::max(0.0, (frame.bottom - frame.top) / kCell));
    cells_.resize(columns_ * rows_);
  }

  /// line: its index, or one that no line has.
  void Add(const PaperPath& path, std::size_t line, double weight) {
    constexpr double kStep = 3;
    for (std::size_t i = 1; i < path.size(); ++i) {
      const PaperPoint& a = path[i - 1];
      const PaperPoint& b = path[i];
      const int steps =
          1 + static_cast<int>(std::hypot(b.x - a.x, b.y - a.y) / kStep);
      for (int k = 0; k < steps; ++k) {
        const double t = static_cast<double>(k) / steps;
        const PaperPoint p = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
        cells_[RowOf(p.y) * columns_ + ColumnOf(p.x)].push_back(
            {p, line, weight});
      }
    }
  }

  /// How much is under a label, but for one line.
  [[nodiscard]] double Under(const GapLabel& label, std::size_t but) const {
    const double reach = std::hypot(label.half_width, label.half_height);
    double sum = 0;
    for (std::size_t row = RowOf(label.middle.y - reach);
         row <= RowOf(label.middle.y + reach); ++row) {
      for (std::size_t column = ColumnOf(label.middle.x - reach);
           column <= ColumnOf(label.middle.x + reach); ++column) {
        for (const Entry& entry : cells_[row * columns_ + column]) {
          if (entry.line != but && label.Holds(entry.at)) sum += entry.weight;
        }
      }
    }
    return sum;
  }

 private:
  static constexpr double kCell = 8;

  struct Entry {
    PaperPoint at;
    std::size_t line = 0;
    double weight = 1;
  };

  [[nodiscard]] std::size_t ColumnOf(double x) const {
    return Clamped((x - frame_.left) / kCell, columns_);
  }

  [[nodiscard]] std::size_t RowOf(double y) const {
    return Clamped((y - frame_.top) / kCell, rows_);
  }

  static std::size_t Clamped(double place, std::size_t count) {
    if (!(place > 0)) return 0;
    return std::min(static_cast<std::size_t>(place), count - 1);
  }

  LabelBox frame_;
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
  std::vector<std::vector<Entry>> cells_;
};

/// The points of a path by the way along it.
class Course {
 public:
  explicit Course(const PaperPath& path) : path_(path) {
    ways_.push_back(0);
    for (std::size_t i = 1; i < path.size(); ++i) {
      ways_.push_back(ways_.back() + std::hypot(path[i].x - path[i - 1].x,
                                                path[i].y - path[i - 1].y));
    }
  }

  [[nodiscard]] double length() const { return ways_.back(); }

  [[nodiscard]] PaperPoint At(double way) const {
    const auto after = std::ranges::lower_bound(ways_, way);
    const auto i = static_cast<std::size_t>(after - ways_.begin());
    if (i == 0) return path_.front();
    if (i >= path_.size()) return path_.back();
    const double step = ways_[i] - ways_[i - 1];
    const double t = step > 0 ? (way - ways_[i - 1]) / step : 0;
    return {path_[i - 1].x + t * (path_[i].x - path_[i - 1].x),
            path_[i - 1].y + t * (path_[i].y - path_[i - 1].y)};
  }

  /// How far the part between two ways is from its chord at most, and the
  /// chord's length.
  [[nodiscard]] std::pair<double, double> BendOf(double from, double to) const {
    const PaperPoint a = At(from);
    const PaperPoint b = At(to);
    const double chord = std::hypot(b.x - a.x, b.y - a.y);
    double bend = 0;
    const auto first = std::ranges::upper_bound(ways_, from);
    for (auto i = static_cast<std::size_t>(first - ways_.begin());
         i < path_.size() && ways_[i] < to; ++i) {
      const double area =
          (b.x - a.x) * (path_[i].y - a.y) - (b.y - a.y) * (path_[i].x - a.x);
      bend = std::max(bend, chord > 0 ? std::abs(area) / chord : HUGE_VAL);
    }
    return {bend, chord};
  }

 private:
  const PaperPath& path_;
  std::vector<double> ways_;
};

/// Between -90 and 90 degrees, so that nobody has to turn the paper.
double Upright(double angle) {
  if (angle > 90) return angle - 180;
  if (angle < -90) return angle + 180;
  return angle;
}

/// With room around it, since lines have a width.
GapLabel Padded(GapLabel label) {
  constexpr double kPad = 2;
  label.half_width += kPad;
  label.half_height += kPad;
  return label;
}

class Placer {
 public:
  Placer(std::span<const LabelledLine> lines,
         std::span<const std::string> texts,
         std::span<const Obstacle> obstacles, const LabelBox& frame)
      : lines_(lines), texts_(texts), frame_(frame), crowd_(frame) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      crowd_.Add(lines[i].path, i, 1);
      lengths_.push_back(LengthOf(lines[i].path));
    }
    for (const Obstacle& obstacle : obstacles)
      crowd_.Add(obstacle.path, lines.size(), obstacle.weight);
  }

  std::vector<GapLabel> Place() {
    std::vector<std::size_t> longest;
    for (std::size_t s = 0; s < texts_.size(); ++s) {
      std::optional<std::size_t> best;
      for (std::size_t i = 0; i < lines_.size(); ++i) {
        if (lines_[i].series != s || lines_[i].path.size() < 2) continue;
        if (!best || lengths_[i] > lengths_[*best]) best = i;
      }
      if (best) longest.push_back(*best);
    }
    // Where there is least choice first.
    std::ranges::stable_sort(longest, {},
                             [this](std::size_t i) { return lengths_[i]; });
    for (const std::size_t i : longest) {
      if (!PlaceOn(i, HUGE_VAL)) PlaceBeside(i);
    }
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const bool has_one = std::ranges::count(longest, i) > 0;
      const double first = has_one ? 2 * kLabelStep : kLabelStep / 2;
      const auto count = static_cast<int>(
          std::max(0.0, std::ceil((lengths_[i] - first) / kLabelStep)));
      for (int k = 0; k < count && PlaceOn(i, 0.5); ++k) {
      }
    }
    return std::move(labels_);
  }

 private:
  [[nodiscard]] GapLabel LabelOf(std::size_t line) const {
    GapLabel label;
    label.series = lines_[line].series;
    label.half_width =
        kMargin + 0.5 * kCharacterWidth * kGapFont *
                      static_cast<double>(texts_[label.series].size());
    label.half_height = 0.5 * kGapFont;
    return label;
  }

  [[nodiscard]] bool IsFree(const GapLabel& label) const {
    for (const PaperPoint& p : label.Corners()) {
      if (p.x < frame_.left || p.x > frame_.right || p.y < frame_.top ||
          p.y > frame_.bottom)
        return false;
    }
    return std::ranges::none_of(labels_, [&label](const GapLabel& other) {
      return label.Overlaps(other) ||
             (label.series == other.series &&
              std::hypot(label.middle.x - other.middle.x,
                         label.middle.y - other.middle.y) < kApart);
    });
  }

  /// A label in a gap of the line, in the best place. most: how much it may
  /// cover.
  bool PlaceOn(std::size_t line, double most) {
    constexpr double kStep = 4;
    constexpr double kMostBend = 0.3 * kGapFont;
    const Course course(lines_[line].path);
    GapLabel label = LabelOf(line);
    const double half = label.half_width;
    std::optional<GapLabel> best;
    double best_cost = HUGE_VAL;
    const auto steps =
        static_cast<int>(std::floor((course.length() - 3 * half) / kStep));
    for (int step = 0; step <= steps; ++step) {
      const double way = 1.5 * half + step * kStep;
      const auto [bend, chord] = course.BendOf(way - half, way + half);
      if (bend > kMostBend || chord < 1.8 * half) continue;
      const PaperPoint a = course.At(way - half);
      const PaperPoint b = course.At(way + half);
      const PaperPoint middle = course.At(way);
      // In the middle of the sagitta, so that both ends meet the text.
      label.middle = {0.25 * (a.x + b.x) + 0.5 * middle.x,
                      0.25 * (a.y + b.y) + 0.5 * middle.y};
      label.angle =
          Upright(std::atan2(b.y - a.y, b.x - a.x) * 180 / std::numbers::pi);
      const double off = std::abs(way / course.length() - 0.5);
      const double plain = bend + 2 * off + std::abs(label.angle) / 45;
      if (plain >= best_cost || !IsFree(label)) continue;
      const double under = crowd_.Under(Padded(label), line);
      const double cost = 10 * under + plain;
      if (under > most || cost >= best_cost) continue;
      best = label;
      best_cost = cost;
    }
    if (best) labels_.push_back(*best);
    return best.has_value();
  }

  /// A level label near a line that has no room for it.
  void PlaceBeside(std::size_t line) {
    constexpr std::array<double, 3> kAway = {4, 10, 18};
    constexpr std::array<std::array<int, 2>, 8> kWays = {
        {{1, 0}, {-1, 0}, {0, -1}, {0, 1}, {1, -1}, {1, 1}, {-1, -1}, {-1, 1}}};
    constexpr int kPoints = 8;
    const Course course(lines_[line].path);
    GapLabel label = LabelOf(line);
    std::optional<GapLabel> best;
    double best_cost = HUGE_VAL;
    for (int k = 0; k <= kPoints; ++k) {
      const PaperPoint from = course.At(course.length() * k / kPoints);
      for (const double away : kAway) {
        for (const auto& way : kWays) {
          label.middle = {from.x + way[0] * (label.half_width + away),
                          from.y + way[1] * (label.half_height + away)};
          const double cost =
              10 * crowd_.Under(Padded(label), lines_.size() + 1) + away;
          if (cost >= best_cost || !IsFree(label)) continue;
          best = label;
          best_cost = cost;
        }
      }
    }
    if (best) labels_.push_back(*best);
  }

  std::span<const LabelledLine> lines_;
  std::span<const std::string> texts_;
  LabelBox frame_;
  Crowd crowd_;
  std::vector<double> lengths_;
  std::vector<GapLabel> labels_;
};

}  // namespace

std::vector<GapLabel> PlaceGapLabels(std::span<const LabelledLine> lines,
                                     std::span<const std::string> texts,
                                     std::span<const Obstacle> obstacles,
                                     const LabelBox& frame) {
  return Placer(lines, texts, obstacles, frame).Place();
}

}  // namespace truelux
