// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/index/convex_pieces.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>

#include "exact/recipe_evaluator.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

std::size_t Index(int i) {
  return static_cast<std::size_t>(i);
}

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
        first_triangle_(facet.first_triangle),
        max_corners_(Index(max_corners)) {
    for (const Triangle& t : scene.triangles().subspan(
             Index(facet.first_triangle), Index(facet.triangle_count)))
      rings_.emplace_back(t.vertices.begin(), t.vertices.end());
    joined_to_.resize(rings_.size());
    std::iota(joined_to_.begin(), joined_to_.end(), std::size_t{0});
    for (const Diagonal& diagonal : Diagonals())
      Join(diagonal);
  }

  /// Calls take(corners, triangle) for every polygon.
  template <class Take>
  void ForEach(Take&& take) const {
    for (std::size_t t = 0; t < rings_.size(); ++t) {
      if (!rings_[t].empty())
        take(rings_[t], first_triangle_ + static_cast<int>(t));
    }
  }

 private:
  /// An edge that two triangles share; the first one runs from low to high or
  /// back, the second one the other way.
  struct Diagonal {
    std::pair<int, int> ends;  ///< vertices, the smaller index first
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
    std::vector<int>& ring = rings_[keep];
    std::vector<int>& added = rings_[gone];
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
  static void TurnTo(std::vector<int>& ring, int a, int b) {
    const auto closes = [&] {
      return std::minmax({ring.front(), ring.back()}) == std::minmax({a, b});
    };
    while (!closes())
      std::rotate(ring.begin(), ring.begin() + 1, ring.end());
  }

  [[nodiscard]] bool TurnsLeft(int a, int b, int c) const {
    const auto at = [this](int vertex) {
      return view_.vertices[VertexId(vertex)];
    };
    {
      const RoundUpward rounding;
      const RecipeEvaluator<Interval> interval(view_);
      const auto sign =
          TrySign(Turn(interval.TriangleNormal(TriangleId(first_triangle_)),
                       at(a), at(b), at(c)));
      if (sign) return *sign == Sign::kPositive;
    }
    const RecipeEvaluator<Exact> exact(view_);
    return SignOf(Turn(exact.TriangleNormal(TriangleId(first_triangle_)), at(a),
                       at(b), at(c))) == Sign::kPositive;
  }

  ReceiverView view_;
  int first_triangle_;
  std::size_t max_corners_;
  /// Per triangle the polygon that it became; empty: joined to another one's.
  std::vector<std::vector<int>> rings_;
  std::vector<std::size_t> joined_to_;
};

}  // namespace

ConvexPieces::ConvexPieces(const Scene& scene, int max_corners) {
  const auto facets = scene.facets();
  first_piece_.reserve(facets.size() + 1);
  for (std::size_t f = 0; f < facets.size(); ++f) {
    first_piece_.push_back(static_cast<int>(pieces_.size()));
    const int facet = static_cast<int>(f);
    const int first = facets[f].first_triangle;
    if (facets[f].triangle_count == 1) {
      AddPiece(scene.triangles()[Index(first)].vertices, facet, first);
      continue;
    }
    FacetPieces(scene, facets[f], max_corners)
        .ForEach([&](std::span<const int> corners, int triangle) {
          AddPiece(corners, facet, triangle);
        });
  }
  first_piece_.push_back(static_cast<int>(pieces_.size()));
  LinkEdges();
  NumberPlanes(scene);
}

void ConvexPieces::AddPiece(std::span<const int> corners, int facet,
                            int triangle) {
  const auto piece = static_cast<int>(pieces_.size());
  pieces_.push_back({static_cast<int>(corners_.size()),
                     static_cast<int>(corners.size()), facet, triangle});
  corners_.insert(corners_.end(), corners.begin(), corners.end());
  piece_of_.insert(piece_of_.end(), corners.size(), piece);
}

void ConvexPieces::LinkEdges() {
  /// An edge by its vertices, the smaller index first.
  struct KeyedEdge {
    std::uint64_t key;
    int edge;
  };

  std::vector<KeyedEdge> edges;
  edges.reserve(corners_.size());
  for (const Piece& piece : pieces_) {
    const auto ring = CornersOf(piece);
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const auto [low, high] =
          std::minmax(ring[k], ring[k + 1 < ring.size() ? k + 1 : 0]);
      edges.push_back({static_cast<std::uint64_t>(high) << 32 |
                           static_cast<std::uint64_t>(low),
                       piece.first_corner + static_cast<int>(k)});
    }
  }
  std::ranges::sort(edges, [](const KeyedEdge& a, const KeyedEdge& b) {
    return std::pair(a.key, a.edge) < std::pair(b.key, b.edge);
  });
  next_same_edge_.resize(corners_.size());
  for (std::size_t begin = 0; begin < edges.size();) {
    std::size_t end = begin + 1;
    while (end < edges.size() && edges[end].key == edges[begin].key)
      ++end;
    for (std::size_t i = begin; i < end; ++i) {
      next_same_edge_[Index(edges[i].edge)] =
          edges[i + 1 < end ? i + 1 : begin].edge;
    }
    begin = end;
  }
}

void ConvexPieces::NumberPlanes(const Scene& scene) {
  // Sets of coplanar facets, each with a tree that leads to its number.
  plane_number_.resize(scene.facets().size());
  std::iota(plane_number_.begin(), plane_number_.end(), 0);
  const auto number_of = [this](int facet) {
    while (plane_number_[Index(facet)] != facet) {
      int& parent = plane_number_[Index(facet)];
      parent = plane_number_[Index(parent)];
      facet = parent;
    }
    return facet;
  };
  const ReceiverView view{VerticesOf(scene), TrianglesOf(scene), {}, {}};
  const RecipeEvaluator<Interval> interval(view);
  const RecipeEvaluator<Exact> exact(view);
  const RoundUpward rounding;
  for (int edge = 0; edge < static_cast<int>(corners_.size()); ++edge) {
    const int other = NextSameEdge(edge);
    const Piece& p = pieces_[Index(PieceOf(edge))];
    const Piece& q = pieces_[Index(PieceOf(other))];
    const int a = number_of(p.facet);
    const int b = number_of(q.facet);
    if (a == b) continue;
    // They have an edge in common, so that one more corner decides.
    const VertexId vertex(corners_[Index(NextCorner(NextCorner(other)))]);
    const TriangleId own(p.triangle);
    auto sign = TrySign(interval.AboveTriangle(own, vertex));
    if (!sign) sign = SignOf(exact.AboveTriangle(own, vertex));
    if (*sign == Sign::kZero) {
      plane_number_[Index(std::max(a, b))] = std::min(a, b);
    }
  }
  for (int facet = 0; facet < static_cast<int>(plane_number_.size()); ++facet)
    plane_number_[Index(facet)] = number_of(facet);
}

}  // namespace truelux
