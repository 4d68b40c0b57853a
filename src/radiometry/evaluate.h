// SPDX-License-Identifier: GPL-3.0-or-later
// Visible contour -> irradiance.

#ifndef TRUELUX_RADIOMETRY_EVALUATE_H_
#define TRUELUX_RADIOMETRY_EVALUATE_H_

#include <vector>

#include "truelux/irradiance.h"

#include "radiometry/evaluation_query.h"
#include "visibility/contour.h"

namespace truelux {

struct EvaluationWorkspace;

/// What a facet's light is weighted with, as a source of this query: the
/// emission of its face, or 1 if query.only_source is set.
Rgb WeightOf(const ContourQuery& query, FacetId facet);

/// Makes `weights` those of the contour's sources, one after the other.
void FindWeights(const ContourQuery& query, const Contour& contour,
                 std::vector<Rgb>& weights);

/// Sum over the contour's sources of M_source * F_source, per channel, where
/// M is the emission of the source's face (or 1 if query.only_source is set).
///
/// kCertified  the binary64 nearest to the true sum: double-double with a
///             running bound, then Arb with growing precision until the
///             enclosure rounds one way; a midpoint still enclosed at 4096
///             bits or more is a tie and goes to even.
/// kDouble     double with a running bound on |error|, rounded up. kAuto: where
///             HasWideBound, for each source the formula with the smallest
///             bound, unless the contour is joined. A formula by name: what it
///             gives; NaN and an infinite bound where it does not apply.
/// The statistics are the contour's, with the evaluation's added. workspace
/// (evaluation_workspace.h) is memory to work in, for one thread at a time.
Irradiance EvaluateContour(const ContourQuery& query, const Contour& contour,
                           const EvaluationQuery& evaluation,
                           EvaluationWorkspace& workspace);

/// The same with a workspace of its own.
Irradiance EvaluateContour(const ContourQuery& query, const Contour& contour,
                           const EvaluationQuery& evaluation);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_EVALUATE_H_
