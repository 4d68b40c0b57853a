// SPDX-License-Identifier: GPL-3.0-or-later
// Angular spans -> irradiance: the sum of vertex tracing.

#ifndef TRUELUX_RADIOMETRY_STAGES_SPAN_SUM_H_
#define TRUELUX_RADIOMETRY_STAGES_SPAN_SUM_H_

#include "truelux/irradiance.h"

#include "radiometry/evaluate.h"
#include "radiometry/evaluation_query.h"
#include "visibility/arrangement/angular_spans.h"

namespace truelux {

/// The sum over all vertices v and the spans s around v of
/// (M(s) - M(prev(s))) F(v, edge at which s begins) (Stark & Riesenfeld 2000
/// equation (9)), per channel, with H of docs/method.md (11) and (12) for F.
/// M: WeightOf a source; 0 for all else.
///
/// The result is the binary64 nearest to the true sum, found in Arb with
/// growing precision as in EvaluateContour, also with Method::kDouble; the
/// bound is half the distance to the farther neighbour. Of `evaluation` only
/// the emission counts.
Irradiance EvaluateSpans(const ContourQuery& query, const AngularSpans& spans,
                         const EvaluationQuery& evaluation);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_STAGES_SPAN_SUM_H_
