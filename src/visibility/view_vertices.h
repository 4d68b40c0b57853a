// What the vertices of a whole view are.

#ifndef TRUELUX_VISIBILITY_VIEW_VERTICES_H_
#define TRUELUX_VISIBILITY_VIEW_VERTICES_H_

#include <span>
#include <vector>

#include "visibility/edges_through.h"
#include "visibility/glued_view.h"
#include "visibility/whole_view.h"

namespace truelux {

/// Classifies the vertices of a view and joins the arcs that go on straight.
class ViewVertices {
 public:
  /// The arguments must outlive the object.
  ViewVertices(const ContourQuery& query, std::span<const FacetView> views,
               EdgesThrough& edges);

  /// Joins two arcs where nothing but they meet, one goes on as the other, and
  /// no scene vertex is there that could show. An arc may become as long as
  /// the horizon: then it has from = to, -1 if no vertex is left on it.
  void JoinArcs(GluedView& view);

  /// What a vertex is. arcs: those that end there.
  WholeViewVertex Classify(const GluedVertex& vertex,
                           std::span<const GluedArc> arcs_there, int index);

 private:
  [[nodiscard]] bool IsSource(int facet) const;
  [[nodiscard]] int FaceOf(int facet) const;
  [[nodiscard]] bool IsStraight(const GluedView& view, const GluedArc& a,
                                const GluedArc& b, int vertex) const;
  WholeViewVertex Describe(const GluedVertex& vertex, bool bounds_source);
  [[nodiscard]] int Farthest(const GluedVertex& vertex) const;

  const ContourQuery& query_;
  std::span<const FacetView> views_;
  EdgesThrough& edges_;
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_VIEW_VERTICES_H_
