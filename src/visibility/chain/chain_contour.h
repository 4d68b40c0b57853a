// SPDX-License-Identifier: GPL-3.0-or-later
// The visible contour of one source from its chain (method.md, section 11).

#ifndef TRUELUX_VISIBILITY_CHAIN_CHAIN_CONTOUR_H_
#define TRUELUX_VISIBILITY_CHAIN_CHAIN_CONTOUR_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/id_vector.h"
#include "base/stamped_table.h"
#include "visibility/chain/chain_counts.h"
#include "visibility/chain/edge_sweep.h"
#include "visibility/chain/source_chain.h"
#include "visibility/chain/start_depth.h"
#include "visibility/edges/source_contour.h"
#include "visibility/edges/source_intervals.h"

namespace truelux {

/// Finds the arcs of a source. Along an edge the number of blockers over the
/// edge changes where an edge of the chain crosses. An arc lies where no blocker
/// is left.
template <class Geometry>
class ChainContour {
 public:
  /// checks_depths: for tests; std::logic_error is thrown where a depth is not
  /// what the tree says. The arguments must outlive the object.
  ChainContour(const Scene& scene, const SceneIndex& index, Geometry& geometry,
               ConeMaker<Geometry>& cones, SourceCones<Geometry>& source,
               SourceIntervals<Geometry>& intervals,
               BlockerParts<Geometry>& blockers, IgnoredFacetCache& ignored,
               bool checks_depths);

  /// Makes the chain of the source that has been set. shaft: the source's; it
  /// must outlive the calls of AppendArcs. source_box, candidates: as of
  /// SourceChain::Build.
  void MakeChain(const Shaft& shaft, const Box& source_box,
                 const std::vector<SilhouetteEdge>* candidates);

  /// Appends the arcs that bound what is visible of the source, which may have
  /// been narrowed since its chain was made; none if nothing is visible. The
  /// direction sides are those to the first cone of what is left.
  void AppendArcs(std::vector<ViewArc>& arcs);

  /// How many edges were looked at to make the chain.
  [[nodiscard]] std::size_t looked_at() const { return chain_.looked_at(); }

  [[nodiscard]] const ChainCounts& counts() const { return counts_; }

 private:
  /// Where the depth on the negative side of a chain edge is known.
  enum class KnownAt : std::uint8_t {
    kNowhere,
    kBegin,   ///< where the edge begins
    kEntry,   ///< after it enters the source
    kExit,    ///< before it leaves the source
    kBefore,  ///< before it crosses another chain edge
    kAfter,   ///< after it crosses another chain edge
  };

  /// What is known of an edge of the chain while arcs are sought.
  struct State {
    bool is_swept = false;
    KnownAt known_at = KnownAt::kNowhere;
    int depth = 0;
    ViewPlaneId plane;  ///< of the source: kEntry, kExit
    ChainEdgeId edge;   ///< the other one: kBefore, kAfter
  };

  /// An edge of the source that is no diagonal.
  struct OutlineEdge {
    std::size_t part = 0;   ///< of the source
    std::size_t index = 0;  ///< in the part's cone
    bool is_swept = false;
  };

  /// A chain edge as seen from one of its ends.
  struct Spoke {
    ChainEdgeId edge;
    ViewDirectionId far;
    bool is_outgoing = false;
    bool is_first_half = false;
  };

  void SweepOutline();
  std::optional<int> SweepOutlineEdge(const Cone& cone, std::size_t k,
                                      std::optional<int> depth);
  void SweepKnown();
  void SweepChainEdge(ChainEdgeId id);
  void Know(ChainEdgeId id, const State& state);
  std::optional<int> KnownDepth(const State& state);
  void CheckDepth(const ViewEdge& edge, const EdgePosition& position,
                  bool on_positive, int depth);
  void AddChainArcs(ChainEdgeId id, const EdgePosition& begin,
                    const EdgePosition& end);
  void Propagate(ChainEdgeId id, int depth);
  bool SortSpokes(ViewPlaneId plane);

  Geometry& geometry_;
  ConeMaker<Geometry>& cones_;
  SourceCones<Geometry>& source_;
  bool checks_depths_;
  ChainCounts counts_;
  SourceChain<Geometry> chain_;
  StartDepth<Geometry> depth_;
  EdgeSweep<Geometry> sweep_;
  SourceIntervals<Geometry>& intervals_;  ///< of the chain edge that is swept
  const Shaft* shaft_ = nullptr;
  std::vector<ViewArc>* arcs_ = nullptr;
  IdVector<ChainEdgeId, State> states_;
  std::vector<ChainEdgeId> near_;  ///< chain edges that may meet the source
  StampedTable<int, ViewDirectionId> corner_depths_;  ///< around corners
  std::vector<OutlineEdge> outline_;
  StampedTable<std::size_t, ViewDirectionId> outline_at_;  ///< where they begin
  std::vector<Spoke> spokes_;
  std::vector<ChainEdgeId> known_;  ///< not swept, of known depth somewhere
};

extern template class ChainContour<ViewGeometry>;
extern template class ChainContour<UnfilteredViewGeometry>;
extern template class ChainContour<DisplacedViewGeometry>;

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_CHAIN_CHAIN_CONTOUR_H_
