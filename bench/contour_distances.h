// SPDX-License-Identifier: GPL-3.0-or-later
// How far drawn contours are from the true ones.

#ifndef TRUELUX_BENCH_CONTOUR_DISTANCES_H_
#define TRUELUX_BENCH_CONTOUR_DISTANCES_H_

#include <cstddef>
#include <span>
#include <vector>

#include "truelux/geometry.h"
#include "truelux/irradiance.h"
#include "truelux/isolux.h"

#include "isolux_floors.h"

namespace truelux::bench {

/// Numbers in ascending order.
class SortedNumbers {
 public:
  SortedNumbers() = default;
  explicit SortedNumbers(std::vector<double> all);

  /// The number below which this share of them lies, 0 .. 1; 0 if there are
  /// none.
  [[nodiscard]] double At(double share) const;

 private:
  std::vector<double> sorted_;
};

/// A contour as somebody draws it: chords between points.
struct DrawnContour {
  double level = 0;            ///< [W/m^2]
  std::vector<Point3> points;  ///< on the contour, but for what is negligible
  bool is_closed = false;  ///< a chord goes from the last to the first point
};

/// The contours of truelux as they are drawn.
std::vector<DrawnContour> DrawnContoursOf(const Isolux& isolux);

/// Measures in certified irradiance of one floor, in its first channel.
class ContourDistances {
 public:
  /// All must outlive this. oracle: of the floor's scene. isolux: its contours.
  ContourDistances(const IsoluxFloor& floor, const Oracle& oracle,
                   const Isolux& isolux);

  /// Of the middles of some thousands of the chords, evenly chosen [length].
  [[nodiscard]] SortedNumbers OfContours(
      std::span<const DrawnContour> contours) const;

  /// Of the chords of marching squares with so many certified values, one chord
  /// in sixteen [length].
  [[nodiscard]] SortedNumbers OfMarchingSquares(double evaluations) const;

 private:
  /// How far a point is from where E is the level, along the gradient; at most
  /// a hundredth of the size.
  [[nodiscard]] double DistanceAt(const Point3& from, double level) const;

  /// The middle of the chord through a square whose outline crosses twice.
  template <class Value, class At>
  void AddSquare(int x, int y, const Value& value, const At& at, double level,
                 std::size_t& seen, std::vector<double>& all) const;

  const IsoluxFloor& floor_;
  const Oracle& oracle_;
  const Isolux& isolux_;
  Vector3 normal_;
};

}  // namespace truelux::bench

#endif  // TRUELUX_BENCH_CONTOUR_DISTANCES_H_
