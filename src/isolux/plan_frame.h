// SPDX-License-Identifier: GPL-3.0-or-later
// Lengths on one side of a flat surface.

#ifndef TRUELUX_ISOLUX_PLAN_FRAME_H_
#define TRUELUX_ISOLUX_PLAN_FRAME_H_

#include "truelux/geometry.h"
#include "truelux/receiver.h"
#include "truelux/scene.h"

#include "exact/rational.h"
#include "exact/vec3.h"
#include "surface/surface_frame.h"

namespace truelux {

/// A point of a surface, in the scene's unit of length.
struct PlanPoint {
  double s = 0;
  double t = 0;

  friend bool operator==(const PlanPoint&, const PlanPoint&) = default;
};

inline PlanPoint operator+(const PlanPoint& a, const PlanPoint& b) {
  return {a.s + b.s, a.t + b.t};
}

inline PlanPoint operator-(const PlanPoint& a, const PlanPoint& b) {
  return {a.s - b.s, a.t - b.t};
}

inline PlanPoint operator*(double x, const PlanPoint& a) {
  return {x * a.s, x * a.t};
}

inline double Dot(const PlanPoint& a, const PlanPoint& b) {
  return a.s * b.s + a.t * b.t;
}

/// Twice the area that a and b span; positive if b is to the left of a.
inline double Cross(const PlanPoint& a, const PlanPoint& b) {
  return a.s * b.t - a.t * b.s;
}

/// [length]
double LengthOf(const PlanPoint& a);

/// The same, exactly.
struct ExactPlanPoint {
  mpq_class s;
  mpq_class t;
};

/// Coordinates (s, t, z) over one side of a surface: s and t along it, z above
/// it, where the light is. A rotation of the scene, within rounding; where the
/// surface is orthogonal to an axis, s and t are two of x, y, z, or minus them,
/// and nothing is rounded.
class PlanFrame {
 public:
  /// frame: of this scene. is_reverse: the side to which frame.reversed look.
  PlanFrame(const Scene& scene, const SurfaceFrame& frame, bool is_reverse);

  /// A point of the surface, each coordinate rounded a few times.
  [[nodiscard]] Point3 PointAt(const PlanPoint& p) const;

  /// A direction along the surface.
  [[nodiscard]] Vector3 VectorOf(const PlanPoint& v) const;

  /// The receiver at a point of the surface.
  [[nodiscard]] Receiver ReceiverAt(const PlanPoint& p) const;

  /// Coordinates of any point of space, in double.
  [[nodiscard]] Vec3<double> PlaceOf(const Point3& p) const;

  /// Of a point in the plane of the surface, by a map that is exactly affine.
  [[nodiscard]] ExactPlanPoint ExactPlaceOf(const RationalVector& p) const;

  /// The part along the surface of a direction in space.
  [[nodiscard]] PlanPoint Along(const Vector3& v) const;

  /// A direction in space, in these axes.
  [[nodiscard]] Vec3<double> DirectionOf(const Vec3<double>& v) const;

 private:
  Vec3<double> u_;  ///< unit vectors
  Vec3<double> v_;
  Vec3<double> n_;
  Vec3<double> base_;  ///< the point at (0, 0, 0)
  Vector3 normal_;     ///< of receivers
  int on_face_ = 0;    ///< of receivers
};

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_PLAN_FRAME_H_
