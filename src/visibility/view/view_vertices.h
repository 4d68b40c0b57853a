// SPDX-License-Identifier: GPL-3.0-or-later
// What the vertices of a whole view are.

#ifndef TRUELUX_VISIBILITY_VIEW_VIEW_VERTICES_H_
#define TRUELUX_VISIBILITY_VIEW_VIEW_VERTICES_H_

#include <set>
#include <span>
#include <vector>

#include "exact/recipe_evaluator.h"
#include "visibility/view/edges_at.h"
#include "visibility/view/glued_view.h"
#include "visibility/view/view_data.h"

namespace truelux {

/// The arcs of a view that end at each vertex, one that starts and ends there
/// twice.
using ArcsAround = IdVector<GluedVertexId, std::vector<GluedArcId>>;

ArcsAround ArcsAroundVertices(const GluedView& view);

/// Classifies the vertices of a view and joins the arcs that go on straight.
class ViewVertices {
 public:
  /// The arguments must outlive the object.
  ViewVertices(const ContourQuery& query, FacetViews views,
               const EdgeIndex& edges);

  /// Joins two arcs where nothing but they meet, one goes on as the other, and
  /// no scene vertex is there that could show. An arc of the horizon may become
  /// the whole of it: then from = to, none if no vertex is left on it. Vertices
  /// where no arc is left stay.
  void JoinArcs(GluedView& view) const;

  /// What a vertex is. arcs: those that end there.
  [[nodiscard]] WholeViewVertex Classify(
      const GluedView& view, GluedVertexId vertex,
      std::span<const GluedArcId> arcs) const;

 private:
  [[nodiscard]] bool IsSource(FacetId facet) const;
  [[nodiscard]] bool CanJoin(const GluedView& view, GluedVertexId vertex,
                             std::span<const GluedArcId> arcs) const;
  [[nodiscard]] bool PassesStraight(const GluedView& view, GluedVertexId vertex,
                                    std::span<const GluedArcId> arcs) const;
  [[nodiscard]] WholeViewVertex Describe(const GluedVertex& vertex,
                                         bool bounds_source) const;
  [[nodiscard]] std::vector<EdgeHit> HitsOf(const EdgesAt& edges,
                                            const GluedVertex& vertex,
                                            bool bounds_source) const;

  const ContourQuery& query_;
  FacetViews views_;
  const EdgeIndex& edges_;
  RecipeEvaluator<Exact> exact_;
  std::set<PrimitiveVector> scene_vertices_;  ///< the directions to them
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_VIEW_VIEW_VERTICES_H_
