// SPDX-License-Identifier: GPL-3.0-or-later
// The irradiance by the two slow engines, from one exact map.

#ifndef TRUELUX_TESTS_SUPPORT_TWIN_VALUES_H_
#define TRUELUX_TESTS_SUPPORT_TWIN_VALUES_H_

#include <vector>

#include "truelux/irradiance.h"

#include "radiometry/evaluate.h"
#include "radiometry/stages/span_sum.h"
#include "visibility/arrangement/angular_spans.h"
#include "visibility/arrangement/arrangement_engine.h"
#include "visibility/arrangement/arrangement_view.h"

namespace truelux::testing {

/// What Oracle::Evaluate gives for Engine::kArrangement and for
/// Engine::kAngularSpans.
struct TwinValues {
  Rgb arrangement{};
  Rgb spans{};
};

/// Both values. The map takes nearly all the time of either engine, so that
/// both cost no more than one.
inline TwinValues TwinValuesOf(const Scene& scene, const Receiver& receiver) {
  const ContourQuery query{scene, receiver};
  const IdVector<FacetId, FacetView> facets = FacetViewsOf(query);
  const std::vector<ChartView> charts = ChartViewsOf(query, facets);
  return {
      EvaluateContour(query, ContourByArrangement(query, facets, charts), {})
          .value,
      EvaluateSpans(query, AngularSpansOf(facets, charts), {}).value};
}

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_SUPPORT_TWIN_VALUES_H_
