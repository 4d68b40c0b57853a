// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/gradient_change.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "isolux/lamp_pieces.h"

namespace truelux {
namespace {

/// Parts of edges are halved until they are shorter than this share of their distance.
constexpr double kFine = 0.5;
/// What rounding adds.
constexpr double kEnlarged = 1 + 0x1p-20;

Vec3<double> Between(const Vec3<double>& a, const Vec3<double>& b,
                     double share) {
  return a + share * (b - a);
}

/// The distance of a point from a segment.
double DistanceTo(const Vec3<double>& p, const Vec3<double>& a,
                  const Vec3<double>& b) {
  const Vec3<double> along = b - a;
  const double square = Dot(along, along);
  const double share =
      square > 0 ? std::clamp(Dot(p - a, along) / square, 0.0, 1.0) : 0.0;
  return LengthOf(p - Between(a, b, share));
}

class BoundFinder {
 public:
  BoundFinder(const LightFeatures& features, std::span<const PlanPoint> points,
              const PlanPoint& centre)
      : features_(features), points_(points), centre_{centre.s, centre.t, 0} {
    for (const PlanPoint& p : points) {
      middle_.x += p.s / static_cast<double>(points.size());
      middle_.y += p.t / static_cast<double>(points.size());
    }
    for (const PlanPoint& p : points) {
      radius_ =
          std::max(radius_, LengthOf(Vec3<double>{p.s, p.t, 0} - middle_));
    }
    radius_ += 0x1p-40 * features.size();
  }

  [[nodiscard]] double diameter() const { return 2 * radius_; }

  /// Points 1 to 3 of the head.
  double RateOf(const LampSight& sight) {
    SetLamp(sight);
    double rate = 0;
    for (const auto& triangle : lamp_->triangles)
      rate += AreaRate(triangle);
    for (const SightEdge& part : sight.edges) {
      const LightEdge& edge = EdgeOf(part);
      rate += EdgeRate(Between(edge.ends[0], edge.ends[1], part.from),
                       Between(edge.ends[0], edge.ends[1], part.to));
    }
    return lamp_->exitance / std::numbers::pi * rate;
  }

  /// Point 4, while it is below a limit.
  double JumpOf(const LampSight& sight, double limit) {
    SetLamp(sight);
    const double scale = lamp_->exitance / std::numbers::pi;
    FindNormals(sight);
    double jump = 0;
    for (std::size_t i = sight.lamp_edges; i < sight.edges.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        jump += scale * PairJump(sight, i, k);
      }
      if (jump > limit) break;
    }
    return jump;
  }

 private:
  [[nodiscard]] const LightEdge& EdgeOf(const SightEdge& part) const {
    return features_.edges()[static_cast<std::size_t>(part.edge)];
  }

  void SetLamp(const LampSight& sight) {
    lamp_ = &features_.lamps()[static_cast<std::size_t>(sight.lamp)];
    least_height_ = HUGE_VAL;
    for (const PlanPoint& p : points_)
      least_height_ = std::min(least_height_, lamp_->plane.HeightOf(p));
    least_height_ = std::max(0.0, least_height_);
    most_height_ = least_height_;
    for (const PlanPoint& p : points_)
      most_height_ = std::max(most_height_, lamp_->plane.HeightOf(p));
    tilt_ = std::hypot(lamp_->plane.normal.x, lamp_->plane.normal.y);
    // Any point of the lamp is so far away.
    lamp_distance_ =
        std::fabs(lamp_->plane.HeightOf(middle_)) - radius_ * tilt_;
    lamp_distance_ = std::max(0.0, lamp_distance_);
  }

  /// The sine of the angle from the vertical to places near one, at a distance.
  [[nodiscard]] double SlantOf(const Vec3<double>& p, double spread,
                               double distance) const {
    const double across = std::hypot(p.x - middle_.x, p.y - middle_.y);
    return std::min(1.0, (across + spread + radius_) / distance);
  }

  /// Point 1 without M / pi.
  [[nodiscard]] double AreaRate(const LampTriangle& corners) const {
    return SumOverPieces(
        corners, {middle_, radius_}, [this](const LampPiece& piece) {
          const double slant =
              SlantOf(piece.centre, piece.spread, piece.distance);
          const double square = piece.distance * piece.distance;
          return piece.area * piece.high / (square * square * square) *
                 (8 * tilt_ * slant * piece.distance +
                  most_height_ * std::max(4.0, 24 * slant * slant - 4));
        });
  }

  /// Points 2 and 3 without M / pi.
  double EdgeRate(const Vec3<double>& a, const Vec3<double>& b) const {
    const double length = LengthOf(b - a);
    const double high = std::max(a.z, b.z);
    const double height_a = std::max(0.0, lamp_->plane.HeightOf(a));
    const double height_b = std::max(0.0, lamp_->plane.HeightOf(b));
    const double height = std::max(height_a, height_b);
    if (length == 0 || high <= 0 || height <= 0x1p-40 * features_.size())
      return 0;
    const double distance = DistanceTo(middle_, a, b) - radius_;
    if (distance <= 0) return HUGE_VAL;
    if (length > kFine * distance) {
      const Vec3<double> middle = Between(a, b, 0.5);
      return EdgeRate(a, middle) + EdgeRate(middle, b);
    }
    const double slant = SlantOf(Between(a, b, 0.5), length / 2, distance);
    const double cube = distance * distance * distance;
    // l(x) / l(r) <= 1 for what is before the lamp.
    const double share = least_height_ > height ? height / least_height_ : 1.0;
    const double sweep = high / cube;
    const double far = std::max(distance, lamp_distance_);
    double rate =
        length * share * (sweep / distance * (1 + 4 * slant) + sweep * 4 / far);
    if (tilt_ > 0) {
      // l(x) / l(r)^2 over the edge: its largest value, or the integral up to
      // l(r), which is 1 / (2 |grad l along the edge|).
      const double least =
          std::max(least_height_, std::min(height_a, height_b));
      const double largest =
          height <= least_height_
              ? length * height / (least_height_ * least_height_)
              : length / least;
      const double slope = std::fabs(height_b - height_a) / length;
      rate += 2 * tilt_ * sweep * std::min(largest, 0.5 / slope);
    }
    return rate;
  }

  /// (P - r) x (Q - r) of each edge P Q, from each corner and the centre.
  void FindNormals(const LampSight& sight) {
    normals_.clear();
    for (const SightEdge& part : sight.edges) {
      const LightEdge& edge = EdgeOf(part);
      for (const PlanPoint& p : points_) {
        const Vec3<double> r = {p.s, p.t, 0};
        normals_.push_back(Cross(edge.ends[0] - r, edge.ends[1] - r));
      }
      normals_.push_back(Cross(edge.ends[0] - centre_, edge.ends[1] - centre_));
    }
  }

  /// Where on an edge the end may lie that another edge makes.
  struct Way {
    bool is_none = true;
    double least = 0;
    double at = 0;  ///< seen from the centre
    double most = 0;
  };

  /// edge, other: indices into sight.edges.
  [[nodiscard]] Way WayOn(const LampSight& sight, std::size_t edge,
                          std::size_t other) const {
    const SightEdge& part = sight.edges[edge];
    const auto& [a, b] = EdgeOf(part).ends;
    std::array<bool, 2> has_above{};
    std::array<bool, 2> has_below{};
    bool turns = false;
    double sense = 0;
    Way way{false, HUGE_VAL, 0, -HUGE_VAL};
    const std::size_t first = other * (points_.size() + 1);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Vec3<double> r = {points_[i].s, points_[i].t, 0};
      const Vec3<double>& normal = normals_[first + i];
      const double at_a = Dot(normal, a - r);
      const double at_b = Dot(normal, b - r);
      has_above[0] = has_above[0] || at_a >= 0;
      has_below[0] = has_below[0] || at_a <= 0;
      has_above[1] = has_above[1] || at_b >= 0;
      has_below[1] = has_below[1] || at_b <= 0;
      const double width = at_a - at_b;
      turns = turns || width == 0 || (sense != 0 && (width > 0) != (sense > 0));
      sense = width;
      way.least = std::min(way.least, at_a / width);
      way.most = std::max(way.most, at_a / width);
    }
    if ((!has_above[0] && !has_above[1]) || (!has_below[0] && !has_below[1]))
      return {};
    if (turns) return {false, part.from, part.from, part.to};
    way.least = std::max(way.least, part.from);
    way.most = std::min(way.most, part.to);
    way.is_none = way.least > way.most;
    if (way.is_none) return way;
    const Vec3<double>& normal = normals_[first + points_.size()];
    const double at_a = Dot(normal, a - centre_);
    const double at_b = Dot(normal, b - centre_);
    way.at = std::clamp(at_a / (at_a - at_b), way.least, way.most);
    return way;
  }

  /// The integral of k over the longer way from where the end is seen from the
  /// centre, without M / pi.
  [[nodiscard]] double EndJump(const LightEdge& edge, const Way& way) const {
    const auto point = [&edge](double share) {
      return Between(edge.ends[0], edge.ends[1], share);
    };
    const double height = std::max(lamp_->plane.HeightOf(point(way.least)),
                                   lamp_->plane.HeightOf(point(way.most)));
    if (height <= 0x1p-40 * features_.size()) return 0;
    return std::max(SweepOf(point(way.least), point(way.at)),
                    SweepOf(point(way.at), point(way.most)));
  }

  /// The integral of k over a piece, without M / pi.
  [[nodiscard]] double SweepOf(const Vec3<double>& a,
                               const Vec3<double>& b) const {
    const double length = LengthOf(b - a);
    const double high = std::max(a.z, b.z);
    if (length == 0 || high <= 0) return 0;
    const double distance = DistanceTo(middle_, a, b) - radius_;
    if (distance <= 0) return HUGE_VAL;
    if (length > kFine * distance) {
      const Vec3<double> middle = Between(a, b, 0.5);
      return SweepOf(a, middle) + SweepOf(middle, b);
    }
    const double height =
        std::max(lamp_->plane.HeightOf(a), lamp_->plane.HeightOf(b));
    const double share = least_height_ > height ? height / least_height_ : 1.0;
    return length * share * high / (distance * distance * distance);
  }

  [[nodiscard]] double PairJump(const LampSight& sight, std::size_t i,
                                std::size_t k) const {
    const LightEdge& one = EdgeOf(sight.edges[i]);
    const LightEdge& other = EdgeOf(sight.edges[k]);
    if (features_.AreCoplanar(one, other)) return 0;
    const Way on_one = WayOn(sight, i, k);
    if (on_one.is_none) return 0;
    const Way on_other = WayOn(sight, k, i);
    if (on_other.is_none) return 0;
    return EndJump(one, on_one) + EndJump(other, on_other);
  }

  const LightFeatures& features_;
  std::span<const PlanPoint> points_;
  Vec3<double> centre_;  ///< from which changes count
  Vec3<double> middle_{0, 0, 0};
  double radius_ = 0;
  const Lamp* lamp_ = nullptr;
  double least_height_ = 0;  ///< of the polygon over the lamp's plane
  double most_height_ = 0;
  double tilt_ = 0;  ///< a of the head
  double lamp_distance_ = 0;
  std::vector<Vec3<double>> normals_;
};

}  // namespace

GradientChange GradientChangeOver(const LightFeatures& features,
                                  const Sight& sight,
                                  std::span<const PlanPoint> points,
                                  const PlanPoint& centre, double give_up) {
  BoundFinder finder(features, points, centre);
  GradientChange change;
  for (const LampSight& lamp : sight) {
    change.rate += kEnlarged * finder.RateOf(lamp);
    if (change.rate * finder.diameter() > give_up) return kUnknownChange;
  }
  for (const LampSight& lamp : sight) {
    change.jump += kEnlarged * finder.JumpOf(lamp, give_up);
    if (change.jump > give_up) return kUnknownChange;
  }
  return change;
}

}  // namespace truelux
