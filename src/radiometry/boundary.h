// SPDX-License-Identifier: GPL-3.0-or-later
// The visible region of one source at a number type: what formulas sum over.
//
// Letters: r the receiver; T the number type of a formula, W the working type
// that it is rounded from; x, y, z the axes of the receiver's frame.

#ifndef TRUELUX_RADIOMETRY_BOUNDARY_H_
#define TRUELUX_RADIOMETRY_BOUNDARY_H_

#include <vector>

#include "base/id_vector.h"
#include "base/ids.h"
#include "exact/vec3.h"
#include "radiometry/frame_geometry.h"

namespace truelux {

/// Index into Boundary::vertices.
using BoundaryVertexId = Id<struct BoundaryVertexTag>;

/// A vertex of the region. Frame: orthonormal and right-handed, r its origin,
/// z along the receiver's normal.
template <class T>
struct BoundaryVertex {
  Vec3<T> point;            ///< z >= 0; any unit of length
  Vec3<T> from_first;       ///< point - the first vertex' point
  bool on_horizon = false;  ///< z is exactly 0
};

/// An arc, run through counter-clockwise as seen from r: the region is on its
/// left for a viewer at r who looks out.
template <class T>
struct BoundaryArc {
  BoundaryVertexId from;
  BoundaryVertexId to;
  Vec3<T> chord{};  ///< to - from
  Vec3<T> edge{};   ///< along the arc's line in space, in the sense of travel
  Vec3<T>
      normal{};  ///< of its plane, outwards, any length: a positive multiple
                 ///< of from x to; (0, 0, z) if on_horizon, z's sign certain
  bool on_horizon = false;  ///< lies in the receiver plane
};

/// All arcs of one source. They bound its visible region completely, in any
/// order; vertices at the same place may have several entries.
///
/// Everything is correctly rounded to T, or nearly so (a Ball's bound holds the
/// rest), but for products: `normal` of a whole edge is from x chord in T.
template <class T>
struct Boundary {
  IdVector<BoundaryVertexId, BoundaryVertex<T>> vertices;
  std::vector<BoundaryArc<T>> arcs;
  /// -det(first, from, to) / (|first| |from| |to|) for each arc if asked for:
  /// relatively accurate, > 0 where the triangle is counter-clockwise.
  std::vector<T> fan;
  T pi{};  ///< at the precision of the other numbers

  /// The vertex at which an arc begins.
  [[nodiscard]] const BoundaryVertex<T>& From(const BoundaryArc<T>& arc) const {
    return vertices[arc.from];
  }

  /// The vertex at which an arc ends.
  [[nodiscard]] const BoundaryVertex<T>& To(const BoundaryArc<T>& arc) const {
    return vertices[arc.to];
  }
};

/// The working type that T is rounded from.
template <class T>
struct WorkingType {
  using Type = Ball<DoubleDouble>;
};

template <>
struct WorkingType<Multiprecision> {
  using Type = Multiprecision;
};

/// The boundary of one source of a contour. T: float, double,
/// DoubleDouble, Ball<double> or Multiprecision.
template <class T>
Boundary<T> BoundaryOf(
    const FrameGeometry<typename WorkingType<T>::Type>& geometry,
    SourceId source, bool with_fan);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_BOUNDARY_H_
