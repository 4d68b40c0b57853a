// SPDX-License-Identifier: GPL-3.0-or-later
// A scene as convex polygons: what the contour engine works on.
//
// A facet whose ring is strictly convex and short is one piece, any other facet
// is cut in as few as greed finds. Fewer pieces mean fewer planes, and a quad has
// no diagonal.

#ifndef TRUELUX_SCENE_INDEX_CONVEX_PIECES_H_
#define TRUELUX_SCENE_INDEX_CONVEX_PIECES_H_

#include <span>

#include "truelux/scene.h"

#include "base/disjoint_sets.h"
#include "base/id_vector.h"
#include "base/ids.h"

namespace truelux {

/// A strictly convex planar polygon, counter-clockwise seen from its front.
struct Piece {
  EdgeId first_corner;   ///< its corners are first_corner ..
  int corner_count = 0;  ///< .. first_corner + corner_count - 1
  FacetId facet;
  TriangleId triangle;  ///< a triangle of the facet: carries the plane

  /// The corners, each with the edge that starts there.
  [[nodiscard]] IdRange<EdgeId> edges() const {
    return {first_corner, corner_count};
  }
};

/// The pieces of a scene, and which of their edges are the same.
///
/// A corner has the EdgeId of the edge from there to the piece's next corner.
class ConvexPieces {
 public:
  static constexpr int kMaxCorners = 7;

  /// max_corners: of a piece, 3 .. kMaxCorners; 3 leaves all triangles apart.
  explicit ConvexPieces(const Scene& scene, int max_corners = kMaxCorners);

  [[nodiscard]] IdSpan<PieceId, const Piece> pieces() const { return pieces_; }

  /// The vertex of every corner.
  [[nodiscard]] IdSpan<EdgeId, const VertexId> corners() const {
    return corners_;
  }

  /// The vertices of a piece's corners.
  [[nodiscard]] std::span<const VertexId> CornersOf(const Piece& piece) const {
    return corners_.Part(piece.first_corner, piece.corner_count);
  }

  /// The same, by the piece's id.
  [[nodiscard]] std::span<const VertexId> CornersOf(PieceId piece) const {
    return CornersOf(pieces_[piece]);
  }

  /// The pieces of a facet; they are consecutive.
  [[nodiscard]] IdRange<PieceId> PiecesOf(FacetId facet) const {
    FacetId next = facet;
    ++next;
    return {first_piece_[facet],
            first_piece_[next].value() - first_piece_[facet].value()};
  }

  /// The facet's first piece.
  [[nodiscard]] PieceId FirstPieceOf(FacetId facet) const {
    return first_piece_[facet];
  }

  /// The corner after this one around its piece: where the edge that starts at
  /// this one ends.
  [[nodiscard]] EdgeId NextCorner(EdgeId corner) const {
    const Piece& piece = pieces_[PieceOf(corner)];
    EdgeId next = corner;
    ++next;
    return piece.edges().contains(next) ? next : piece.first_corner;
  }

  /// The next edge between the same two vertices, in either direction; the
  /// edge itself if there is no other. Following it visits all of them and
  /// comes back.
  [[nodiscard]] EdgeId NextSameEdge(EdgeId edge) const {
    return next_same_edge_[edge];
  }

  /// The first of the edges between the same two vertices.
  [[nodiscard]] EdgeId FirstSameEdge(EdgeId edge) const {
    return first_same_edge_[edge];
  }

  /// The first of the facets that are known to lie in exactly the same plane as
  /// this one. (Of facets for which it differs nothing is known: only facets
  /// that are connected by edges are compared.)
  [[nodiscard]] FacetId FirstInPlaneOf(FacetId facet) const {
    return first_in_plane_[facet];
  }

  /// The piece that an edge or corner belongs to.
  [[nodiscard]] PieceId PieceOf(EdgeId corner) const {
    return piece_of_[corner];
  }

 private:
  void AddPiece(std::span<const VertexId> corners, FacetId facet,
                TriangleId triangle);
  void LinkEdges();
  void FindPlanes(const Scene& scene);
  void JoinCoplanar(const Scene& scene, DisjointSets<FacetId>& coplanar) const;

  IdVector<PieceId, Piece> pieces_;
  IdVector<EdgeId, VertexId> corners_;
  IdVector<EdgeId, PieceId> piece_of_;
  IdVector<EdgeId, EdgeId> next_same_edge_;
  IdVector<EdgeId, EdgeId> first_same_edge_;
  IdVector<FacetId, PieceId> first_piece_;  ///< and one more
  IdVector<FacetId, FacetId> first_in_plane_;
};

}  // namespace truelux

#endif  // TRUELUX_SCENE_INDEX_CONVEX_PIECES_H_
