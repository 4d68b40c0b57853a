// SPDX-License-Identifier: GPL-3.0-or-later
// What cones do along one edge: the interval of the edge inside each cone, and
// on which side. Notation: cone.h; the edge's plane has the normal N.

#ifndef TRUELUX_VISIBILITY_EDGES_COVERAGE_H_
#define TRUELUX_VISIBILITY_EDGES_COVERAGE_H_

#include <cstddef>

#include "exact/view_geometry.h"
#include "visibility/edges/cone.h"

namespace truelux {

/// An edge through the view: the arc from one direction to another, in a
/// plane whose normal is a positive multiple of from x to.
struct ViewEdge {
  ViewPlaneId plane;
  ViewDirectionId from;
  ViewDirectionId to;
};

/// A position on a ViewEdge: a crossing strictly between its ends, or an end.
using EdgePosition = Crossing;

/// Stand for the plane of a position that is an end; neither is valid().
inline constexpr ViewPlaneId kFromEnd(-2);
inline constexpr ViewPlaneId kToEnd(-1);

inline constexpr EdgePosition kEdgeFrom{kFromEnd, Sign::kZero, 0, 0};
inline constexpr EdgePosition kEdgeTo{kToEnd, Sign::kZero, 1, 0};

/// The open interval of an edge inside a cone.
struct Cover {
  EdgePosition begin = kEdgeFrom;
  EdgePosition end = kEdgeTo;
  /// kZero: the cone lies on both sides of the edge. Otherwise one of the
  /// cone's planes is the edge's plane, and the cone lies only on the side
  /// N . d > 0 (kPositive) or N . d < 0 (kNegative).
  Sign side = Sign::kZero;
  std::size_t coincident = 0;  ///< if side is not kZero: which edge of the cone

  [[nodiscard]] bool Whole() const {
    return begin.plane == kFromEnd && end.plane == kToEnd;
  }
};

/// Order of two positions on an edge; kNegative: a comes first. Exact.
template <class Geometry>
Sign ComparePositions(Geometry& geometry, const ViewEdge& edge,
                      const EdgePosition& a, const EdgePosition& b) {
  if (a.plane.valid() && b.plane.valid())
    return geometry.EdgeOrder(edge.plane, a, b);
  if (a.plane == b.plane) return Sign::kZero;
  const bool a_first = a.plane == kFromEnd || b.plane == kToEnd;
  return a_first ? Sign::kNegative : Sign::kPositive;
}

/// Finds the part of an edge inside a complete cone; false if it is empty.
/// Exact. A cone that touches the edge only from one side, along one of its
/// own edges, covers that side (method.md, section 4).
template <class Geometry>
bool CoverOf(Geometry& geometry, const ViewEdge& edge, const Cone& cone,
             Cover& cover);

/// The same, given the sides of the edge's ends to the cone's bundle.
template <class Geometry>
bool CoverOf(Geometry& geometry, const ViewEdge& edge, const Cone& cone,
             BundleSides& from, BundleSides& to, Cover& cover);

/// A piece of an edge of which exactly one side is visible.
struct VisiblePiece {
  EdgePosition begin;
  EdgePosition end;
  bool positive = true;  ///< the visible side is N . d > 0
};

extern template bool CoverOf(ViewGeometry&, const ViewEdge&, const Cone&,
                             Cover&);
extern template bool CoverOf(UnfilteredViewGeometry&, const ViewEdge&,
                             const Cone&, Cover&);
extern template bool CoverOf(DisplacedViewGeometry&, const ViewEdge&,
                             const Cone&, Cover&);
extern template bool CoverOf(ViewGeometry&, const ViewEdge&, const Cone&,
                             BundleSides&, BundleSides&, Cover&);
extern template bool CoverOf(UnfilteredViewGeometry&, const ViewEdge&,
                             const Cone&, BundleSides&, BundleSides&, Cover&);
extern template bool CoverOf(DisplacedViewGeometry&, const ViewEdge&,
                             const Cone&, BundleSides&, BundleSides&, Cover&);

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_EDGES_COVERAGE_H_
