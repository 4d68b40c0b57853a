// The visible region of one source at a number type: what formulas sum over.

#ifndef TRUELUX_RADIOMETRY_BOUNDARY_H_
#define TRUELUX_RADIOMETRY_BOUNDARY_H_

#include <cstddef>
#include <vector>

#include "exact/vec3.h"
#include "radiometry/frame_geometry.h"

namespace truelux {

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
  int from = 0;  ///< index into Boundary::vertices
  int to = 0;
  Vec3<T> chord;   ///< to - from
  Vec3<T> edge;    ///< along the arc's line in space, in the sense of travel
  Vec3<T> normal;  ///< of its plane, outwards, any length: a positive multiple
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
  std::vector<BoundaryVertex<T>> vertices;
  std::vector<BoundaryArc<T>> arcs;
  /// -det(first, from, to) / (|first| |from| |to|) for each arc if asked for:
  /// relatively accurate, > 0 where the triangle is counter-clockwise.
  std::vector<T> fan;
  T pi{};  ///< at the precision of the other numbers

  [[nodiscard]] const BoundaryVertex<T>& From(const BoundaryArc<T>& arc) const {
    return vertices[static_cast<std::size_t>(arc.from)];
  }

  [[nodiscard]] const BoundaryVertex<T>& To(const BoundaryArc<T>& arc) const {
    return vertices[static_cast<std::size_t>(arc.to)];
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

/// The boundary of source `source` of a contour. T: float, double,
/// DoubleDouble, Ball<double> or Multiprecision.
template <class T>
Boundary<T> BoundaryOf(
    const FrameGeometry<typename WorkingType<T>::Type>& geometry, int source,
    bool with_fan);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_BOUNDARY_H_
