// SPDX-License-Identifier: GPL-3.0-or-later
// Which edges of a scene are inner from a receiver: with exact numbers, edge by
// edge.

#ifndef TRUELUX_TESTS_SCENE_INDEX_SILHOUETTE_TWIN_H_
#define TRUELUX_TESTS_SCENE_INDEX_SILHOUETTE_TWIN_H_

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "truelux/geometry.h"
#include "truelux/scene.h"

#include "base/id_vector.h"
#include "base/ids.h"
#include "exact/sign.h"
#include "exact/vec3.h"
#include "scene/index/box.h"
#include "scene/index/convex_pieces.h"
#include "scene/index/hull_twin.h"
#include "scene/scene_access.h"

namespace truelux::testing {

/// Whether an edge is the first of those between its vertices.
inline bool IsFirst(const ConvexPieces& pieces, EdgeId edge) {
  for (EdgeId e = pieces.NextSameEdge(edge); e != edge;
       e = pieces.NextSameEdge(e)) {
    if (e < edge) return false;
  }
  return true;
}

/// The only other piece of an edge, if it runs through it in the opposite
/// direction.
inline PieceId OnlyOtherPiece(const ConvexPieces& pieces, EdgeId edge) {
  const EdgeId other = pieces.NextSameEdge(edge);
  if (other == edge || pieces.NextSameEdge(other) != edge ||
      pieces.corners()[other] == pieces.corners()[edge]) {
    return {};
  }
  return pieces.PieceOf(other);
}

inline Box BoxOf(const Scene& scene, const ConvexPieces& pieces, EdgeId edge) {
  const auto vertices = VerticesOf(scene);
  Box box = Box::Of(vertices[pieces.corners()[edge]]);
  box.Include(vertices[pieces.corners()[pieces.NextCorner(edge)]]);
  return box;
}

/// The sides of all pieces that a receiver sees.
inline IdVector<PieceId, Sign> SidesSeen(const Scene& scene,
                                         const ConvexPieces& pieces,
                                         const Point3& receiver) {
  IdVector<PieceId, Sign> sides;
  const ExactPoint r = ToExact(receiver);
  for (const Piece& piece : pieces.pieces()) {
    const Triangle& t = TrianglesOf(scene)[piece.triangle];
    const auto corner = [&](std::size_t k) {
      return ToExact(scene.vertices()[static_cast<std::size_t>(t.vertices[k])]);
    };
    sides.push_back(
        SignOf(Determinant(corner(0) - r, corner(1) - r, corner(2) - r)));
  }
  return sides;
}

/// The first edges of the scene that are not inner from one of the receivers.
inline std::vector<EdgeId> NotInner(const Scene& scene,
                                    const ConvexPieces& pieces,
                                    std::span<const Point3> receivers) {
  std::vector<IdVector<PieceId, Sign>> sides;
  for (const Point3& r : receivers)
    sides.push_back(SidesSeen(scene, pieces, r));
  std::vector<EdgeId> edges;
  for (const EdgeId edge : pieces.corners().ids()) {
    if (!IsFirst(pieces, edge)) continue;
    const PieceId piece = pieces.PieceOf(edge);
    const PieceId other = OnlyOtherPiece(pieces, edge);
    const bool is_inner =
        other.valid() && std::ranges::all_of(sides, [&](const auto& of) {
          return of[piece] != Sign::kZero && of[piece] == of[other];
        });
    if (!is_inner) edges.push_back(edge);
  }
  return edges;
}

/// How many edges that can be inner from somewhere a scene has.
inline std::size_t CountPaired(const ConvexPieces& pieces) {
  std::size_t count = 0;
  for (const EdgeId edge : pieces.corners().ids()) {
    if (IsFirst(pieces, edge) && OnlyOtherPiece(pieces, edge).valid()) ++count;
  }
  return count;
}

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_SCENE_INDEX_SILHOUETTE_TWIN_H_
