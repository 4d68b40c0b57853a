// The vertices and planes of a contour in the receiver's frame, at a working
// precision from which the number types of the formulas are rounded once.

#ifndef TRUELUX_RADIOMETRY_FRAME_GEOMETRY_H_
#define TRUELUX_RADIOMETRY_FRAME_GEOMETRY_H_

#include <vector>

#include "exact/numeric.h"
#include "radiometry/weighted_contour.h"

namespace truelux {

/// The working types: Ball<DoubleDouble> for what is rounded to double-double
/// and less, Multiprecision for itself.
///
/// Frame: orthonormal and right-handed (u, v, n), n the receiver's normal; an
/// axis of the scene if n is one, so that nothing is rounded then. Points are
/// relative to r, all of one source times one power of two.
template <class W>
class FrameGeometry {
 public:
  /// precision [bits]: of Multiprecision; not looked at otherwise. `contour`
  /// must outlive this object.
  FrameGeometry(const WeightedContour& contour, mpfr_prec_t precision);

  /// Direction i of the contour: a scene vertex as it is, any other one as the
  /// point of the source's plane, so that vertices that are near each other
  /// have a short difference. source: index into contour.sources. z is exactly
  /// 0 if OnHorizon(i), and never below.
  [[nodiscard]] Vec3<W> Point(int source, int i) const;

  /// Point(j) - Point(i): without their rounding if both are scene vertices.
  [[nodiscard]] Vec3<W> Between(int source, int i, int j) const;

  /// b - a for scene vertices, scaled as the source's points.
  [[nodiscard]] Vec3<W> Edge(int source, int a, int b) const;

  /// Normal of plane i of the contour, a positive multiple of it; exactly along
  /// z if IsHorizon(i).
  [[nodiscard]] Vec3<W> Plane(int i) const;

  /// Whether direction i lies in the receiver plane, exactly.
  [[nodiscard]] bool OnHorizon(int i) const {
    return on_horizon_[static_cast<std::size_t>(i)];
  }

  /// Whether plane i is the receiver plane, exactly.
  [[nodiscard]] bool IsHorizon(int i) const {
    return is_horizon_[static_cast<std::size_t>(i)];
  }

  /// det(a, b, c) / (|a| |b| |c|) of directions; relatively accurate however
  /// small it is, with its sign, and 0 if it is 0. In the scene's axes, which
  /// are right-handed as the frame is.
  [[nodiscard]] W UnitDeterminant(int a, int b, int c) const;

  [[nodiscard]] const WeightedContour& contour() const { return contour_; }

 private:
  /// Takes a vector of the scene's axes to the frame.
  [[nodiscard]] Vec3<W> ToFrame(const Vec3<W>& v) const;

  /// b - a in the frame, scaled.
  [[nodiscard]] Vec3<W> Scaled(int source, const Point3& a,
                               const Point3& b) const;

  void FindFrame();
  void FindHorizon();
  [[nodiscard]] W OntoPlane(int source, int i) const;

  WeightedContour contour_;
  mpfr_prec_t precision_;
  std::vector<int> exponents_;  ///< a source's points are times 2^-exponent
  int axis_ = -1;               ///< n is +- this axis; -1: n is none
  bool negative_axis_ = false;  ///< the axis' opposite
  Vec3<W> u_;
  Vec3<W> v_;
  Vec3<W> n_;
  std::vector<Vec3<W>> directions_;  ///< in the scene's axes
  std::vector<Vec3<W>> planes_;      ///< in the scene's axes
  std::vector<bool> on_horizon_;
  std::vector<bool> is_horizon_;
};

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_FRAME_GEOMETRY_H_
