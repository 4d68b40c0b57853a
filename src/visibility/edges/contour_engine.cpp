// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/edges/contour_engine.h"

#include <algorithm>
#include <optional>

#include "base/stamped_table.h"
#include "base/stop.h"
#include "scene/emitters.h"
#include "scene/scene_access.h"
#include "visibility/edges/blocker_parts.h"
#include "visibility/edges/cone.h"
#include "visibility/edges/contour_writer.h"
#include "visibility/edges/direction_sides.h"
#include "visibility/edges/source_cones.h"
#include "visibility/edges/source_contour.h"
#include "visibility/edges/source_join.h"

namespace truelux {

ContourEngine::ContourEngine(const Scene& scene)
    : scene_(scene),
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
        ignored_(engine.scene()) {}

  void StartBlock(std::span<const Receiver> receivers) {
    in_block_ = receivers.size() > 1;
    if (!in_block_) return;
    cuts_.Clear();
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
        AddPieces(emitter.shafts, query,
                  query.whole_sphere ? nullptr : CutOf(e));
        FinishSource(emitter.facet);
      }
    } else {
      const FaceId face = IndexOf(query.only_source);
      for (const FacetId f : FacetsOf(FacesOf(engine_.scene())[face])) {
        if (!StartSource(f)) continue;
        AddPieces(engine_.ShaftsTo(f), query, nullptr);
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

  /// Adds the blockers that lie towards a source. cut: null for none.
  void AddPieces(const ShaftSource& shafts, const ContourQuery& query,
                 const TreeCut* cut) {
    std::optional<Vector3> normal;
    if (!query.whole_sphere) normal = query.receiver.normal;
    const Shaft shaft(shafts, Box::Of(query.receiver.position), normal);
    const auto add = [this](int piece) { AddPiece(PieceId(piece)); };
    if (cut == nullptr) {
      engine_.tree().Visit(shaft, add);
    } else {
      engine_.tree().Visit(shaft, *cut, add);
    }
  }

  void AddPiece(PieceId piece) {
    ImageBox box;
    if (!blockers_.MayBlock(piece, box)) return;
    const Piece& p = engine_.pieces().pieces()[piece];
    if (!ignored_.IsIgnored(p.facet)) blockers_.Add(piece, box);
  }

  void FinishSource(FacetId facet) {
    arcs_.AppendArcs(arcs_of_all_);
    blocker_count_ += blockers_.parts().size();
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

  /// What the block's receivers share; null without a block.
  const TreeCut* CutOf(EmitterId emitter) {
    if (!in_block_) return nullptr;
    cuts_.Cover(engine_.emitters().size());
    if (!cuts_.Has(emitter)) {
      engine_.tree().Narrow(
          Shaft(engine_.emitters()[emitter].shafts, block_box_, block_normal_),
          cuts_.Renew(emitter));
    }
    return &cuts_[emitter];
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
  std::uint64_t source_count_ = 0;
  std::uint64_t blocker_count_ = 0;

  bool in_block_ = false;
  Box block_box_;
  std::optional<Vector3> block_normal_;    ///< if all receivers share it
  StampedTable<TreeCut, EmitterId> cuts_;  ///< of the block
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

template class BasicContourBuilder<PredicateKind::kExact>;
template class BasicContourBuilder<PredicateKind::kUnfiltered>;
template class BasicContourBuilder<PredicateKind::kDisplaced>;

}  // namespace truelux
