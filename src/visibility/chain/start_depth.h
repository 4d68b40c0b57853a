// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TRUELUX_VISIBILITY_CHAIN_START_DEPTH_H_
#define TRUELUX_VISIBILITY_CHAIN_START_DEPTH_H_

#include <optional>

#include "scene/index/ray_boxes.h"
#include "scene/index/scene_index.h"
#include "scene/index/shaft.h"
#include "visibility/chain/chain_counts.h"
#include "visibility/contour.h"
#include "visibility/edges/blocker_parts.h"
#include "visibility/edges/cone.h"
#include "visibility/edges/coverage.h"
#include "visibility/edges/source_cones.h"

namespace truelux {

/// Counts the blockers over a point of an edge. The tree is asked with a ray as
/// wide as the direction is unknown; what it keeps is decided exactly.
template <class Geometry>
class StartDepth {
 public:
  /// The arguments must outlive the object.
  StartDepth(const Scene& scene, const SceneIndex& index, Geometry& geometry,
             ConeMaker<Geometry>& cones, SourceCones<Geometry>& source,
             BlockerParts<Geometry>& blockers, IgnoredFacetCache& ignored,
             ChainCounts& counts)
      : scene_(scene),
        index_(index),
        geometry_(geometry),
        cones_(cones),
        source_(source),
        blockers_(blockers),
        ignored_(ignored),
        counts_(counts) {}

  /// The number of blockers of the source over an edge right after a position,
  /// on its positive or negative side. shaft: the source's. Exact.
  int At(const ViewEdge& edge, const EdgePosition& position, bool on_positive,
         const Shaft& shaft);

  /// Whether a blocker that was counted since the last call of Start hides the
  /// whole source.
  [[nodiscard]] bool hides_all() const { return hides_all_; }

  void Start() { hides_all_ = false; }

 private:
  std::optional<RayBoxes> RayThrough(const ViewEdge& edge,
                                     const EdgePosition& position);
  bool Holds(PieceId piece, const ViewEdge& edge, const EdgePosition& position,
             bool on_positive, const ImageBox& near);

  const Scene& scene_;
  const SceneIndex& index_;
  Geometry& geometry_;
  ConeMaker<Geometry>& cones_;
  SourceCones<Geometry>& source_;
  BlockerParts<Geometry>& blockers_;
  IgnoredFacetCache& ignored_;
  ChainCounts& counts_;
  bool hides_all_ = false;
};

extern template class StartDepth<ViewGeometry>;
extern template class StartDepth<UnfilteredViewGeometry>;
extern template class StartDepth<DisplacedViewGeometry>;

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_CHAIN_START_DEPTH_H_
