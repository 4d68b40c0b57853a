// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/derivatives/kink_planes.h"

#include <algorithm>
#include <array>
#include <utility>

#include "exact/recipe_evaluator.h"
#include "scene/near_triangle.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

class Finder {
 public:
  Finder(const ContourEngine& engine, const ContourQuery& query)
      : engine_(engine), query_(query), view_(ViewOf(query)), exact_(view_) {}

  KinkCandidates Find(const SeenLines& seen) {
    for (const PieceId piece : seen.edge_on)
      AddEdgeOn(engine_.pieces().pieces()[piece]);
    for (const LinePair& pair : seen.pairs) {
      if (!pair.is_one) AddPair(pair);
    }
    return std::move(found_);
  }

 private:
  void AddEdgeOn(const Piece& piece) {
    const FaceNumber face = NumberOf(FaceOf(query_.scene, piece.facet));
    const Vec3<Exact> normal = exact_.TriangleNormal(piece.triangle);
    KinkPlane& plane = PlaneWith(normal);
    plane.is_horizon_only = false;
    std::vector<FaceNumber>& faces = plane.faces;
    if (std::ranges::find(faces, face) == faces.end()) faces.push_back(face);
    if (!Touches(piece)) return;
    const bool is_level = AreParallel(normal, exact_.ReceiverNormal());
    if (!found_.touched.valid() || !is_level) {
      found_.touched = face;
      found_.touched_is_level = is_level;
    }
  }

  /// Whether r lies on the facet of a piece.
  [[nodiscard]] bool Touches(const Piece& piece) const {
    const RoundUpward rounding;
    const Facet& facet = FacetsOf(query_.scene)[piece.facet];
    return std::ranges::any_of(
        TrianglesOf(query_.scene, facet), [&](const Triangle& triangle) {
          const auto [a, b, c] = CornersOf(triangle);
          return NearTriangle(
                     {view_.vertices[a], view_.vertices[b], view_.vertices[c]},
                     query_.receiver)
              .IsWithin(0);
        });
  }

  void AddPair(const LinePair& pair) {
    KinkPlane& plane = PlaneWith(pair.normal);
    if (pair.first.kind() == PlaneRecipe::Kind::kHorizon ||
        pair.second.kind() == PlaneRecipe::Kind::kHorizon) {
      return;
    }
    plane.is_horizon_only = false;
    if (plane.edges[0][0].valid()) return;
    plane.edges = {EndsOf(pair.first), EndsOf(pair.second)};
  }

  static std::array<VertexId, 2> EndsOf(const PlaneRecipe& plane) {
    if (plane.kind() != PlaneRecipe::Kind::kEdge) return {};
    return {plane.from(), plane.to()};
  }

  KinkPlane& PlaneWith(const Vec3<Exact>& normal) {
    for (KinkPlane& plane : found_.planes) {
      if (AreParallel(plane.normal, normal)) return plane;
    }
    KinkPlane& plane = found_.planes.emplace_back();
    plane.normal = Canonical(normal);
    plane.is_level = AreParallel(normal, exact_.ReceiverNormal());
    return plane;
  }

  const ContourEngine& engine_;
  const ContourQuery& query_;
  ReceiverView view_;
  RecipeEvaluator<Exact> exact_;
  KinkCandidates found_;
};

}  // namespace

KinkCandidates FindKinkPlanes(const ContourEngine& engine,
                              const ContourQuery& query,
                              const SeenLines& seen) {
  return Finder(engine, query).Find(seen);
}

}  // namespace truelux
