// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/derivatives/vertex_suspects.h"

#include <algorithm>
#include <array>
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
  Finder(const ContourEngine& engine, const SceneContacts& contacts,
         const ContourQuery& query, const SeenLines& seen)
      : pieces_(engine.pieces()),
        contacts_(contacts),
        query_(query),
        seen_(seen),
        view_(ViewOf(query)),
        exact_(view_),
        numbers_(query.scene) {}

  std::set<int> Find() {
    for (const PieceId piece : seen_.edge_on)
      AddFaceOf(piece);
    AddPairs();
    AddTwins();
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
    if (wanted_.empty()) return;
    for (const PieceId piece : seen_.pieces) {
      for (const VertexId vertex : pieces_.CornersOf(piece)) {
        if (wanted_.contains(vertex))
          found_.insert(numbers_.Of(FaceOfPiece(piece), vertex, VertexId()));
      }
    }
  }

  /// Edges of several faces that are one in space, but have ends of their own.
  void AddTwins() {
    for (const PieceId piece : seen_.pieces) {
      for (const EdgeTwin& twin : contacts_.TwinsOf(piece)) {
        if (IsSeen(twin.other))
          found_.insert(twin.numbers.begin(), twin.numbers.end());
      }
    }
  }

  [[nodiscard]] bool IsSeen(PieceId piece) const {
    return std::ranges::find(seen_.pieces, piece) != seen_.pieces.end();
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
    for (const SourceContact& contact : contacts_.ContactsOf(source)) {
      if (!IsSeen(contact.piece)) continue;
      if (contact.is_coplanar)
        AddOverlap(source, contact.piece);
      else
        AddContact(source, contact.piece, contact.edge);
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
      const auto numbers = contacts_.StraightCornersOf(piece);
      found_.insert(numbers.begin(), numbers.end());
    }
  }

  const ConvexPieces& pieces_;
  const SceneContacts& contacts_;
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
                           const SceneContacts& contacts,
                           const ContourQuery& query, const SeenLines& seen) {
  return Finder(engine, contacts, query, seen).Find();
}

}  // namespace truelux
