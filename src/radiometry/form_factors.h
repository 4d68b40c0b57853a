// SPDX-License-Identifier: GPL-3.0-or-later
// The form factors of all emitting faces, from what is seen of them together.

#ifndef TRUELUX_RADIOMETRY_FORM_FACTORS_H_
#define TRUELUX_RADIOMETRY_FORM_FACTORS_H_

#include "truelux/form_factors.h"

#include "radiometry/evaluation_query.h"
#include "visibility/arrangement/angular_spans.h"
#include "visibility/contour.h"

namespace truelux {

struct EvaluationWorkspace;

/// What EvaluateContour gives for each emitting face with query.only_source
/// that face, bit for bit. query.only_source is 0, and `contour` is that of all
/// sources, not joined, in the order of their facets. Of `evaluation` the
/// emission does not count.
FormFactorTable FormFactorsOf(const ContourQuery& query, const Contour& contour,
                              const EvaluationQuery& evaluation,
                              EvaluationWorkspace& workspace);

/// The same as EvaluateSpans gives, from the spans of all sources.
FormFactorTable FormFactorsOf(const ContourQuery& query,
                              const AngularSpans& spans,
                              const EvaluationQuery& evaluation);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_FORM_FACTORS_H_
