// SPDX-License-Identifier: GPL-3.0-or-later
// Pointed convex cones with apex r: a piece of the scene as seen from the
// receiver, or the part of it above the horizon or in front of a source's
// plane.
//
// Notation, in this folder as in docs/method.md:
//   r, n     the receiver's position and normal
//   d, u, v  directions from r, of any length; an edge runs from u to v
//   N        normal of a plane through r; the plane's positive side: N . d > 0
//   h        h_t = N_t . (t0 - r), < 0 where r is in front of triangle t
//   S        the source
//   face     a polygon of the scene, with a number; emits and hides
//   facet    what of a face lies in one plane (one facet, if it is planar)
//   piece    a convex polygon: a facet or some of it (scene/index)
//   cone     a piece, or some of it, as seen from r
//   part     a cone whose edges have numbers as candidates

#ifndef TRUELUX_VISIBILITY_EDGES_CONE_H_
#define TRUELUX_VISIBILITY_EDGES_CONE_H_

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "base/id_vector.h"
#include "base/ids.h"
#include "base/stamped_table.h"
#include "exact/cached_sign.h"
#include "exact/view_geometry.h"
#include "scene/index/convex_pieces.h"

namespace truelux {

/// The edge of a cone that is no edge of the scene: a cut or a horizon edge.
inline constexpr EdgeId kNoEdge;

/// A closed pointed cone, counter-clockwise from r: edge k runs from direction
/// k to direction k + 1 in plane k, whose normal points inwards and is a
/// positive multiple of direction k x direction k + 1.
struct Cone {
  static constexpr std::size_t kMaxEdges = ConvexPieces::kMaxCorners + 1;

  PieceId piece;
  std::size_t size = 0;
  std::array<ViewDirectionId, kMaxEdges> directions;
  /// Those of scene edges are none until ConeMaker::Complete.
  std::array<ViewPlaneId, kMaxEdges> planes;
  BundleId bundle;  ///< of the planes, in their order; likewise
  std::array<EdgeId, kMaxEdges> edges;  ///< of ConvexPieces, or kNoEdge

  /// Direction where edge k begins.
  [[nodiscard]] ViewDirectionId From(std::size_t k) const {
    return directions[k];
  }

  /// Direction where edge k ends.
  [[nodiscard]] ViewDirectionId To(std::size_t k) const {
    return directions[k + 1 < size ? k + 1 : 0];
  }
};

/// The signs of some function at the corners of a piece, in the piece's order;
/// zero in the places of an array that the piece has no corners for.
using CornerSigns = std::array<Sign, ConvexPieces::kMaxCorners>;

/// Makes cones, and keeps what belongs to a piece for one receiver.
template <class Geometry>
class ConeMaker {
 public:
  /// The arguments must outlive the object.
  ConeMaker(Geometry& geometry, const ConvexPieces& pieces);

  /// Starts with the receiver that the geometry has just been given.
  /// whole_sphere: all vertices count as above the receiver plane.
  void SetReceiver(bool whole_sphere = false);

  /// Sign of h_t of the piece's plane, asked once per piece.
  Sign ReceiverSide(PieceId piece);

  /// The cone of a whole piece. Requires ReceiverSide != zero.
  Cone Whole(PieceId piece);

  /// The part of a piece in n . d >= 0; nothing if no point has n . d > 0.
  /// Requires ReceiverSide != zero.
  std::optional<Cone> AboveHorizon(PieceId piece);

  /// The part of a piece strictly in front of the plane of triangle `source`,
  /// given the signs of VertexSide(source, .) at its corners, of which some
  /// are positive and some negative. Requires ReceiverSide != zero.
  Cone InFrontOf(TriangleId source, PieceId piece, const CornerSigns& sides);

  /// Makes a cone's planes and their bundle, if that has not been done.
  void Complete(Cone& cone) {
    if (!cone.bundle.valid()) MakePlanes(cone);
  }

  /// The plane of a scene edge, normal towards its piece.
  ViewPlaneId EdgePlane(EdgeId edge);

  /// Id of the plane n . d = 0.
  [[nodiscard]] ViewPlaneId horizon() const { return horizon_; }

  /// Sign of n . d for the direction to a scene vertex, asked once.
  Sign HorizonSide(VertexId vertex);

 private:
  void MakePlanes(Cone& cone);

  template <class MakeCrossing>
  Cone Clip(PieceId piece, const CornerSigns& sides, ViewPlaneId cut,
            const MakeCrossing& crossing);

  Geometry& geometry_;
  const ConvexPieces& pieces_;
  ViewPlaneId horizon_;
  bool whole_sphere_ = false;
  StampedTable<Sign, PieceId> receiver_sides_;
  StampedTable<ViewPlaneId, EdgeId> edge_planes_;
  IdVector<ViewDirectionId, CachedSign> horizon_side_;
};

/// Whether all directions of `inner` lie in the closed `outer`, which is
/// complete.
template <class Geometry>
bool Contains(Geometry& geometry, const Cone& outer, const Cone& inner) {
  BundleSides sides;
  for (std::size_t d = 0; d < inner.size; ++d) {
    geometry.FilterSides(outer.bundle, inner.directions[d], sides);
    if (sides.negative != 0) return false;
    geometry.CompleteSides(outer.bundle, inner.directions[d], sides);
    if (sides.negative != 0) return false;
  }
  return true;
}

extern template class ConeMaker<ViewGeometry>;
extern template class ConeMaker<UnfilteredViewGeometry>;
extern template class ConeMaker<DisplacedViewGeometry>;

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_EDGES_CONE_H_
