// SPDX-License-Identifier: GPL-3.0-or-later
// The default engine: visible contours by walking edges (docs/method.md).

#ifndef TRUELUX_VISIBILITY_EDGES_CONTOUR_ENGINE_H_
#define TRUELUX_VISIBILITY_EDGES_CONTOUR_ENGINE_H_

#include <memory>
#include <span>
#include <vector>

#include "base/id_vector.h"
#include "base/ids.h"
#include "exact/filter.h"
#include "exact/predicate_kind.h"
#include "scene/index/convex_pieces.h"
#include "scene/index/scene_index.h"
#include "scene/index/shaft.h"
#include "scene/index/triangle_tree.h"
#include "visibility/chain/chain_counts.h"
#include "visibility/contour.h"
#include "visibility/edges/emitter_groups.h"

namespace truelux {

/// How the engine finds what is visible. Both ways give contours of the same
/// regions. Unfiltered predicates always go by blockers: along a chain one
/// wrong sign would spoil all depths that follow.
enum class ContourPath {
  kByCost,    ///< the cheaper one, for each source and receiver
  kBlockers,  ///< by what each blocker hides (method.md, section 4)
  kChain,     ///< by the chain of the blockers (method.md, section 11)
  /// The same, each depth asked of the tree, too: for tests. std::logic_error
  /// is thrown where it is another one.
  kCheckedChain,
};

/// What the contour engine knows of a scene, whatever the receiver. Immutable.
class ContourEngine {
 public:
  explicit ContourEngine(const Scene& scene,
                         ContourPath path = ContourPath::kByCost);

  /// The visible contours of the query's sources; query.scene must be the
  /// engine's. One SourceArcs per source of which something is visible. For
  /// one receiver; a ContourBuilder does many without allocating.
  [[nodiscard]] Contour Build(const ContourQuery& query) const;

  [[nodiscard]] const Scene& scene() const { return scene_; }

  [[nodiscard]] ContourPath path() const { return path_; }

  [[nodiscard]] const ConvexPieces& pieces() const { return index_.pieces(); }

  [[nodiscard]] IdSpan<TriangleId, const FilteredPlane> triangle_normals()
      const {
    return triangle_normals_;
  }

  /// A facet of a face that emits.
  struct Emitter {
    FacetId facet;
    ShaftSource shafts;
  };

  struct Group {
    EmitterGroup emitters;
    ShaftSource shafts;
  };

  /// The facets of the faces that emit, in their order.
  [[nodiscard]] IdSpan<EmitterId, const Emitter> emitters() const {
    return emitters_;
  }

  /// The group that a facet belongs to; null if to none.
  [[nodiscard]] const Group* GroupOf(FacetId facet) const {
    const int group = group_of_[facet];
    return group >= 0 ? &groups_[static_cast<std::size_t>(group)] : nullptr;
  }

  /// What the shafts towards facets in one plane have in common.
  [[nodiscard]] ShaftSource ShaftsTo(std::span<const FacetId> facets) const;

  [[nodiscard]] const SceneIndex& index() const { return index_; }

  /// The boxes of the pieces.
  [[nodiscard]] const TriangleTree& tree() const { return index_.tree(); }

 private:
  Scene scene_;
  ContourPath path_;
  const SceneIndex& index_;  ///< lives as long as the scene's data
  IdVector<TriangleId, FilteredPlane> triangle_normals_;
  IdVector<EmitterId, Emitter> emitters_;
  std::vector<Group> groups_;
  IdVector<FacetId, int> group_of_;  ///< in groups_; -1: none
};

/// Finds visible contours in one scene, one receiver after the other; every
/// decision is exact (with PredicateKind::kExact). For one thread.
template <PredicateKind kKind>
class BasicContourBuilder {
 public:
  /// The engine must outlive the object.
  explicit BasicContourBuilder(const ContourEngine& engine);
  ~BasicContourBuilder();
  BasicContourBuilder(BasicContourBuilder&&) noexcept;
  BasicContourBuilder& operator=(BasicContourBuilder&&) noexcept;

  /// Announces that the receivers of the next Build calls are among these:
  /// near ones then share what is found out about where their blockers are.
  /// It changes no contour, only how often predicates are asked about pieces
  /// that block nothing. Until the next call; an empty block ends it.
  void StartBlock(std::span<const Receiver> receivers);

  /// As ContourEngine::Build, into `contour`, whose storage is used again.
  void Build(const ContourQuery& query, Contour& contour);

  /// Of all Build calls so far.
  [[nodiscard]] ChainCounts chain_counts() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

using ContourBuilder = BasicContourBuilder<PredicateKind::kExact>;
using UnfilteredContourBuilder =
    BasicContourBuilder<PredicateKind::kUnfiltered>;
/// Takes ContourQuery::displacement into account.
using DisplacedContourBuilder = BasicContourBuilder<PredicateKind::kDisplaced>;

extern template class BasicContourBuilder<PredicateKind::kExact>;
extern template class BasicContourBuilder<PredicateKind::kUnfiltered>;
extern template class BasicContourBuilder<PredicateKind::kDisplaced>;

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_EDGES_CONTOUR_ENGINE_H_
