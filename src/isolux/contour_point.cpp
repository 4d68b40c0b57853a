// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/contour_point.h"

#include <algorithm>
#include <cmath>

namespace truelux {
namespace {

constexpr int kMostSteps = 120;
constexpr int kMostNearSteps = 8;

bool InAnyCase(const PlanPoint&) {
  return true;
}

/// Where a parabola through both ends, with a slope in between, has the level;
/// shares of the way. Else where the chord has it.
double FirstGuess(const LevelCrossing& crossing, double level) {
  const PlanPoint way = crossing.above - crossing.below;
  const double rise = crossing.at_above.value - crossing.at_below.value;
  const double want = level - crossing.at_below.value;
  const double chord = want / rise;
  const double square = Dot(way, way);
  const double at = Dot(crossing.hint_at - crossing.below, way) / square;
  const double slope = Dot(crossing.hint, way);
  // f = want: rise x + bend x (x - 1), with f' = slope at `at`.
  const double lever = 2 * at - 1;
  if (std::fabs(lever) < 0.05) return chord;
  const double bend = (slope - rise) / lever;
  if (!(std::fabs(bend) < std::fabs(rise))) return chord;
  double x = chord;
  for (int i = 0; i < 3; ++i) {
    const double f = rise * x + bend * x * (x - 1) - want;
    x -= f / (rise + bend * (2 * x - 1));
  }
  return x > 0 && x < 1 ? x : chord;
}

}  // namespace

// One step of Newton's leaves the square of its own length by the length over
// which the gradient changes.
double ContourPointFinder::GoodStep(double scale) const {
  return std::sqrt(half_width_ * scale) / 4;
}

bool ContourPointFinder::Certify(const ContourPoint& point,
                                 double level) const {
  const PlanPoint step = point.half_width * point.across;
  return probe_.ValueAt(point.at - step).IsBelow(level) &&
         probe_.ValueAt(point.at + step).IsAbove(level);
}

bool ContourPointFinder::CertifyAt(ContourPoint& point, const PlanPoint& along,
                                   double level,
                                   const InRegion& in_region) const {
  point.across = (1 / LengthOf(along)) * along;
  const PlanPoint reach = half_width_ * point.across;
  point.is_certified = in_region(point.at - reach) &&
                       in_region(point.at + reach) && Certify(point, level);
  return point.is_certified;
}

ContourPoint ContourPointFinder::OnCrossing(const LevelCrossing& crossing,
                                            double level,
                                            const InRegion& in_region) const {
  const PlanPoint way = crossing.above - crossing.below;
  const double length = LengthOf(way);
  ContourPoint point;
  point.on = crossing.on;
  point.seam = crossing.seam;
  point.half_width = half_width_;
  double low = 0;
  double high = 1;
  double x = FirstGuess(crossing, level);
  double good = GoodStep(length);
  bool bisects = false;
  for (int step = 0; step < kMostSteps; ++step) {
    if ((high - low) * length <= 2 * half_width_) break;
    const LightSample sample = probe_.SampleAt(crossing.below + x * way);
    if (sample.light.IsBelow(level)) low = std::max(low, x);
    if (sample.light.IsAbove(level)) high = std::min(high, x);
    const double rise = Dot(sample.gradient, way);
    const double next = x + (level - sample.light.value) / rise;
    const double moved = std::fabs(next - x) * length;
    if (!(rise > 0 && next > low && next < high)) {
      x = 0.5 * (low + high);
      continue;
    }
    if (moved <= good) {
      point.at = crossing.below + next * way;
      if (crossing.on == SideKind::kInner &&
          CertifyAt(point, sample.gradient, level, in_region)) {
        return point;
      }
      // Beyond the ends of the segment nothing is known.
      const double room = std::min(next, 1 - next) * length;
      if (room > half_width_ && CertifyAt(point, way, level, InAnyCase))
        return point;
      bisects = bisects || moved <= half_width_ / 16;
      good = moved / 4;
    }
    x = bisects ? 0.5 * (low + high) : next;
  }
  // What is left is the bracket, whose ends were asked or are the segment's.
  point.at = crossing.below + (0.5 * (low + high)) * way;
  point.across = (1 / length) * way;
  point.half_width = 0.5 * (high - low) * length;
  point.is_certified = (low > 0 || crossing.at_below.IsBelow(level)) &&
                       (high < 1 || crossing.at_above.IsAbove(level));
  return point;
}

ContourPoint ContourPointFinder::Near(const PlanPoint& at,
                                      const LightSample& first, double level,
                                      double scale,
                                      const InRegion& in_region) const {
  ContourPoint point;
  point.at = at;
  point.half_width = half_width_;
  LightSample sample = first;
  double good = GoodStep(scale);
  for (int step = 0; step < kMostNearSteps; ++step) {
    const double square = Dot(sample.gradient, sample.gradient);
    if (!sample.is_defined || !(square > 0)) return point;
    const PlanPoint move =
        ((level - sample.light.value) / square) * sample.gradient;
    const double moved = LengthOf(move);
    point.at = point.at + move;
    if (!in_region(point.at)) return point;
    if (moved <= good) {
      if (CertifyAt(point, sample.gradient, level, in_region)) return point;
      good = moved / 4;
    }
    sample = probe_.SampleAt(point.at);
  }
  return point;
}

}  // namespace truelux
