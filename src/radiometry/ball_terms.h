// What one arc adds to 2 pi F, as a ball: the two closed forms.

#ifndef TRUELUX_RADIOMETRY_BALL_TERMS_H_
#define TRUELUX_RADIOMETRY_BALL_TERMS_H_

#include "radiometry/ball_geometry.h"

namespace truelux {

/// |d1 x d2|, from t = (d1 x d2).N_v >= 0, N_v towards the visible side.
template <class T>
Ball<T> CrossLength(const BallGeometry<T>& geometry, const Arc& arc) {
  if (const auto whole = geometry.CrossOfWholeEdge(arc)) return *whole;
  const BallPlane<T>& plane = geometry.Plane(arc.plane);
  const Ball<T> t =
      Determinant(geometry.Direction(arc.from), geometry.Direction(arc.to),
                  plane.normal.vector);
  return ClampToNonNegative((arc.positive ? t : -t) / plane.length);
}

/// cos gamma * beta: cos gamma = n.N_v / (|n| |N|), beta the angle of the arc
/// (Lambert; Stark 2000 equation (3), corrected; docs/errors.md section 5).
template <class T>
Ball<T> LambertTerm(const BallGeometry<T>& geometry, const Arc& arc) {
  const Ball<T> beta = AngleInHalfPlane(
      CrossLength(geometry, arc),
      Dot(geometry.Direction(arc.from), geometry.Direction(arc.to)));
  const Ball<T>& cosine = geometry.Plane(arc.plane).cosine;
  return (arc.positive ? cosine : -cosine) * beta;
}

/// atan2(d.(n x N), |N| (n.d)): how far d is from the plane's highest point.
template <class T>
Ball<T> AngleFromTop(const BallGeometry<T>& geometry, const BallPlane<T>& plane,
                     const Vec3<Ball<T>>& d) {
  // n.d >= 0: no visible direction is below the horizon.
  const Ball<T> height =
      plane.length * Dot(geometry.receiver_normal().vector, d);
  return AngleInHalfPlane(Dot(d, plane.ascent), ClampToNonNegative(height));
}

/// The same term as a difference over the ends: H(d1, N) - H(d2, N), and for
/// an arc in the receiver plane (`on_horizon`, exact) the last row of Figure
/// 11 (Stark 2000 Figure 11, corrected and frame-free; docs/errors.md section
/// 5).
template <class T>
Ball<T> HomogeneousTerm(const BallGeometry<T>& geometry, const Arc& arc,
                        bool on_horizon) {
  const BallPlane<T>& plane = geometry.Plane(arc.plane);
  const Vec3<Ball<T>>& d1 = geometry.Direction(arc.from);
  const Vec3<Ball<T>>& d2 = geometry.Direction(arc.to);
  if (!on_horizon) {
    return plane.cosine * (AngleFromTop(geometry, plane, d1) -
                           AngleFromTop(geometry, plane, d2));
  }
  const Ball<T> across = CrossLength(geometry, arc);
  const Ball<T> along = Dot(d1, d2);
  const Ball<T> beta = AngleInHalfPlane(Dot(d2, d2) - along, across) -
                       AngleInHalfPlane(along - Dot(d1, d1), across);
  // N || n exactly: the cosine is 1 or -1, only its sign is needed.
  if (!(plane.cosine.error < 0.5)) return Unbounded<T>();
  const bool upward = (Leading(plane.cosine.value) > 0) == arc.positive;
  return upward ? beta : -beta;
}

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_BALL_TERMS_H_
