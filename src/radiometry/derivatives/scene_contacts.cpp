// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/derivatives/scene_contacts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "exact/recipe_evaluator.h"
#include "radiometry/derivatives/coincident_lines.h"
#include "radiometry/derivatives/vertex_numbers.h"
#include "scene/index/box_overlap.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

/// A view of the scene from nowhere in particular: for what does not depend on
/// the receiver.
ReceiverView AnyViewOf(const Scene& scene) {
  return {VerticesOf(scene), TrianglesOf(scene), {}, {}};
}

const Face& FaceOfPiece(const ContourEngine& engine, PieceId piece) {
  return FacesOf(engine.scene())[FaceOf(engine.scene(),
                                        engine.pieces().pieces()[piece].facet)];
}

Box BoxOfFacet(const ContourEngine& engine, FacetId facet) {
  Box box;
  for (const PieceId piece : engine.pieces().PiecesOf(facet)) {
    for (const VertexId corner : engine.pieces().CornersOf(piece))
      box.Include(VerticesOf(engine.scene())[corner]);
  }
  return box;
}

/// Whether b certainly does not lie on a line with a and c, told in double: the
/// differences and products are off by 8 u |b - a| |c - b| together.
bool IsBend(const Point3& a, const Point3& b, const Point3& c) {
  const Vec3<double> first{b.x - a.x, b.y - a.y, b.z - a.z};
  const Vec3<double> second{c.x - b.x, c.y - b.y, c.z - b.z};
  const Vec3<double> across = Cross(first, second);
  const double limit = 0x1p-80 * Dot(first, first) * Dot(second, second);
  return limit > 0x1p-900 && Dot(across, across) > limit;
}

}  // namespace

SceneContacts::SceneContacts(const ContourEngine& engine) {
  FindContacts(engine);
  FindTwins(engine);
  FindStraightCorners(engine);
}

void SceneContacts::FindContacts(const ContourEngine& engine) {
  const ConvexPieces& pieces = engine.pieces();
  const RecipeEvaluator<Exact> exact(AnyViewOf(engine.scene()));
  for (const ContourEngine::Emitter& emitter : engine.emitters()) {
    const FacetId source = emitter.facet;
    const TriangleId own = FirstTriangleOf(FacetsOf(engine.scene())[source]);
    std::vector<PieceId> near;
    {
      const RoundUpward rounding;
      engine.tree().Visit(
          BoxOverlap(BoxOfFacet(engine, source)),
          [&near](int piece) { near.push_back(PieceId(piece)); });
    }
    std::ranges::sort(near);
    for (const PieceId piece : near) {
      const Piece& p = pieces.pieces()[piece];
      if (p.facet == source) continue;
      const auto corners = pieces.CornersOf(p);
      std::vector<bool> is_in;
      for (const VertexId v : corners)
        is_in.push_back(exact.AboveTriangle(own, v).is_zero());
      if (std::ranges::find(is_in, false) == is_in.end()) {
        contacts_[source].push_back({piece, true, {}});
        continue;
      }
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const std::size_t next = (k + 1) % corners.size();
        if (is_in[k] && is_in[next]) {
          contacts_[source].push_back(
              {piece, false, {corners[k], corners[next]}});
        }
      }
    }
  }
}

void SceneContacts::FindTwins(const ContourEngine& engine) {
  const ConvexPieces& pieces = engine.pieces();
  const VertexNumbers numbers(engine.scene());
  for (const PieceId piece : pieces.pieces().ids()) {
    const Face& face = FaceOfPiece(engine, piece);
    for (const EdgeId edge : pieces.pieces()[piece].edges()) {
      const VertexId a = pieces.corners()[edge];
      const VertexId b = pieces.corners()[pieces.NextCorner(edge)];
      for (EdgeId same = pieces.NextSameEdge(edge); same != edge;
           same = pieces.NextSameEdge(same)) {
        const PieceId other = pieces.PieceOf(same);
        const Face& other_face = FaceOfPiece(engine, other);
        if (&other_face == &face) continue;
        const EdgeTwin twin{
            other,
            {numbers.Of(face, a, b), numbers.Of(face, b, a),
             numbers.Of(other_face, a, b), numbers.Of(other_face, b, a)}};
        const bool is_one = twin.numbers[0] == twin.numbers[2] &&
                            twin.numbers[1] == twin.numbers[3];
        if (!is_one) twins_[piece].push_back(twin);
      }
    }
  }
}

void SceneContacts::FindStraightCorners(const ContourEngine& engine) {
  const Scene& scene = engine.scene();
  const auto vertices = VerticesOf(scene);
  const RecipeEvaluator<Exact> exact(AnyViewOf(scene));
  for (const PieceId piece : engine.pieces().pieces().ids()) {
    const Face& face = FaceOfPiece(engine, piece);
    const auto first = static_cast<std::size_t>(face.first_corner);
    const auto n = static_cast<std::size_t>(face.corner_count);
    if (n < 4) continue;
    // The pieces of a face follow each other.
    const PieceId last(piece.value() > 0 ? piece.value() - 1 : 0);
    if (last != piece && &FaceOfPiece(engine, last) == &face) {
      const auto known = straight_.find(last);
      if (known != straight_.end()) straight_[piece] = known->second;
      continue;
    }
    const auto vertex = [&](std::size_t i) {
      return VertexId(scene.corners()[first + i % n]);
    };
    for (std::size_t i = 0; i < n; ++i) {
      const VertexId a = vertex(i);
      const VertexId b = vertex(i + 1);
      const VertexId c = vertex(i + 2);
      if (IsBend(vertices[a], vertices[b], vertices[c]) ||
          !AreParallel(exact.FromVertex(a, b), exact.FromVertex(b, c))) {
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k)
        straight_[piece].push_back(scene.corner_numbers()[first + (i + k) % n]);
    }
  }
}

}  // namespace truelux
