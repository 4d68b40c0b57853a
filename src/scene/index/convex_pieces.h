// SPDX-License-Identifier: GPL-3.0-or-later
// A scene as convex polygons: what the contour engine works on.
//
// A facet whose ring is strictly convex and short is one piece, any other facet
// is cut in as few as greed finds. Fewer pieces mean fewer planes, and a quad has
// no diagonal.

#ifndef TRUELUX_SCENE_INDEX_CONVEX_PIECES_H_
#define TRUELUX_SCENE_INDEX_CONVEX_PIECES_H_

#include <cstddef>
#include <span>
#include <vector>

#include "truelux/scene.h"

namespace truelux {

/// A strictly convex planar polygon, counter-clockwise seen from its front.
struct Piece {
  int first_corner = 0;  ///< its corners are first_corner ..
  int corner_count = 0;  ///< .. first_corner + corner_count - 1
  int facet = 0;         ///< index into Scene::facets()
  int triangle = 0;      ///< a triangle of the facet: carries the plane
};

/// The pieces of a scene, and which of their edges are the same.
///
/// Corner c of piece p, p.first_corner <= c, also names the edge from that
/// corner to the piece's next one.
class ConvexPieces {
 public:
  static constexpr int kMaxCorners = 7;

  /// max_corners: of a piece, 3 .. kMaxCorners; 3 leaves all triangles apart.
  explicit ConvexPieces(const Scene& scene, int max_corners = kMaxCorners);

  [[nodiscard]] std::span<const Piece> pieces() const { return pieces_; }

  /// Vertex index of every corner.
  [[nodiscard]] std::span<const int> corners() const { return corners_; }

  [[nodiscard]] std::span<const int> CornersOf(const Piece& piece) const {
    return corners().subspan(static_cast<std::size_t>(piece.first_corner),
                             static_cast<std::size_t>(piece.corner_count));
  }

  /// The pieces of a facet; they are consecutive.
  [[nodiscard]] std::span<const Piece> PiecesOf(int facet) const {
    const auto f = static_cast<std::size_t>(facet);
    return pieces().subspan(
        static_cast<std::size_t>(first_piece_[f]),
        static_cast<std::size_t>(first_piece_[f + 1] - first_piece_[f]));
  }

  /// Index of the facet's first piece.
  [[nodiscard]] int FirstPieceOf(int facet) const {
    return first_piece_[static_cast<std::size_t>(facet)];
  }

  /// The corner after this one around its piece: where the edge that starts at
  /// this one ends.
  [[nodiscard]] int NextCorner(int corner) const {
    const Piece& piece = pieces_[static_cast<std::size_t>(PieceOf(corner))];
    const int last = piece.first_corner + piece.corner_count - 1;
    return corner == last ? piece.first_corner : corner + 1;
  }

  /// The next edge between the same two vertices, in either direction; the
  /// edge itself if there is no other. Following it visits all of them and
  /// comes back.
  [[nodiscard]] int NextSameEdge(int edge) const {
    return next_same_edge_[static_cast<std::size_t>(edge)];
  }

  /// Two facets with the same number lie in exactly the same plane. (Of those
  /// with different numbers nothing is known: only facets that are connected
  /// by edges are compared.)
  [[nodiscard]] int PlaneNumber(int facet) const {
    return plane_number_[static_cast<std::size_t>(facet)];
  }

  /// The piece that an edge or corner belongs to.
  [[nodiscard]] int PieceOf(int corner) const {
    return piece_of_[static_cast<std::size_t>(corner)];
  }

 private:
  void AddPiece(std::span<const int> corners, int facet, int triangle);
  void LinkEdges();
  void NumberPlanes(const Scene& scene);

  std::vector<Piece> pieces_;
  std::vector<int> corners_;
  std::vector<int> piece_of_;        ///< per corner
  std::vector<int> next_same_edge_;  ///< per corner
  std::vector<int> first_piece_;     ///< per facet, and one more
  std::vector<int> plane_number_;    ///< per facet
};

}  // namespace truelux

#endif  // TRUELUX_SCENE_INDEX_CONVEX_PIECES_H_
