// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/contour_chord.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

namespace truelux {
namespace {

constexpr int kMostDepth = 16;

/// What is to the left of the line through p along d, or on it.
std::vector<PlanPoint> LeftOf(std::span<const PlanPoint> corners,
                              const PlanPoint& p, const PlanPoint& d) {
  std::vector<PlanPoint> left;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const PlanPoint& a = corners[i];
    const PlanPoint& b = corners[(i + 1) % corners.size()];
    const double at_a = Cross(d, a - p);
    const double at_b = Cross(d, b - p);
    if (at_a >= 0) left.push_back(a);
    if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0))
      left.push_back(a + (at_a / (at_a - at_b)) * (b - a));
  }
  return left;
}

PlanPoint LeftTurn(const PlanPoint& v) {
  return {-v.t, v.s};
}

/// The most that the contour is away from the chord; see the head.
double WidthOf(const ChordRegion& region, const ContourPoint& from,
               const ContourPoint& to) {
  const double slope = LengthOf(region.sample.gradient);
  const double change = region.Change();
  if (!(slope > change)) return HUGE_VAL;
  const PlanPoint up = (1 / slope) * region.sample.gradient;
  const PlanPoint way = to.at - from.at;
  const double across = Dot(way, up);
  const double along = std::fabs(Cross(way, up));
  const double steepest =
      change / std::sqrt((slope - change) * (slope + change));
  // The ends are off by their transversals.
  const double ends = std::max(from.half_width, to.half_width);
  if (steepest * along <= std::fabs(across)) return ends;
  return ends + (along * steepest - across * across / (along * steepest)) / 2;
}

}  // namespace

double ChordRegion::Change() const {
  double farthest = 0;
  for (const PlanPoint& corner : corners)
    farthest = std::max(farthest, LengthOf(corner - at));
  return change.Over(farthest) + sample.gradient_bound;
}

ContourPiece ChordDivider::Divide(const ChordRegion& region,
                                  const ContourPoint& from,
                                  const ContourPoint& to, double level) const {
  ContourPiece piece;
  Add(region, from, to, level, 0, piece);
  return piece;
}

void ChordDivider::Add(const ChordRegion& region, const ContourPoint& from,
                       const ContourPoint& to, double level, int depth,
                       ContourPiece& piece) const {
  double width = WidthOf(region, from, to);
  const PlanPoint way = to.at - from.at;
  const double length = LengthOf(way);
  if (width <= longest_ || depth >= kMostDepth || length <= longest_ / 16) {
    piece.widths.push_back(width);
    return;
  }
  // The contour between the ends is in a smaller region.
  ChordRegion part;
  part.corners = region.corners;
  if (std::isfinite(width)) {
    const PlanPoint side = (width / length) * LeftTurn(way);
    part.corners = LeftOf(part.corners, from.at - side, way);
    part.corners = LeftOf(part.corners, from.at + side, -1.0 * way);
    PlanPoint up = region.sample.gradient;
    // `up` is left of the way there or right of it.
    if (Cross(way, up) < 0) up = -1.0 * up;
    part.corners = LeftOf(part.corners, from.at, -1.0 * up);
    part.corners = LeftOf(part.corners, to.at, up);
  }
  if (part.corners.size() < 3) {
    piece.widths.push_back(width);
    return;
  }
  part.at = from.at + 0.5 * way;
  part.sample = probe_.SampleAt(part.at);
  part.sight = std::make_shared<const Sight>(
      Narrowed(features_, *region.sight, part.corners));
  part.change =
      part.sample.is_defined
          ? GradientChangeOver(features_, *part.sight, part.corners, part.at,
                               2 * LengthOf(part.sample.gradient))
          : kUnknownChange;
  const double smaller = WidthOf(part, from, to);
  if (smaller <= longest_) {
    piece.widths.push_back(smaller);
    return;
  }
  width = std::min(width, smaller);
  const auto in_region = [&part](const PlanPoint& p) {
    for (std::size_t i = 0; i < part.corners.size(); ++i) {
      const PlanPoint& a = part.corners[i];
      const PlanPoint& b = part.corners[(i + 1) % part.corners.size()];
      if (Cross(b - a, p - a) < 0) return false;
    }
    return true;
  };
  const ContourPoint middle =
      finder_.Near(part.at, part.sample, level, length, in_region);
  if (!middle.is_certified) {
    piece.widths.push_back(width);
    return;
  }
  Add(part, from, middle, level, depth + 1, piece);
  piece.points.push_back(middle);
  Add(part, middle, to, level, depth + 1, piece);
}

}  // namespace truelux
