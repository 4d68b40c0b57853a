// SPDX-License-Identifier: GPL-3.0-or-later
// What the arcs of a source add to 2 pi |n| F, as balls: the two closed forms.
//
// Letters: n the scaled receiver normal, whose length is divided out at the
// end; N the normal of an arc's plane, k the axis of a largest component of N;
// d1 and d2 the directions in which an arc begins and ends; beta the angle
// between them, gamma that between n and the side of N that is visible.

#ifndef TRUELUX_RADIOMETRY_STAGES_BALL_TERMS_H_
#define TRUELUX_RADIOMETRY_STAGES_BALL_TERMS_H_

#include <span>

#include "exact/angle_sum.h"
#include "radiometry/stages/ball_geometry.h"

namespace truelux {

/// Whether an arc of this plane from d1 to d2 is a whole scene edge.
template <class T>
inline bool IsWholeEdge(const BallPlane<T>& plane, const BallDirection<T>& d1,
                        const BallDirection<T>& d2) {
  if (!d1.vertex.valid() || !d2.vertex.valid()) return false;
  return (d1.vertex == plane.first_vertex && d2.vertex == plane.last_vertex) ||
         (d1.vertex == plane.last_vertex && d2.vertex == plane.first_vertex);
}

/// |d1 x d2| |N_k| / |N| for the plane's axis k: as d1 x d2 is a multiple of
/// N, that is its component k, and with the visible side >= 0.
template <class T>
inline Ball<T> CrossAlongAxis(const BallPlane<T>& plane,
                              const BallDirection<T>& d1,
                              const BallDirection<T>& d2, bool positive) {
  if (IsWholeEdge(plane, d1, d2)) {
    // (a - r) x (b - r) = (a - r) x (b - a) = +-N, which has a short edge's
    // relative accuracy; undo the three scalings.
    const int exponent =
        plane.normal.exponent - d1.scaled.exponent - d2.scaled.exponent;
    if (exponent >= -800 && exponent <= 800) {
      return Scaled(plane.along_axis, PowerOfTwo(exponent));
    }
  }
  const Ball<T> cross =
      CrossComponent(d1.scaled.vector, d2.scaled.vector, plane.axis);
  return ClampToNonNegative(
      TimesSign(cross, positive ? plane.sign : -plane.sign));
}

/// Adds the angle of an arc, beta = atan2(|d1 x d2|, d1.d2), both operands
/// times |N_k|; subtracts it if the visible side is not that of N.
template <class T>
inline void AddAngle(const BallGeometry<T>& geometry, const BallPlane<T>& plane,
                     const Arc& arc, AngleSum<T>& sum) {
  const BallDirection<T>& d1 = geometry.Direction(arc.from);
  const BallDirection<T>& d2 = geometry.Direction(arc.to);
  const Ball<T> along = Dot(d1.scaled.vector, d2.scaled.vector);
  sum.Add(plane.length * CrossAlongAxis(plane, d1, d2, arc.positive),
          plane.along_axis * along, arc.positive);
}

/// The sum of |n| cos gamma * beta: cos gamma = n.N_v / (|n| |N|), beta the
/// angle of the arc (Lambert; Stark 2000 equation (3), corrected;
/// docs/errors.md section 5). Arcs in one plane that follow each other have
/// one cosine and one arctangent.
template <class T>
Ball<T> LambertTerms(const BallGeometry<T>& geometry,
                     std::span<const Arc> arcs) {
  Ball<T> sum(0.0);
  for (std::size_t i = 0; i < arcs.size();) {
    const PlaneId id = arcs[i].plane;
    const BallPlane<T>& plane = geometry.Plane(id);
    AngleSum<T> angle;
    for (; i < arcs.size() && arcs[i].plane == id; ++i) {
      AddAngle(geometry, plane, arcs[i], angle);
    }
    sum = sum + plane.rise * angle.Sum();
  }
  return sum;
}

/// atan2(d.(n x N), |N| (n.d)): how far d is from the plane's highest point.
/// ascent: n x N.
template <class T>
Ball<T> AngleFromTop(const BallGeometry<T>& geometry, const BallPlane<T>& plane,
                     const BallVector<T>& ascent, const BallVector<T>& d) {
  // n.d >= 0: no visible direction is below the horizon.
  const Ball<T> height = plane.length * Dot(geometry.receiver_normal(), d);
  return AngleInHalfPlane(Dot(d, ascent), ClampToNonNegative(height));
}

/// The same term as a difference over the ends: H(d1, N) - H(d2, N), and for
/// an arc in the receiver plane (`on_horizon`, exact) the last row of Figure
/// 11 (Stark 2000 Figure 11, corrected and frame-free; docs/errors.md section
/// 5).
template <class T>
Ball<T> HomogeneousTerm(const BallGeometry<T>& geometry, const Arc& arc,
                        bool on_horizon) {
  const BallPlane<T>& plane = geometry.Plane(arc.plane);
  const BallDirection<T>& d1 = geometry.Direction(arc.from);
  const BallDirection<T>& d2 = geometry.Direction(arc.to);
  if (!on_horizon) {
    const BallVector<T> ascent =
        Cross(geometry.receiver_normal(), plane.normal.vector);
    return plane.rise *
           (AngleFromTop(geometry, plane, ascent, d1.scaled.vector) -
            AngleFromTop(geometry, plane, ascent, d2.scaled.vector));
  }
  // w = |d1 x d2|; operands times |N_k|.
  const Ball<T>& scale = plane.along_axis;
  const Ball<T> across =
      plane.length * CrossAlongAxis(plane, d1, d2, arc.positive);
  const Ball<T> along = Dot(d1.scaled.vector, d2.scaled.vector);
  const Ball<T> beta =
      AngleInHalfPlane(
          scale * (Dot(d2.scaled.vector, d2.scaled.vector) - along), across) -
      AngleInHalfPlane(
          scale * (along - Dot(d1.scaled.vector, d1.scaled.vector)), across);
  return (arc.positive ? plane.rise : -plane.rise) * beta;
}

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_STAGES_BALL_TERMS_H_
