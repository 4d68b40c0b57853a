#include "visibility/contour_engine.h"

#include <algorithm>

#include "visibility/cone.h"
#include "visibility/contour_writer.h"
#include "visibility/source_contour.h"
#include "visibility/source_parts.h"

namespace truelux {
namespace {

bool Emits(const Face& face) {
  return std::ranges::any_of(face.emission, [](double m) { return m > 0; });
}

}  // namespace

ContourEngine::ContourEngine(const Scene& scene)
    : scene_(scene),
      pieces_(scene),
      triangle_normals_(
          FilteredTriangleNormals(scene.vertices(), scene.triangles())) {
  const auto facets = scene.facets();
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const auto face = static_cast<std::size_t>(facets[f].face);
    if (Emits(scene.faces()[face])) emitters_.push_back(static_cast<int>(f));
  }
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
            {engine.scene().vertices(), engine.scene().triangles(), {}, {}},
            engine.triangle_normals()),
        cones_(geometry_, engine.pieces()),
        parts_(engine.scene(), engine.pieces(), geometry_, cones_),
        arcs_(engine.pieces(), geometry_, cones_, parts_),
        writer_(engine.scene(), engine.pieces(), geometry_),
        ignored_(engine.scene()) {}

  void Build(const ContourQuery& query, Contour& contour) {
    const RoundUpward rounding;
    geometry_.SetReceiver(query.receiver.position, query.receiver.normal);
    cones_.SetReceiver();
    ignored_.SetOnFace(query.receiver.on_face);
    writer_.Start(contour);
    sources_ = 0;
    blockers_ = 0;
    if (query.only_source == 0) {
      for (const int facet : engine_.emitters())
        BuildSource(facet);
    } else {
      const Face& face =
          engine_.scene()
              .faces()[static_cast<std::size_t>(query.only_source - 1)];
      for (int f = 0; f < face.facet_count; ++f)
        BuildSource(face.first_facet + f);
    }
    contour.statistics = geometry_.statistics();
    contour.statistics.sources = sources_;
    contour.statistics.blockers = blockers_;
    contour.statistics.arcs = contour.arcs.size();
  }

 private:
  void BuildSource(int facet) {
    if (ignored_.IsIgnored(facet) ||
        cones_.ReceiverSide(engine_.pieces().FirstPieceOf(facet)) !=
            Sign::kNegative ||
        !parts_.SetSource(facet)) {
      return;
    }
    ++sources_;
    const auto pieces = engine_.pieces().pieces();
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      const int piece = static_cast<int>(p);
      if (!parts_.MayBlock(piece) || ignored_.IsIgnored(pieces[p].facet)) {
        continue;
      }
      parts_.AddBlocker(piece);
    }
    blockers_ += parts_.blockers().size();
    writer_.WriteSource(facet, arcs_.FindArcs());
  }

  const ContourEngine& engine_;
  BasicViewGeometry<kKind> geometry_;
  ConeMaker<BasicViewGeometry<kKind>> cones_;
  SourceParts<BasicViewGeometry<kKind>> parts_;
  SourceContour<BasicViewGeometry<kKind>> arcs_;
  ContourWriter<BasicViewGeometry<kKind>> writer_;
  IgnoredFacetCache ignored_;
  std::uint64_t sources_ = 0;
  std::uint64_t blockers_ = 0;
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
void BasicContourBuilder<kKind>::Build(const ContourQuery& query,
                                       Contour& contour) {
  impl_->Build(query, contour);
}

template class BasicContourBuilder<PredicateKind::kExact>;
template class BasicContourBuilder<PredicateKind::kUnfiltered>;

}  // namespace truelux
