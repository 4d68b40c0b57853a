// SPDX-License-Identifier: GPL-3.0-or-later
// The chain of a source (method.md, section 11): the sum of the boundaries of
// all blockers, each counter-clockwise as seen from r. What is left of it are
// silhouette edges, borders and cuts with the source's plane.

#ifndef TRUELUX_VISIBILITY_CHAIN_SOURCE_CHAIN_H_
#define TRUELUX_VISIBILITY_CHAIN_SOURCE_CHAIN_H_

#include <cstddef>
#include <span>
#include <vector>

#include "base/id_vector.h"
#include "base/ids.h"
#include "base/stamped_table.h"
#include "scene/index/scene_index.h"
#include "scene/index/shaft.h"
#include "visibility/chain/chain_counts.h"
#include "visibility/contour.h"
#include "visibility/edges/cone.h"
#include "visibility/edges/coverage.h"
#include "visibility/edges/image_box.h"
#include "visibility/edges/source_cones.h"

namespace truelux {

/// Index of an edge of a source's chain.
using ChainEdgeId = Id<struct ChainEdgeTag>;

/// An edge of the chain, of which the positive side is deeper: `coefficient`
/// more blockers lie over it than over the negative one.
struct ChainEdge {
  ViewEdge edge;
  int coefficient = 0;  ///< > 0
  PieceId owner;  ///< lies on the positive side; the edge is one of its own
};

/// Makes the chain of one source after the other. Allocates nothing in the
/// steady state.
template <class Geometry>
class SourceChain {
 public:
  /// The arguments must outlive the object.
  SourceChain(const Scene& scene, const SceneIndex& index, Geometry& geometry,
              ConeMaker<Geometry>& cones, SourceCones<Geometry>& source,
              IgnoredFacetCache& ignored, ChainCounts& counts);

  /// Makes the chain of the source that has been set, as far as it meets the
  /// hull of the source; edges outside may be missing. source_box: holds the
  /// source.
  /// candidates: edges in the order of SilhouetteTree::Visit, among them all
  /// that it would call; null: it is asked.
  void Build(const Shaft& shaft, const Box& source_box,
             const std::vector<SilhouetteEdge>* candidates);

  /// How many edges were looked at to make the chain.
  [[nodiscard]] std::size_t looked_at() const { return looked_at_; }

  [[nodiscard]] IdSpan<ChainEdgeId, const ChainEdge> edges() const {
    return edges_;
  }

  /// The boxes of edges(), in their order.
  [[nodiscard]] std::span<const ImageBox> boxes() const { return boxes_; }

  /// Calls visit(ChainEdgeId) for every edge that begins or ends in a
  /// direction, by its id.
  template <class Visit>
  void ForEachAt(ViewDirectionId direction, const Visit& visit) {
    const Ends* ends = ends_at_.Find(direction);
    if (ends == nullptr) return;
    for (ChainEdgeId e = ends->first_from; e.valid(); e = links_[e].next_from)
      visit(e);
    for (ChainEdgeId e = ends->first_to; e.valid(); e = links_[e].next_to)
      visit(e);
  }

 private:
  /// The heads of the lists of edges that begin and end in a direction.
  struct Ends {
    ChainEdgeId first_from;
    ChainEdgeId first_to;
  };

  struct Links {
    ChainEdgeId next_from;
    ChainEdgeId next_to;
  };

  [[nodiscard]] bool Blocks(PieceId piece);
  bool IsInner(const SilhouetteEdge& edge);
  bool Weigh(EdgeId edge, VertexId from, bool in_plane, ChainEdge& c);
  bool AddEdge(EdgeId edge);
  bool BlocksAtPlane(PieceId piece);
  void AddAtSourcePlane(const Box& source_box);
  void AddPieceAtPlane(PieceId piece);
  void AddCut(PieceId piece, const CornerSigns& sides);
  void AddIgnoredBorders(const Shaft& shaft);
  ViewDirectionId CutDirection(EdgeId edge);
  void Append(const ChainEdge& edge, const ImageBox& box);
  void Link();

  const Scene& scene_;
  const SceneIndex& index_;
  const ConvexPieces& pieces_;
  Geometry& geometry_;
  ConeMaker<Geometry>& cones_;
  SourceCones<Geometry>& source_;
  IgnoredFacetCache& ignored_;
  ChainCounts& counts_;

  IdVector<ChainEdgeId, ChainEdge> edges_;
  std::vector<ImageBox> boxes_;
  IdVector<ChainEdgeId, Links> links_;
  StampedTable<Ends, ViewDirectionId> ends_at_;
  std::size_t looked_at_ = 0;
  StampedSet<EdgeId> is_added_;  ///< by the first of equal edges
  StampedTable<ViewDirectionId, EdgeId> cut_directions_;  ///< likewise
};

extern template class SourceChain<ViewGeometry>;
extern template class SourceChain<UnfilteredViewGeometry>;
extern template class SourceChain<DisplacedViewGeometry>;

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_CHAIN_SOURCE_CHAIN_H_
