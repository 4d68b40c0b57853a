// SPDX-License-Identifier: GPL-3.0-or-later
// All edges that coincide in one direction, seen or hidden.

#ifndef TRUELUX_VISIBILITY_VIEW_EDGES_AT_H_
#define TRUELUX_VISIBILITY_VIEW_EDGES_AT_H_

#include <optional>
#include <vector>

#include "visibility/view/edge_hit.h"
#include "visibility/view/edge_index.h"

namespace truelux {

/// What passes through a direction d, of the edges of an index.
class EdgesAt {
 public:
  /// index must outlive the object; d is not zero.
  EdgesAt(const EdgeIndex& index, const Vec3<Exact>& d);

  /// The edges that could bound a source facet there (EdgeIndex::CouldBound),
  /// hidden or not, where they are not behind its plane, and the cuts.
  [[nodiscard]] std::vector<EdgeHit> OfSource(FacetId facet) const;

  /// All edges there that are not behind a facet's plane (none: all),
  /// without diagonals of faces, and with the lines where two faces meet.
  [[nodiscard]] std::vector<EdgeHit> NotBehind(FacetId facet) const;

 private:
  /// An edge or a cut that passes through d or ends there.
  struct Passing {
    SceneEdgeId edge;
    Segment segment;
    ArcPoint point;
  };

  /// Where the part of a triangle in a plane through d leads, from d.
  struct Reach {
    bool back = false;
    bool on = false;
    VertexId vertex;  ///< the corner at d, or none
  };

  void FindSides();
  void FindTriangles();
  [[nodiscard]] std::optional<Passing> Pass(const Segment& segment) const;
  [[nodiscard]] static EdgeHit HitOf(const Passing& passing);
  [[nodiscard]] bool IsVertex(VertexId vertex) const;
  [[nodiscard]] Reach ReachOf(TriangleId triangle,
                              const Vec3<Exact>& plane) const;
  [[nodiscard]] std::optional<EdgeHit> MeetingOf(TriangleId s,
                                                 TriangleId t) const;
  void AddMeetings(FacetId facet, std::vector<EdgeHit>& hits) const;

  const EdgeIndex& index_;
  Vec3<Exact> d_;
  IdVector<SceneEdgeId, Sign> sides_;  ///< of d to the edge's plane
  std::vector<Passing> passing_;       ///< edges of the scene
  std::vector<TriangleId> triangles_;  ///< whose closed image holds d
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_VIEW_EDGES_AT_H_
