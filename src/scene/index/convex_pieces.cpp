// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/index/convex_pieces.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>

#include "exact/recipe_evaluator.h"
#include "scene/scene_access.h"
#include "scene/scene_variants.h"

namespace truelux {
namespace {

/// Sign of N . ((b - a) x (c - b)): positive for a left turn at b, seen from
/// the front of a polygon with normal N.
template <class NT>
NT Turn(const Vec3<NT>& normal, const Point3& a, const Point3& b,
        const Point3& c) {
  using Evaluator = RecipeEvaluator<NT>;
  return Dot(normal, Cross(Evaluator::Between(a, b), Evaluator::Between(b, c)));
}

/// Joins the triangles of a facet to larger strictly convex polygons, diagonal
/// by diagonal, as long as they have few enough corners (Hertel and Mehlhorn:
/// at most four times as many polygons as are needed, were there no limit).
class FacetPieces {
 public:
  FacetPieces(const Scene& scene, const Facet& facet, int max_corners)
      : view_{VerticesOf(scene), TrianglesOf(scene), {}, {}},
        first_triangle_(FirstTriangleOf(facet)),
        max_corners_(static_cast<std::size_t>(max_corners)) {
    for (const Triangle& t : TrianglesOf(scene, facet)) {
      const std::array<VertexId, 3> corners = CornersOf(t);
      rings_.emplace_back(corners.begin(), corners.end());
    }
    joined_to_.resize(rings_.size());
    std::iota(joined_to_.begin(), joined_to_.end(), std::size_t{0});
    for (const Diagonal& diagonal : Diagonals())
      Join(diagonal);
  }

  /// Calls take(corners, triangle) for every polygon.
  template <class Take>
  void ForEach(Take&& take) const {
    for (std::size_t t = 0; t < rings_.size(); ++t) {
      if (!rings_[t].empty()) {
        take(rings_[t],
             TriangleId(first_triangle_.value() + static_cast<int>(t)));
      }
    }
  }

 private:
  /// An edge that two triangles share; the first one runs from low to high or
  /// back, the second one the other way.
  struct Diagonal {
    std::pair<VertexId, VertexId> ends;  ///< the smaller index first
    std::size_t triangle = 0;
    std::size_t other = 0;
  };

  [[nodiscard]] std::vector<Diagonal> Diagonals() const {
    std::vector<Diagonal> edges;
    for (std::size_t t = 0; t < rings_.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k)
        edges.push_back(
            {std::minmax({rings_[t][k], rings_[t][(k + 1) % 3]}), t, t});
    }
    std::ranges::sort(edges, [](const Diagonal& a, const Diagonal& b) {
      return std::pair(a.ends, a.triangle) < std::pair(b.ends, b.triangle);
    });
    std::vector<Diagonal> diagonals;
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
      if (edges[i].ends != edges[i + 1].ends) continue;
      diagonals.push_back(
          {edges[i].ends, edges[i].triangle, edges[i + 1].triangle});
    }
    return diagonals;
  }

  std::size_t RingWith(std::size_t triangle) {
    while (joined_to_[triangle] != triangle)
      triangle = joined_to_[triangle];
    return triangle;
  }

  void Join(const Diagonal& diagonal) {
    const std::size_t keep = RingWith(diagonal.triangle);
    const std::size_t gone = RingWith(diagonal.other);
    std::vector<VertexId>& ring = rings_[keep];
    std::vector<VertexId>& added = rings_[gone];
    if (ring.size() + added.size() - 2 > max_corners_) return;
    // Both rings are turned so that the diagonal closes them.
    const auto [low, high] = diagonal.ends;
    TurnTo(ring, low, high);
    TurnTo(added, ring.front(), ring.back());
    const bool is_convex =
        TurnsLeft(ring[ring.size() - 2], ring.back(), added[1]) &&
        TurnsLeft(added[added.size() - 2], ring.front(), ring[1]);
    if (!is_convex) return;
    ring.insert(ring.end(), added.begin() + 1, added.end() - 1);
    added.clear();
    joined_to_[gone] = keep;
  }

  /// Turns a ring until its first and last corners are the two given ones, in
  /// either order.
  static void TurnTo(std::vector<VertexId>& ring, VertexId a, VertexId b) {
    const auto closes = [&] {
      return std::minmax({ring.front(), ring.back()}) == std::minmax({a, b});
    };
    while (!closes())
      std::rotate(ring.begin(), ring.begin() + 1, ring.end());
  }

  [[nodiscard]] bool TurnsLeft(VertexId a, VertexId b, VertexId c) const {
    const auto at = [this](VertexId vertex) { return view_.vertices[vertex]; };
    {
      const RoundUpward rounding;
      const RecipeEvaluator<Interval> interval(view_);
      const auto sign = TrySign(
          Turn(interval.TriangleNormal(first_triangle_), at(a), at(b), at(c)));
      if (sign) return *sign == Sign::kPositive;
    }
    const RecipeEvaluator<Exact> exact(view_);
    return SignOf(Turn(exact.TriangleNormal(first_triangle_), at(a), at(b),
                       at(c))) == Sign::kPositive;
  }

  ReceiverView view_;
  TriangleId first_triangle_;
  std::size_t max_corners_;
  /// Per triangle the polygon that it became; empty: joined to another one's.
  std::vector<std::vector<VertexId>> rings_;
  std::vector<std::size_t> joined_to_;
};

}  // namespace

ConvexPieces::ConvexPieces(const Scene& scene, int max_corners) {
  const auto facets = FacetsOf(scene);
  first_piece_.reserve(facets.size() + 1);
  for (const FacetId f : facets.ids()) {
    first_piece_.push_back(pieces_.end_id());
    const TriangleId first = FirstTriangleOf(facets[f]);
    if (facets[f].triangle_count == 1) {
      AddPiece(truelux::CornersOf(TrianglesOf(scene)[first]), f, first);
      continue;
    }
    FacetPieces(scene, facets[f], max_corners)
        .ForEach([&](std::span<const VertexId> corners, TriangleId triangle) {
          AddPiece(corners, f, triangle);
        });
  }
  first_piece_.push_back(pieces_.end_id());
  LinkEdges();
  FindPlanes(scene);
}

void ConvexPieces::AddPiece(std::span<const VertexId> corners, FacetId facet,
                            TriangleId triangle) {
  const PieceId piece = pieces_.push_back(
      {corners_.end_id(), static_cast<int>(corners.size()), facet, triangle});
  corners_.Append(corners);
  piece_of_.resize(corners_.size(), piece);
}

void ConvexPieces::LinkEdges() {
  /// An edge by its vertices, the smaller index first.
  struct KeyedEdge {
    std::uint64_t key;
    EdgeId edge;
  };

  std::vector<KeyedEdge> edges;
  edges.reserve(corners_.size());
  for (const Piece& piece : pieces_) {
    for (const EdgeId edge : piece.edges()) {
      const auto [low, high] =
          std::minmax(corners_[edge], corners_[NextCorner(edge)]);
      edges.push_back({static_cast<std::uint64_t>(high.value()) << 32 |
                           static_cast<std::uint64_t>(low.value()),
                       edge});
    }
  }
  std::ranges::sort(edges, [](const KeyedEdge& a, const KeyedEdge& b) {
    return std::pair(a.key, a.edge) < std::pair(b.key, b.edge);
  });
  next_same_edge_.resize(corners_.size());
  first_same_edge_.resize(corners_.size());
  for (std::size_t begin = 0; begin < edges.size();) {
    std::size_t end = begin + 1;
    while (end < edges.size() && edges[end].key == edges[begin].key)
      ++end;
    for (std::size_t i = begin; i < end; ++i) {
      next_same_edge_[edges[i].edge] = edges[i + 1 < end ? i + 1 : begin].edge;
      first_same_edge_[edges[i].edge] = edges[begin].edge;
    }
    begin = end;
  }
}

void ConvexPieces::FindPlanes(const Scene& scene) {
  const IdRange<FacetId> facets = FacetsOf(scene).ids();
  DisjointSets<FacetId> coplanar(scene.facets().size());
  if (!SceneVariants::IsLoose(scene)) JoinCoplanar(scene, coplanar);
  first_in_plane_.reserve(scene.facets().size());
  for (const FacetId facet : facets)
    first_in_plane_.push_back(coplanar.LeastOf(facet));
}

void ConvexPieces::JoinCoplanar(const Scene& scene,
                                DisjointSets<FacetId>& coplanar) const {
  const ReceiverView view{VerticesOf(scene), TrianglesOf(scene), {}, {}};
  const RecipeEvaluator<Interval> interval(view);
  const RecipeEvaluator<Exact> exact(view);
  const RoundUpward rounding;
  for (const EdgeId edge : corners_.ids()) {
    const EdgeId other = NextSameEdge(edge);
    const Piece& p = pieces_[PieceOf(edge)];
    const Piece& q = pieces_[PieceOf(other)];
    if (coplanar.LeastOf(p.facet) == coplanar.LeastOf(q.facet)) continue;
    // They have an edge in common, so that one more corner decides.
    const VertexId vertex = corners_[NextCorner(NextCorner(other))];
    auto sign = TrySign(interval.AboveTriangle(p.triangle, vertex));
    if (!sign) sign = SignOf(exact.AboveTriangle(p.triangle, vertex));
    if (*sign == Sign::kZero) coplanar.Join(p.facet, q.facet);
  }
}

}  // namespace truelux
