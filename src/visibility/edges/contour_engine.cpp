// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/edges/contour_engine.h"

#include <algorithm>
#include <optional>

#include "base/stop.h"
#include "scene/emitters.h"
#include "scene/scene_access.h"
#include "visibility/chain/chain_contour.h"
#include "visibility/edges/block_share.h"
#include "visibility/edges/blocker_parts.h"
#include "visibility/edges/cone.h"
#include "visibility/edges/contour_writer.h"
#include "visibility/edges/direction_sides.h"
#include "visibility/edges/source_cones.h"
#include "visibility/edges/source_contour.h"
#include "visibility/edges/source_intervals.h"
#include "visibility/edges/source_join.h"

namespace truelux {

namespace {

/// The chain is made where so many edges that can be inner are near a source.
/// Three boxes have 36. Rooms with 32 and 128 boxes take 0.75 times as long as
/// by blockers, rooms with 8 the same; one furnished with 29 boxes takes 0.99 of
/// the instructions with 36, and 1.07 with 24.
constexpr std::size_t kManyPairedEdges = 36;

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
    emitters_.push_back({facet, ShaftsTo({&facet, 1})});
  }
  group_of_.resize(facets.size(), -1);
  if (path == ContourPath::kBlockers) return;
  for (EmitterGroup& group : EmitterGroupsOf(scene, index_.pieces())) {
    for (const FacetId facet : group.facets)
      group_of_[facet] = static_cast<int>(groups_.size());
    ShaftSource shafts = ShaftsTo(group.facets);
    groups_.push_back({std::move(group), std::move(shafts)});
  }
}

ShaftSource ContourEngine::ShaftsTo(std::span<const FacetId> facets) const {
  std::vector<Triangle> triangles;
  for (const FacetId facet : facets) {
    for (const Triangle& triangle :
         TrianglesOf(scene_, FacetsOf(scene_)[facet])) {
      triangles.push_back(triangle);
    }
  }
  const RoundUpward rounding;
  return {scene_.vertices(), triangles};
}

Contour ContourEngine::Build(const ContourQuery& query) const {
  Contour contour;
  ContourBuilder(*this).Build(query, contour);
  return contour;
}

// One object a thread: its size does not matter.
template <PredicateKind kKind>
// NOLINTNEXTLINE(clang-analyzer-optin.performance.Padding)
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
        intervals_(geometry_, cones_, source_, source_sides_),
        arcs_(engine.pieces(), geometry_, cones_, source_, blockers_,
              intervals_),
        join_(engine.scene(), engine.pieces(), geometry_),
        writer_(engine.scene(), engine.pieces(), geometry_),
        ignored_(engine.scene()),
        chain_(engine.scene(), engine.index(), geometry_, cones_, source_,
               intervals_, blockers_, ignored_,
               engine.path() == ContourPath::kCheckedChain) {}

  [[nodiscard]] ChainCounts chain_counts() const {
    ChainCounts counts = chain_.counts();
    counts.diagonals = intervals_.on_diagonals();
    counts.touching = intervals_.touching();
    return counts;
  }

  void StartBlock(std::span<const Receiver> receivers) {
    block_.Start(receivers, engine_.emitters().size());
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
    ranges_.clear();
    is_joined_ = false;
    source_count_ = 0;
    blocker_count_ = 0;
    if (query.only_source.valid()) {
      BuildOnly(query);
    } else {
      BuildAll(query);
    }
    const std::size_t all_arcs = arcs_of_all_.size();
    if (query.join_sources && ranges_.size() > 1) Join();
    writer_.Start(contour);
    contour.is_joined = is_joined_ || arcs_of_all_.size() < all_arcs;
    // Groups come before what lies between their facets.
    std::ranges::sort(ranges_, {}, &SourceRange::facet);
    for (const SourceRange& source : ranges_) {
      writer_.WriteSource(
          source.facet, std::span(arcs_of_all_)
                            .subspan(source.begin, source.end - source.begin));
    }
    contour.statistics = geometry_.statistics();
    contour.statistics.sources = source_count_;
    contour.statistics.blockers = blocker_count_;
    contour.statistics.arcs = contour.arcs.size();
  }

 private:
  /// The arcs of a source are entries `begin` to before `end` of all arcs.
  struct SourceRange {
    FacetId facet;
    std::size_t begin = 0;
    std::size_t end = 0;
  };

  /// The group whose chain is made for a facet; null if a facet has its own.
  [[nodiscard]] const ContourEngine::Group* GroupOf(FacetId facet) const {
    return kKind == PredicateKind::kExact ? engine_.GroupOf(facet) : nullptr;
  }

  /// Finds the arcs of the face that is named, in the order in which they are
  /// found among all that emits, so that sums in double are the same: a facet
  /// of a group from a chain without the group's other facets.
  void BuildOnly(const ContourQuery& query) {
    const FaceId face = IndexOf(query.only_source);
    for (const FacetId facet : FacetsOf(FacesOf(engine_.scene())[face])) {
      const auto* const group = GroupOf(facet);
      const std::span<const FacetId> alone(&facet, 1);
      if (!StartSource(group != nullptr ? group->emitters.facets : alone) ||
          (group != nullptr && !NarrowTo(facet))) {
        continue;
      }
      FindArcs(engine_.ShaftsTo(alone), query, EmitterId(), group != nullptr);
      FinishSource(facet);
    }
  }

  /// Makes one of the facets that have been set the source.
  bool NarrowTo(FacetId facet) {
    const std::span<const FacetId> facets = source_.facets();
    const auto i = static_cast<std::size_t>(std::ranges::find(facets, facet) -
                                            facets.begin());
    return Narrow(i, i + 1);
  }

  /// Makes some of the facets that have been set the source. False if nothing
  /// of them can be seen.
  bool Narrow(std::size_t first, std::size_t end) {
    if (!source_.Narrow(first, end)) return false;
    blockers_.Start();
    return true;
  }

  /// Finds the arcs of all that emits.
  void BuildAll(const ContourQuery& query) {
    // What a block shares leaves out what is below the horizon.
    const bool shares = block_.shares() && !query.whole_sphere;
    for (const EmitterId e : engine_.emitters().ids()) {
      StopIfAsked(query.stop);
      const ContourEngine::Emitter& emitter = engine_.emitters()[e];
      const EmitterId sharing = shares ? e : EmitterId();
      if (const auto* const group = GroupOf(emitter.facet)) {
        const bool is_first = group->emitters.facets.front() == emitter.facet;
        if (is_first) BuildGroup(*group, query, sharing);
        continue;
      }
      if (!StartSource({&emitter.facet, 1})) continue;
      FindArcs(emitter.shafts, query, sharing, false);
      FinishSource(emitter.facet);
    }
  }

  /// Finds the arcs of the facets of a group, from one chain: of those that
  /// emit the same as one source, or of each.
  void BuildGroup(const ContourEngine::Group& group, const ContourQuery& query,
                  EmitterId emitter) {
    if (!StartSource(group.emitters.facets)) return;
    const Shaft shaft = ShaftOf(group.shafts, query);
    MakeChain(shaft, group.shafts, emitter);
    const std::span<const FacetId> facets = source_.facets();
    const auto add = [&](std::size_t first, std::size_t end) {
      StopIfAsked(query.stop);
      if (!Narrow(first, end)) return;
      chain_.AppendArcs(arcs_of_all_);
      ++source_count_;
      FinishSource(facets[first]);
    };
    if (query.join_sources) {
      is_joined_ = true;
      std::size_t first = 0;
      for (const std::size_t end : group.emitters.alike_ends) {
        add(first, end);
        first = end;
      }
    } else {
      for (std::size_t i = 0; i < facets.size(); ++i)
        add(i, i + 1);
    }
  }

  /// False if nothing of the facets, which lie in one plane, can be seen.
  bool StartSource(std::span<const FacetId> facets) {
    const FacetId first = facets.front();
    if (ignored_.IsIgnored(first) ||
        cones_.ReceiverSide(engine_.pieces().FirstPieceOf(first)) !=
            Sign::kNegative ||
        !source_.SetSource(facets)) {
      return false;
    }
    blockers_.Start();
    return true;
  }

  /// Finds the arcs of a source behind what lies towards it. emitter: the
  /// source, if a block of receivers shares what it finds; else none.
  /// in_group: go by a chain, as for the whole group.
  void FindArcs(const ShaftSource& shafts, const ContourQuery& query,
                EmitterId emitter, bool in_group) {
    ++source_count_;
    const Shaft shaft = ShaftOf(shafts, query);
    if (in_group || UsesChain(shaft)) {
      MakeChain(shaft, shafts, emitter);
      chain_.AppendArcs(arcs_of_all_);
      return;
    }
    const auto add = [this](int piece) { AddPiece(PieceId(piece)); };
    if (emitter.valid()) {
      block_.CutOf(emitter, engine_.tree(), shafts)
          .Visit(engine_.tree(), shaft, add);
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
    if (engine_.path() != ContourPath::kByCost)
      return engine_.path() != ContourPath::kBlockers;
    return engine_.index().silhouettes().HasNear(shaft, kManyPairedEdges);
  }

  /// Makes the chain of the source that has been set. emitter: as of FindArcs.
  void MakeChain(const Shaft& shaft, const ShaftSource& shafts,
                 EmitterId emitter) {
    if (!emitter.valid()) {
      chain_.MakeChain(shaft, shafts.box(), nullptr);
      return;
    }
    SharedEdges& shared = block_.EdgesOf(emitter);
    const auto make_shaft = [&] { return block_.ShaftTo(shafts); };
    chain_.MakeChain(
        shaft, shafts.box(),
        shared.Get(engine_.index().silhouettes(), make_shaft, block_.box()));
    shared.Measure(chain_.looked_at());
  }

  static Shaft ShaftOf(const ShaftSource& shafts, const ContourQuery& query) {
    std::optional<Vector3> normal;
    if (!query.whole_sphere) normal = query.receiver.normal;
    return {shafts, Box::Of(query.receiver.position), normal};
  }

  void AddPiece(PieceId piece) {
    ImageBox box;
    if (!blockers_.MayBlock(piece, box)) return;
    const Piece& p = engine_.pieces().pieces()[piece];
    if (!ignored_.IsIgnored(p.facet)) blockers_.Add(piece, box);
  }

  void FinishSource(FacetId facet) {
    const std::size_t begin = ranges_.empty() ? 0 : ranges_.back().end;
    ranges_.push_back({facet, begin, arcs_of_all_.size()});
  }

  /// Takes out the arcs between sources of equal emission.
  void Join() {
    join_.FindPairs(arcs_of_all_, dropped_);
    std::size_t kept = 0;
    std::size_t next = 0;
    for (SourceRange& source : ranges_) {
      source.begin = kept;
      for (; next < source.end; ++next) {
        if (!dropped_[next]) arcs_of_all_[kept++] = arcs_of_all_[next];
      }
      source.end = kept;
    }
    arcs_of_all_.resize(kept);
  }

  const ContourEngine& engine_;
  BasicViewGeometry<kKind> geometry_;
  ConeMaker<BasicViewGeometry<kKind>> cones_;
  SourceCones<BasicViewGeometry<kKind>> source_;
  DirectionSides<BasicViewGeometry<kKind>> source_sides_;
  BlockerParts<BasicViewGeometry<kKind>> blockers_;
  SourceIntervals<BasicViewGeometry<kKind>> intervals_;
  SourceContour<BasicViewGeometry<kKind>> arcs_;
  SourceJoin<BasicViewGeometry<kKind>> join_;
  ContourWriter<BasicViewGeometry<kKind>> writer_;
  std::vector<ViewArc> arcs_of_all_;  ///< of the receiver's sources, in order
  std::vector<SourceRange> ranges_;
  std::vector<bool> dropped_;  ///< per arc
  bool is_joined_ = false;     ///< some of the sources are groups
  IgnoredFacetCache ignored_;
  ChainContour<BasicViewGeometry<kKind>> chain_;
  std::uint64_t source_count_ = 0;
  std::uint64_t blocker_count_ = 0;

  BlockShare block_;
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
ChainCounts BasicContourBuilder<kKind>::chain_counts() const {
  return impl_->chain_counts();
}

template class BasicContourBuilder<PredicateKind::kExact>;
template class BasicContourBuilder<PredicateKind::kUnfiltered>;
template class BasicContourBuilder<PredicateKind::kDisplaced>;

}  // namespace truelux
