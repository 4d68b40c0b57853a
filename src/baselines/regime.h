// SPDX-License-Identifier: GPL-3.0-or-later
// A family of random cases with one difficulty of a known size.

#ifndef TRUELUX_BASELINES_REGIME_H_
#define TRUELUX_BASELINES_REGIME_H_

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "truelux/geometry.h"
#include "truelux/receiver.h"
#include "truelux/scene.h"

#include "baselines/case_random.h"

namespace truelux {

/// One receiver and what it sees. Either `loop` or `scene` is empty.
struct RegimeCase {
  /// Occluded regimes: triangles only, so that every face is one facet; one of
  /// them emits {1, 1, 1}, the others are black.
  Scene scene;
  Receiver receiver;
  /// Unoccluded regimes: 3 to 6 points, counter-clockwise seen from the
  /// receiver, strictly above its horizon; seen from there the loop is simple
  /// and E / M is what it bounds. The points are on one plane only up to
  /// rounding, or not at all ("wide", "at 1e-12"), so that the loop is taken as
  /// a contour: as a face it would be split into several sources.
  std::vector<Point3> loop;
};

/// A family of cases.
///
/// Unoccluded ones have the receiver at the origin with the normal (0, 0, 1),
/// except "far ...", which have it anywhere. A name holds no comma. Numbers in
/// names are radians where they are sizes or elevations, and relative to the
/// distance of the source where they are distances.
struct Regime {
  std::string name;
  bool occluded = false;  ///< cases have a scene, not a loop
  std::function<RegimeCase(CaseRandom&)> draw;

  /// Case `index` of a seed; the same bits whatever was made before. Regimes
  /// that differ in the size of their difficulty only draw the same numbers,
  /// so that cases of one index resemble each other.
  [[nodiscard]] RegimeCase Make(std::uint64_t seed, std::uint64_t index) const;
};

}  // namespace truelux

#endif  // TRUELUX_BASELINES_REGIME_H_
