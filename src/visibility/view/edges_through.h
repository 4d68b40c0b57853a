// All edges that coincide in one direction, seen or hidden, by the plainest
// exact means: for looking at a view, not for finding it.

#ifndef TRUELUX_VISIBILITY_VIEW_EDGES_THROUGH_H_
#define TRUELUX_VISIBILITY_VIEW_EDGES_THROUGH_H_

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "exact/recipe_evaluator.h"
#include "visibility/arrangement/arrangement_view.h"
#include "visibility/contour.h"
#include "visibility/view/edge_hit.h"

namespace truelux {

/// The edges of the facets that take part in a view.
class EdgesThrough {
 public:
  /// The arguments and the query's scene must outlive the object. views:
  /// FacetViewsOf the query.
  EdgesThrough(const ContourQuery& query,
               IdSpan<FacetId, const FacetView> views);

  /// Finds what passes through direction d (not zero); the other functions
  /// then speak of it.
  void Look(const Vec3<Exact>& d);

  /// The edges that could bound a source facet there: its own and those of
  /// what lies in front of its plane, hidden or not, without diagonals of faces
  /// and without inner edges of blocking meshes, and with the lines where
  /// blockers enter its plane. The same as ViewEdges finds.
  [[nodiscard]] std::vector<EdgeHit> OfSource(int facet) const;

  /// All edges there that are not behind a facet's plane (facet -1: all),
  /// without diagonals of faces, and with the lines where two faces meet.
  [[nodiscard]] std::vector<EdgeHit> NotBehind(int facet) const;

  /// The edge of a facet along the arc between two directions that are not
  /// parallel, whole; nothing if none is there. Diagonals are none.
  [[nodiscard]] std::optional<SeenEdge> AlongArc(int facet,
                                                 const Vec3<Exact>& from,
                                                 const Vec3<Exact>& to) const;

  /// Whether both facets have the edge, on different sides of its plane or on
  /// the same one.
  [[nodiscard]] bool Share(int facet_a, int facet_b,
                           const SeenEdge& edge) const;

  /// Which of two facets is nearer along d: negative if a is. Both must have
  /// a point there.
  [[nodiscard]] Sign DepthOrder(int facet_a, int facet_b,
                                const Vec3<Exact>& d) const;

 private:
  struct Neighbour {
    int triangle = -1;
    Sign side = Sign::kZero;  ///< of its third corner, to the edge's plane
  };

  struct Edge {
    int a = -1;  ///< scene vertices, a < b
    int b = -1;
    Vec3<Exact> plane;
    Vec3<Interval> rough_plane;
    std::vector<Neighbour> neighbours;
  };

  /// What is known of one of the edges through the direction.
  struct Passing {
    int edge = -1;
    int vertex = -1;
    Exact weight_a;  ///< the direction is weight_a a + weight_b b, times a
    Exact weight_b;  ///< positive number
  };

  void AddTriangle(int triangle);
  void FindEdges();
  void FindTriangles();
  [[nodiscard]] Sign SideOf(int edge) const;
  [[nodiscard]] int FacetOf(int triangle) const;
  [[nodiscard]] int FaceOf(int facet) const;
  [[nodiscard]] Sign InFrontOfPlane(int facet, int vertex) const;
  [[nodiscard]] bool BlocksSource(int triangle, int facet) const;
  [[nodiscard]] bool IsInner(const Edge& edge, const Neighbour& neighbour,
                             int facet) const;
  [[nodiscard]] bool BoundsSource(const Edge& edge, int facet) const;
  [[nodiscard]] bool IsDiagonal(const Edge& edge) const;
  [[nodiscard]] bool IsBehind(const Passing& passing, int facet) const;
  [[nodiscard]] SeenEdge Name(const Edge& edge) const;
  [[nodiscard]] EdgeHit HitOf(const Passing& passing) const;
  [[nodiscard]] std::optional<EdgeHit> CutAt(int triangle, int facet) const;
  [[nodiscard]] std::optional<EdgeHit> MeetingAt(int s, int t) const;
  [[nodiscard]] Vec3<Exact> CutNormal(int facet_a, int facet_b) const;
  [[nodiscard]] bool IsVertex(int vertex) const;

  const ContourQuery& query_;
  IdSpan<FacetId, const FacetView> views_;
  RecipeEvaluator<Exact> exact_;
  std::vector<Edge> edges_;
  std::map<std::pair<int, int>, int> edge_index_;
  std::vector<std::array<int, 3>> edges_of_;  ///< per triangle; -1: no part

  Vec3<Exact> d_;
  std::vector<std::int8_t> rough_side_;  ///< per edge, of d; 0: not known
  std::vector<Passing> passing_;
  std::vector<int> triangles_;  ///< whose closed image holds d
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_VIEW_EDGES_THROUGH_H_
