// SPDX-License-Identifier: GPL-3.0-or-later
// The edges of a view by the triangles that have them, and which of them could
// bound what is visible of a source. For looking at a view or a contour, not
// for finding it: plain, and exact throughout.
//
// Notation
//   r     the receiver's position; all directions and planes are through r
//   d     a direction from r, of any positive length
//   a, b  the scene vertices at the ends of an edge, a < b
//   N, h  normal and height of a facet: its plane is N . (p - r) = h, so that
//         h < 0 where r is in front of it

#ifndef TRUELUX_VISIBILITY_VIEW_EDGE_INDEX_H_
#define TRUELUX_VISIBILITY_VIEW_EDGE_INDEX_H_

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "base/id_vector.h"
#include "base/ids.h"
#include "exact/recipe_evaluator.h"
#include "visibility/contour.h"
#include "visibility/view/facet_front.h"
#include "visibility/view/seen_edge.h"
#include "visibility/view/segment.h"

namespace truelux {

/// Index of an edge of an EdgeIndex, which joins two vertices of the scene.
using SceneEdgeId = Id<struct SceneEdgeTag>;

/// A triangle that has an edge.
struct EdgeNeighbour {
  TriangleId triangle;
  Sign side = Sign::kZero;  ///< of its third corner, to the plane a x b
};

/// An edge of a triangle.
struct TriangleEdge {
  SceneEdgeId edge;
  Sign side = Sign::kZero;  ///< of the triangle's third corner, as above
};

/// The edges of some triangles of a scene, as seen by one receiver.
class EdgeIndex {
 public:
  /// triangles: ascending; r is in the plane of none of them. The query and its
  /// scene must outlive the object.
  EdgeIndex(const ContourQuery& query, std::span<const TriangleId> triangles);

  [[nodiscard]] const ContourQuery& query() const { return query_; }

  [[nodiscard]] const RecipeEvaluator<Exact>& exact() const { return exact_; }

  /// The triangles that the index was made of.
  [[nodiscard]] std::span<const TriangleId> triangles() const {
    return triangles_;
  }

  /// The edges, sorted by (a, b).
  [[nodiscard]] IdRange<SceneEdgeId> edges() const { return edges_.ids(); }

  /// An edge from a to b.
  [[nodiscard]] Segment SegmentOf(SceneEdgeId edge) const;

  /// Holds the normal a x b of an edge's plane.
  [[nodiscard]] const Vec3<Interval>& RoughPlane(SceneEdgeId edge) const;

  /// The triangles of the index that have an edge.
  [[nodiscard]] std::span<const EdgeNeighbour> NeighboursOf(
      SceneEdgeId edge) const;

  /// The edges of a triangle of the index.
  [[nodiscard]] const std::array<TriangleEdge, 3>& EdgesOf(
      TriangleId triangle) const;

  /// Whether an edge could bound what is visible of a source: it is an edge of
  /// the source or of a triangle that can hide some of it, and the triangle
  /// does not go on beyond. It goes on as a triangle of the same facet (the
  /// edge is a diagonal), or, if it hides the source, as any other one that
  /// does (an inner edge of a blocking mesh). Where such an edge is behind the
  /// source's plane it bounds nothing; that is asked point by point
  /// (FacetFront::IsBehind).
  [[nodiscard]] bool CouldBound(SceneEdgeId edge,
                                const FacetFront& source) const;

  /// The line where a triangle of the index enters the source's plane; nothing
  /// if it does not. Cuts are the only further segments that could bound it.
  [[nodiscard]] std::optional<Segment> CutOf(TriangleId triangle,
                                             const FacetFront& source) const;

  /// Whether all faces at an edge go on beyond it.
  [[nodiscard]] bool IsDiagonal(SceneEdgeId edge) const;

  /// The edge of a facet along the arc between two directions that are not
  /// parallel. Returns nullopt if no edge of the facet holds the whole arc;
  /// edges between two triangles of the facet do not count.
  [[nodiscard]] std::optional<SeenEdge> AlongArc(FacetId facet,
                                                 const Vec3<Exact>& from,
                                                 const Vec3<Exact>& to) const;

  /// Which of two facets is nearer along d: negative if the first one is. Both
  /// have a point there.
  [[nodiscard]] Sign DepthOrder(FacetId facet, FacetId other,
                                const Vec3<Exact>& d) const;

  /// The normal of the plane through r and the line where the planes of two
  /// facets meet; (0, 0, 0) if the planes are equal.
  [[nodiscard]] Vec3<Exact> MeetingPlane(FacetId facet, FacetId other) const;

  [[nodiscard]] FacetId FacetOf(TriangleId triangle) const;

  /// The number of a facet's face.
  [[nodiscard]] int FaceNumber(FacetId facet) const;

 private:
  struct Edge {
    VertexId a;
    VertexId b;
    int first_neighbour = 0;
    int neighbour_count = 0;
  };

  void AddEdges();
  [[nodiscard]] bool Matters(TriangleId triangle,
                             const FacetFront& source) const;
  [[nodiscard]] bool GoesOn(SceneEdgeId edge, const EdgeNeighbour& neighbour,
                            const FacetFront& source) const;
  [[nodiscard]] SeenEdge NameOf(SceneEdgeId edge) const;

  const ContourQuery& query_;
  TriangleSides sides_;
  RecipeEvaluator<Exact> exact_;
  RecipeEvaluator<Interval> interval_;
  std::vector<TriangleId> triangles_;
  IdVector<SceneEdgeId, Edge> edges_;
  std::vector<EdgeNeighbour> neighbours_;  ///< edge by edge
  IdVector<SceneEdgeId, Vec3<Interval>> planes_;
  /// Of triangles that are not in the index: no edges.
  IdVector<TriangleId, std::array<TriangleEdge, 3>> edges_of_;
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_VIEW_EDGE_INDEX_H_
