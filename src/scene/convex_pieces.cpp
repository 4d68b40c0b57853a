#include "scene/convex_pieces.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>

#include "exact/recipe.h"

namespace truelux {
namespace {

std::size_t Index(int i) {
  return static_cast<std::size_t>(i);
}

/// The boundary of a facet as one ring; empty if it has too many corners.
std::vector<int> RingOf(std::span<const Triangle> triangles, int max_corners) {
  if (triangles.size() + 2 > Index(max_corners)) return {};
  std::vector<std::array<int, 2>> edges;
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::array<int, 2> edge{t.vertices[k], t.vertices[(k + 1) % 3]};
      const auto reverse =
          std::ranges::find(edges, std::array{edge[1], edge[0]});
      if (reverse == edges.end()) {
        edges.push_back(edge);
      } else {
        edges.erase(reverse);  // a diagonal
      }
    }
  }
  std::vector<int> ring;
  int corner = edges.front()[0];
  do {
    ring.push_back(corner);
    const auto next = std::ranges::find(
        edges, corner, [](const std::array<int, 2>& e) { return e[0]; });
    corner = (*next)[1];
  } while (corner != ring.front() && ring.size() < edges.size());
  return ring.size() == edges.size() ? ring : std::vector<int>();
}

/// Sign of N . ((b - a) x (c - b)): positive for a left turn at b, seen from
/// the front of a polygon with normal N.
template <class NT>
NT Turn(const Vec3<NT>& normal, const Point3& a, const Point3& b,
        const Point3& c) {
  using Evaluator = RecipeEvaluator<NT>;
  return Dot(normal, Cross(Evaluator::Between(a, b), Evaluator::Between(b, c)));
}

bool IsStrictlyConvex(std::span<const int> ring,
                      std::span<const Point3> vertices,
                      std::span<const Triangle> triangles, int triangle) {
  const ReceiverView view{vertices, triangles, {}, {}};
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point3& a = vertices[Index(ring[k])];
    const Point3& b = vertices[Index(ring[(k + 1) % ring.size()])];
    const Point3& c = vertices[Index(ring[(k + 2) % ring.size()])];
    const auto turn = [&]() -> Sign {
      {
        const RoundUpward rounding;
        const RecipeEvaluator<Interval> interval(view);
        const auto sign =
            TrySign(Turn(interval.TriangleNormal(triangle), a, b, c));
        if (sign) return *sign;
      }
      const RecipeEvaluator<Exact> exact(view);
      return SignOf(Turn(exact.TriangleNormal(triangle), a, b, c));
    };
    if (turn() != Sign::kPositive) return false;
  }
  return true;
}

}  // namespace

ConvexPieces::ConvexPieces(const Scene& scene, int max_corners) {
  const auto triangles = scene.triangles();
  const auto facets = scene.facets();
  first_piece_.reserve(facets.size() + 1);
  for (std::size_t f = 0; f < facets.size(); ++f) {
    first_piece_.push_back(static_cast<int>(pieces_.size()));
    const auto own = triangles.subspan(Index(facets[f].first_triangle),
                                       Index(facets[f].triangle_count));
    const int facet = static_cast<int>(f);
    if (own.size() > 1) {
      const std::vector<int> ring = RingOf(own, max_corners);
      if (!ring.empty() && IsStrictlyConvex(ring, scene.vertices(), triangles,
                                            facets[f].first_triangle)) {
        AddPiece(ring, facet, facets[f].first_triangle);
        continue;
      }
    }
    for (int t = 0; t < facets[f].triangle_count; ++t) {
      const int triangle = facets[f].first_triangle + t;
      AddPiece(triangles[Index(triangle)].vertices, facet, triangle);
    }
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
  const ReceiverView view{scene.vertices(), scene.triangles(), {}, {}};
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
    const int vertex = corners_[Index(NextCorner(NextCorner(other)))];
    auto sign = TrySign(interval.AboveTriangle(p.triangle, vertex));
    if (!sign) sign = SignOf(exact.AboveTriangle(p.triangle, vertex));
    if (*sign == Sign::kZero) {
      plane_number_[Index(std::max(a, b))] = std::min(a, b);
    }
  }
  for (int facet = 0; facet < static_cast<int>(plane_number_.size()); ++facet)
    plane_number_[Index(facet)] = number_of(facet);
}

}  // namespace truelux
