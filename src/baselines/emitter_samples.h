// SPDX-License-Identifier: GPL-3.0-or-later
// Points on the emitting faces of a scene, for estimators that average.

#ifndef TRUELUX_BASELINES_EMITTER_SAMPLES_H_
#define TRUELUX_BASELINES_EMITTER_SAMPLES_H_

#include <array>
#include <cstdint>
#include <vector>

#include "truelux/geometry.h"
#include "truelux/scene.h"

namespace truelux {

/// kSobol: the first points of Sobol's sequence with a random digital shift,
/// in the sequence's order. kRowOrdered: one jittered point in each cell of a
/// square grid, row by row, so that neighbours in the list are neighbours on
/// the emitter. kRandom: points that know nothing of each other.
enum class SamplePattern { kSobol, kRowOrdered, kRandom };

/// A point of the unit square.
using SquarePoint = std::array<double, 2>;

/// `count` points; the same for the same arguments on every machine. count:
/// >= 1, and for kRowOrdered a square number (std::invalid_argument otherwise).
std::vector<SquarePoint> SquareSamples(SamplePattern pattern, int count,
                                       std::uint64_t seed);

/// Uniformly over the area of all emitting faces.
struct EmitterSamples {
  struct Point {
    std::array<float, 3> position{};  ///< [scene length unit]
    int piece = 0;                    ///< index into `pieces`
  };

  /// A parallelogram or triangle that emits.
  struct Piece {
    std::array<float, 3> normal{};  ///< unit length, to the front
    Rgb exitance{};                 ///< M [W/m^2]
  };

  SamplePattern pattern = SamplePattern::kSobol;
  double area = 0;  ///< of all emitting faces [scene length unit squared]
  std::vector<Piece> pieces;
  std::vector<Point> points;
};

/// SquareSamples carried to the emitters: the first coordinate chooses the
/// piece, in proportion to its area. No emitter: no points.
EmitterSamples SampleEmitters(const Scene& scene, SamplePattern pattern,
                              int count, std::uint64_t seed);

}  // namespace truelux

#endif  // TRUELUX_BASELINES_EMITTER_SAMPLES_H_
