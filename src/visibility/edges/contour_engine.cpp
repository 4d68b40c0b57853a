// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/edges/contour_engine.h"

#include <algorithm>
#include <optional>

#include "base/stamped_table.h"
#include "base/stop.h"
#include "scene/emitters.h"
#include "scene/scene_access.h"
#include "visibility/chain/chain_contour.h"
#include "visibility/chain/shared_edges.h"
#include "visibility/edges/blocker_parts.h"
#include "visibility/edges/cone.h"
#include "visibility/edges/contour_writer.h"
#include "visibility/edges/direction_sides.h"
#include "visibility/edges/source_cones.h"
#include "visibility/edges/source_contour.h"
#include "visibility/edges/source_join.h"

namespace truelux {

namespace {

/// With more inner edges towards a source its chain is made. A chain costs
/// about as much as 100 blockers: the search of the tree and the first depth.
constexpr std::size_t kManyInnerEdges = 300;

}  // namespace

ContourEngine::ContourEngine(const Scene& scene, ContourPath path)
    : scene_(scene),
      path_(path),
      index_(SceneIndex::Of(scene)),
      triangle_normals_(
          FilteredTriangleNormals(scene.vertices(), scene.triangles())) {
  const auto facets = FacetsOf(scene);
  for (const FacetId facet : facets.ids()) {
    if (!Emits(FacesOf(scene)[FaceOf(facets[facet])])) continue;
    emitters_.push_back({facet, ShaftsTo(facet)});
  }
}

ShaftSource ContourEngine::ShaftsTo(FacetId facet) const {
  const RoundUpward rounding;
  return {scene_.vertices(), TrianglesOf(scene_, FacetsOf(scene_)[facet])};
}

Contour ContourEngine::Build(const ContourQuery& query) const {
  Contour contour;
  ContourBuilder(*this).Build(query, contour);
  return contour;
}

template <PredicateKind kKind>
class BasicContourBuilder<kKind>::Impl {
 public:
  explicit Impl(const ContourEngine& engine)
      : engine_(engine),
        geometry_(
            {VerticesOf(engine.scene()), TrianglesOf(engine.scene()), {}, {}},
            engine.triangle_normals()),
        cones_(geometry_, engine.pieces()),
        source_(engine.scene(), engine.pieces(), geometry_, cones_),
        source_sides_(geometry_),
        blockers_(engine.pieces(), geometry_, cones_, source_, source_sides_),
        arcs_(engine.pieces(), geometry_, cones_, source_, blockers_,
              source_sides_),
        join_(engine.scene(), engine.pieces(), geometry_),
        writer_(engine.scene(), engine.pieces(), geometry_),
        ignored_(engine.scene()),
        chain_(engine.scene(), engine.index(), geometry_, cones_, source_,
               source_sides_, blockers_, ignored_,
               engine.path() == ContourPath::kCheckedChain) {}

  [[nodiscard]] const ChainCounts& chain_counts() const {
    return chain_.counts();
  }

  void StartBlock(std::span<const Receiver> receivers) {
    in_block_ = receivers.size() > 1;
    if (!in_block_) return;
    cuts_.Clear();
    shared_edges_.Clear();
    block_box_ = {};
    block_normal_ = receivers.front().normal;
    for (const Receiver& receiver : receivers) {
      block_box_.Include(receiver.position);
      if (receiver.normal != receivers.front().normal) block_normal_.reset();
    }
  }

  void Build(const ContourQuery& query, Contour& contour) {
    StopIfAsked(query.stop);
    const RoundUpward rounding;
    if constexpr (kKind == PredicateKind::kDisplaced)
      geometry_.SetDisplacement(query.displacement);
    geometry_.SetReceiver(query.receiver.position, query.receiver.normal);
    cones_.SetReceiver(query.whole_sphere);
    ignored_.SetOnFace(FaceNumber(query.receiver.on_face));
    arcs_of_all_.clear();
    ends_.clear();
    source_count_ = 0;
    blocker_count_ = 0;
    if (!query.only_source.valid()) {
      for (const EmitterId e : engine_.emitters().ids()) {
        StopIfAsked(query.stop);
        const ContourEngine::Emitter& emitter = engine_.emitters()[e];
        if (!StartSource(emitter.facet)) continue;
        // What a block shares leaves out what is below the horizon.
        const bool shares = in_block_ && !query.whole_sphere;
        FindArcs(emitter.shafts, query, shares ? e : EmitterId());
        FinishSource(emitter.facet);
      }
    } else {
      const FaceId face = IndexOf(query.only_source);
      for (const FacetId f : FacetsOf(FacesOf(engine_.scene())[face])) {
        if (!StartSource(f)) continue;
        FindArcs(engine_.ShaftsTo(f), query, EmitterId());
        FinishSource(f);
      }
    }
    const std::size_t all_arcs = arcs_of_all_.size();
    if (query.join_sources && ends_.size() > 1) Join();
    writer_.Start(contour);
    contour.is_joined = arcs_of_all_.size() < all_arcs;
    std::size_t first = 0;
    for (const SourceEnd& source : ends_) {
      writer_.WriteSource(
          source.facet,
          std::span(arcs_of_all_).subspan(first, source.end - first));
      first = source.end;
    }
    contour.statistics = geometry_.statistics();
    contour.statistics.sources = source_count_;
    contour.statistics.blockers = blocker_count_;
    contour.statistics.arcs = contour.arcs.size();
  }

 private:
  /// The arcs of a facet end before entry `end` of all arcs, where those of
  /// the next one begin.
  struct SourceEnd {
    FacetId facet;
    std::size_t end = 0;
  };

  /// False if nothing of the facet can be seen.
  bool StartSource(FacetId facet) {
    if (ignored_.IsIgnored(facet) ||
        cones_.ReceiverSide(engine_.pieces().FirstPieceOf(facet)) !=
            Sign::kNegative ||
        !source_.SetSource(facet)) {
      return false;
    }
    blockers_.Start();
    ++source_count_;
    return true;
  }

  /// Finds the arcs of a source behind what lies towards it. emitter: the
  /// source, if a block of receivers shares what it finds; else none.
  void FindArcs(const ShaftSource& shafts, const ContourQuery& query,
                EmitterId emitter) {
    std::optional<Vector3> normal;
    if (!query.whole_sphere) normal = query.receiver.normal;
    const Shaft shaft(shafts, Box::Of(query.receiver.position), normal);
    if (UsesChain(shaft)) {
      FindArcsByChain(shaft, emitter);
      return;
    }
    const auto add = [this](int piece) { AddPiece(PieceId(piece)); };
    if (emitter.valid()) {
      engine_.tree().Visit(shaft, CutOf(emitter), add);
    } else {
      engine_.tree().Visit(shaft, add);
    }
    arcs_.AppendArcs(arcs_of_all_);
    blocker_count_ += blockers_.parts().size();
  }

  /// Whether the chain is the cheaper path. It is where meshes lie towards the
  /// source: most of their edges are inner. How receivers are grouped does not
  /// matter, since it must not change what is summed in double.
  [[nodiscard]] bool UsesChain(const Shaft& shaft) const {
    if (kKind == PredicateKind::kUnfiltered) return false;
    switch (engine_.path()) {
      case ContourPath::kBlockers:
        return false;
      case ContourPath::kChain:
      case ContourPath::kCheckedChain:
        return true;
      case ContourPath::kByCost:
        break;
    }
    return engine_.index().silhouettes().CountNear(shaft) >= kManyInnerEdges;
  }

  void FindArcsByChain(const Shaft& shaft, EmitterId emitter) {
    if (!emitter.valid()) {
      chain_.AppendArcs(shaft, nullptr, arcs_of_all_);
      return;
    }
    shared_edges_.Cover(engine_.emitters().size());
    if (!shared_edges_.Has(emitter)) shared_edges_.Renew(emitter).Start();
    SharedEdges& shared = shared_edges_[emitter];
    chain_.AppendArcs(shaft,
                      shared.Get(engine_.index().silhouettes(),
                                 BlockShaft(emitter), block_box_),
                      arcs_of_all_);
    shared.Measure(chain_.looked_at());
  }

  void AddPiece(PieceId piece) {
    ImageBox box;
    if (!blockers_.MayBlock(piece, box)) return;
    const Piece& p = engine_.pieces().pieces()[piece];
    if (!ignored_.IsIgnored(p.facet)) blockers_.Add(piece, box);
  }

  void FinishSource(FacetId facet) {
    ends_.push_back({facet, arcs_of_all_.size()});
  }

  /// Takes out the arcs between sources of equal emission.
  void Join() {
    join_.FindPairs(arcs_of_all_, dropped_);
    std::size_t kept = 0;
    std::size_t next = 0;
    for (SourceEnd& source : ends_) {
      for (; next < source.end; ++next) {
        if (!dropped_[next]) arcs_of_all_[kept++] = arcs_of_all_[next];
      }
      source.end = kept;
    }
    arcs_of_all_.resize(kept);
  }

  /// Holds the shafts of all receivers of the block.
  [[nodiscard]] Shaft BlockShaft(EmitterId emitter) const {
    return {engine_.emitters()[emitter].shafts, block_box_, block_normal_};
  }

  /// What the block's receivers share.
  const TreeCut& CutOf(EmitterId emitter) {
    cuts_.Cover(engine_.emitters().size());
    if (!cuts_.Has(emitter))
      engine_.tree().Narrow(BlockShaft(emitter), cuts_.Renew(emitter));
    return cuts_[emitter];
  }

  const ContourEngine& engine_;
  BasicViewGeometry<kKind> geometry_;
  ConeMaker<BasicViewGeometry<kKind>> cones_;
  SourceCones<BasicViewGeometry<kKind>> source_;
  DirectionSides<BasicViewGeometry<kKind>> source_sides_;
  BlockerParts<BasicViewGeometry<kKind>> blockers_;
  SourceContour<BasicViewGeometry<kKind>> arcs_;
  SourceJoin<BasicViewGeometry<kKind>> join_;
  ContourWriter<BasicViewGeometry<kKind>> writer_;
  std::vector<ViewArc> arcs_of_all_;  ///< of the receiver's sources, in order
  std::vector<SourceEnd> ends_;
  std::vector<bool> dropped_;  ///< per arc
  IgnoredFacetCache ignored_;
  ChainContour<BasicViewGeometry<kKind>> chain_;
  std::uint64_t source_count_ = 0;
  std::uint64_t blocker_count_ = 0;

  bool in_block_ = false;
  Box block_box_;
  std::optional<Vector3> block_normal_;    ///< if all receivers share it
  StampedTable<TreeCut, EmitterId> cuts_;  ///< of the block
  StampedTable<SharedEdges, EmitterId> shared_edges_;  ///< likewise
};

template <PredicateKind kKind>
BasicContourBuilder<kKind>::BasicContourBuilder(const ContourEngine& engine)
    : impl_(std::make_unique<Impl>(engine)) {}

template <PredicateKind kKind>
BasicContourBuilder<kKind>::~BasicContourBuilder() = default;

template <PredicateKind kKind>
BasicContourBuilder<kKind>::BasicContourBuilder(
    BasicContourBuilder&&) noexcept = default;

template <PredicateKind kKind>
BasicContourBuilder<kKind>& BasicContourBuilder<kKind>::operator=(
    BasicContourBuilder&&) noexcept = default;

template <PredicateKind kKind>
void BasicContourBuilder<kKind>::StartBlock(
    std::span<const Receiver> receivers) {
  impl_->StartBlock(receivers);
}

template <PredicateKind kKind>
void BasicContourBuilder<kKind>::Build(const ContourQuery& query,
                                       Contour& contour) {
  impl_->Build(query, contour);
}

template <PredicateKind kKind>
const ChainCounts& BasicContourBuilder<kKind>::chain_counts() const {
  return impl_->chain_counts();
}

template class BasicContourBuilder<PredicateKind::kExact>;
template class BasicContourBuilder<PredicateKind::kUnfiltered>;
template class BasicContourBuilder<PredicateKind::kDisplaced>;

}  // namespace truelux
