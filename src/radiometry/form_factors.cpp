// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/form_factors.h"

#include <cassert>
#include <cstddef>
#include <vector>

#include "truelux/irradiance.h"

#include "radiometry/evaluate.h"
#include "radiometry/source_slice.h"
#include "radiometry/stages/span_sum.h"
#include "scene/emitters.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

/// One entry per face that emits, facets or not; evaluate(face) is its
/// form factor.
template <class Evaluate>
void AddFactors(const Scene& scene, const Evaluate& evaluate,
                FormFactorTable& table) {
  for (const FaceId face : FacesOf(scene).ids()) {
    if (!Emits(FacesOf(scene)[face])) continue;
    const Irradiance factor = evaluate(face);
    table.faces.push_back(
        {NumberOf(face).value(), factor.value[0], factor.bound[0]});
    table.statistics += factor.statistics;
  }
}

ContourQuery OnlySource(const ContourQuery& query, FaceId face) {
  ContourQuery only = query;
  only.only_source = NumberOf(face);
  return only;
}

/// For each face the vertices around which it is seen as a source, as indices
/// into spans.vertices.
IdVector<FaceId, std::vector<std::size_t>> VerticesOfFaces(
    const Scene& scene, const AngularSpans& spans) {
  IdVector<FaceId, std::vector<std::size_t>> vertices(scene.faces().size());
  for (std::size_t v = 0; v < spans.vertices.size(); ++v) {
    for (const AngularSpan& span : spans.vertices[v].spans) {
      if (!span.is_source) continue;
      auto& own = vertices[FaceOf(scene, span.facet)];
      if (own.empty() || own.back() != v) own.push_back(v);
    }
  }
  return vertices;
}

/// The spans around some vertices, with one face as the only source.
AngularSpans SpansOf(const Scene& scene, const AngularSpans& spans, FaceId face,
                     const std::vector<std::size_t>& vertices) {
  AngularSpans own;
  for (const std::size_t v : vertices) {
    SpanVertex& vertex = own.vertices.emplace_back(spans.vertices[v]);
    for (AngularSpan& span : vertex.spans)
      span.is_source = span.is_source && FaceOf(scene, span.facet) == face;
  }
  return own;
}

}  // namespace

FormFactorTable FormFactorsOf(const ContourQuery& query, const Contour& contour,
                              const EvaluationQuery& evaluation,
                              EvaluationWorkspace& workspace) {
  FormFactorTable table;
  table.statistics = contour.statistics;
  SourceSlicer slicer(contour);
  Contour slice;
  SourceId next(0);
  const auto evaluate = [&](FaceId face) {
    const SourceId first = next;
    while (next < contour.sources.end_id() &&
           FaceOf(query.scene, contour.sources[next].facet) == face) {
      ++next;
    }
    slicer.Take(first, next.value() - first.value(), slice);
    return EvaluateContour(OnlySource(query, face), slice, evaluation,
                           workspace);
  };
  AddFactors(query.scene, evaluate, table);
  assert(next == contour.sources.end_id());
  return table;
}

FormFactorTable FormFactorsOf(const ContourQuery& query,
                              const AngularSpans& spans,
                              const EvaluationQuery& evaluation) {
  FormFactorTable table;
  table.statistics = spans.statistics;
  const auto vertices = VerticesOfFaces(query.scene, spans);
  const auto evaluate = [&](FaceId face) {
    return EvaluateSpans(OnlySource(query, face),
                         SpansOf(query.scene, spans, face, vertices[face]),
                         evaluation);
  };
  AddFactors(query.scene, evaluate, table);
  return table;
}

}  // namespace truelux
