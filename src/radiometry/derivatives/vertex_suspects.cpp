// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/derivatives/vertex_suspects.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "exact/recipe_evaluator.h"
#include "radiometry/derivatives/vertex_numbers.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

class Finder {
 public:
  Finder(const ContourEngine& engine, const ContourQuery& query,
         const SeenLines& seen)
      : pieces_(engine.pieces()),
        query_(query),
        seen_(seen),
        view_(ViewOf(query)),
        exact_(view_),
        numbers_(query.scene) {}

  std::set<int> Find() {
    for (const PieceId piece : seen_.edge_on)
      AddFaceOf(piece);
    AddPairs();
    AddEdgesOfSeveralNumbers();
    for (const FacetId source : seen_.sources)
      AddNeighbours(source);
    AddStraightCorners();
    return std::move(found_);
  }

 private:
  [[nodiscard]] const Face& FaceOfPiece(PieceId piece) const {
    return FacesOf(
        query_.scene)[FaceOf(query_.scene, pieces_.pieces()[piece].facet)];
  }

  [[nodiscard]] std::span<const int> NumbersOf(const Face& face) const {
    return query_.scene.corner_numbers().subspan(
        static_cast<std::size_t>(face.first_corner),
        static_cast<std::size_t>(face.corner_count));
  }

  void AddFace(const Face& face) {
    for (const int number : NumbersOf(face))
      found_.insert(number);
  }

  void AddFaceOf(PieceId piece) { AddFace(FaceOfPiece(piece)); }

  /// All numbers that a vertex has in the faces around.
  void AddVertex(VertexId vertex) { wanted_.insert(vertex); }

  void AddLine(const PlaneRecipe& plane) {
    if (plane.kind() == PlaneRecipe::Kind::kEdge) {
      AddVertex(plane.from());
      AddVertex(plane.to());
    } else if (plane.kind() == PlaneRecipe::Kind::kCut) {
      for (const TriangleId t :
           {plane.first_triangle(), plane.second_triangle()}) {
        AddFace(FacesOf(
            query_.scene)[FaceOf(query_.scene, FacetOf(view_.triangles[t]))]);
      }
    }
  }

  void AddPairs() {
    for (const LinePair& pair : seen_.pairs) {
      const bool has_horizon =
          pair.first.kind() == PlaneRecipe::Kind::kHorizon ||
          pair.second.kind() == PlaneRecipe::Kind::kHorizon;
      if (has_horizon) continue;
      AddLine(pair.first);
      AddLine(pair.second);
    }
    for (const PieceId piece : seen_.pieces) {
      for (const VertexId vertex : pieces_.CornersOf(piece)) {
        if (wanted_.contains(vertex))
          found_.insert(numbers_.Of(FaceOfPiece(piece), vertex, VertexId()));
      }
    }
  }

  /// Edges of several faces that are one in space, but have ends of their own.
  void AddEdgesOfSeveralNumbers() {
    std::map<std::pair<VertexId, VertexId>, std::pair<int, int>> numbers_of;
    for (const PieceId piece : seen_.pieces) {
      const Face& face = FaceOfPiece(piece);
      for (const EdgeId edge : pieces_.pieces()[piece].edges()) {
        VertexId a = pieces_.corners()[edge];
        VertexId b = pieces_.corners()[pieces_.NextCorner(edge)];
        if (b < a) std::swap(a, b);
        const std::pair numbers = {numbers_.Of(face, a, b),
                                   numbers_.Of(face, b, a)};
        const auto [entry, is_new] = numbers_of.try_emplace({a, b}, numbers);
        if (is_new || entry->second == numbers) continue;
        for (const auto& [first, second] : {numbers, entry->second}) {
          found_.insert(first);
          found_.insert(second);
        }
      }
    }
  }

  /// The directions to the corners of a piece, counter-clockwise as seen.
  [[nodiscard]] std::vector<Vec3<Exact>> ConeOf(PieceId piece) const {
    std::vector<Vec3<Exact>> cone;
    for (const VertexId vertex : pieces_.CornersOf(piece))
      cone.push_back(exact_.FromReceiver(vertex));
    if (SignOf(exact_.Height(pieces_.pieces()[piece].triangle)) ==
        Sign::kNegative) {
      std::ranges::reverse(cone);
    }
    return cone;
  }

  /// Whether some side of a cone has all directions on its outer side, or on
  /// it if `closed` says so.
  static bool AreApart(const std::vector<Vec3<Exact>>& cone,
                       std::span<const Vec3<Exact>> directions, bool closed) {
    for (std::size_t k = 0; k < cone.size(); ++k) {
      const Vec3<Exact> side = Cross(cone[k], cone[(k + 1) % cone.size()]);
      if (std::ranges::all_of(directions, [&](const Vec3<Exact>& d) {
            const Sign sign = SignOf(Dot(side, d));
            return sign == Sign::kNegative || (closed && sign == Sign::kZero);
          })) {
        return true;
      }
    }
    return false;
  }

  /// Faces that overlap a source in its plane, or stand on it.
  void AddNeighbours(FacetId source) {
    const TriangleId own = FirstTriangleOf(FacetsOf(query_.scene)[source]);
    for (const PieceId piece : seen_.pieces) {
      const Piece& p = pieces_.pieces()[piece];
      if (p.facet == source) continue;
      const auto corners = pieces_.CornersOf(p);
      std::vector<bool> is_in;
      for (const VertexId v : corners)
        is_in.push_back(exact_.AboveTriangle(own, v).is_zero());
      const bool is_coplanar = std::ranges::all_of(is_in, std::identity());
      for (std::size_t k = 0; k < corners.size() && !is_coplanar; ++k) {
        const std::size_t next = (k + 1) % corners.size();
        if (is_in[k] && is_in[next])
          AddContact(source, piece, {corners[k], corners[next]});
      }
      if (is_coplanar) AddOverlap(source, piece);
    }
  }

  void AddContact(FacetId source, PieceId piece,
                  const std::array<VertexId, 2>& edge) {
    const std::array<Vec3<Exact>, 2> ends = {exact_.FromReceiver(edge[0]),
                                             exact_.FromReceiver(edge[1])};
    for (const PieceId part : pieces_.PiecesOf(source)) {
      if (AreApart(ConeOf(part), ends, false)) continue;
      AddFaceOf(part);
      const Face& face = FaceOfPiece(piece);
      found_.insert(numbers_.Of(face, edge[0], edge[1]));
      found_.insert(numbers_.Of(face, edge[1], edge[0]));
    }
  }

  void AddOverlap(FacetId source, PieceId piece) {
    const std::vector<Vec3<Exact>> cone = ConeOf(piece);
    for (const PieceId part : pieces_.PiecesOf(source)) {
      const std::vector<Vec3<Exact>> own = ConeOf(part);
      if (AreApart(own, cone, true) || AreApart(cone, own, true)) continue;
      AddFaceOf(part);
      AddFaceOf(piece);
    }
  }

  /// A displaced corner of 180 degrees makes a sliver of any tilt.
  void AddStraightCorners() {
    for (const PieceId piece : seen_.pieces) {
      const Face& face = FaceOfPiece(piece);
      const std::span<const int> numbers = NumbersOf(face);
      const std::size_t n = numbers.size();
      if (n < 4) continue;
      const auto vertex = [&](std::size_t i) {
        return VertexId(
            query_.scene.corners()[static_cast<std::size_t>(face.first_corner) +
                                   i % n]);
      };
      for (std::size_t i = 0; i < n; ++i) {
        if (!AreParallel(exact_.FromVertex(vertex(i), vertex(i + 1)),
                         exact_.FromVertex(vertex(i + 1), vertex(i + 2)))) {
          continue;
        }
        for (std::size_t k = 0; k < 3; ++k)
          found_.insert(numbers[(i + k) % n]);
      }
    }
  }

  const ConvexPieces& pieces_;
  const ContourQuery& query_;
  const SeenLines& seen_;
  ReceiverView view_;
  RecipeEvaluator<Exact> exact_;
  VertexNumbers numbers_;
  std::set<VertexId> wanted_;
  std::set<int> found_;
};

}  // namespace

std::set<int> FindSuspects(const ContourEngine& engine,
                           const ContourQuery& query, const SeenLines& seen) {
  return Finder(engine, query, seen).Find();
}

}  // namespace truelux
