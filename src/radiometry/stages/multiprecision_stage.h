// SPDX-License-Identifier: GPL-3.0-or-later
// Irradiance at any precision, from exact data, with a proven bound.

#ifndef TRUELUX_RADIOMETRY_STAGES_MULTIPRECISION_STAGE_H_
#define TRUELUX_RADIOMETRY_STAGES_MULTIPRECISION_STAGE_H_

#include <array>
#include <vector>

#include "exact/multiprecision.h"
#include "radiometry/evaluation_query.h"
#include "radiometry/stages/exact_sum.h"
#include "radiometry/weighted_contour.h"

namespace truelux {

/// The sum over the arcs of a contour, or over their ends.
ExactSum ExactSumOf(const WeightedContour& contour,
                    const EvaluationQuery& evaluation,
                    const HorizonPlanes& on_horizon);

/// lower <= E <= upper.
struct Enclosure {
  Multiprecision lower;
  Multiprecision upper;
};

/// Rounds an exact sum at growing precisions.
///
/// Both closed forms are sums of terms c * atan2(y, x), where c is n.N /
/// (|n| |N|) of the term's plane or 1, and one of y and x carries the factor
/// |N|; the rest are exact numbers. At p bits only |N|, c, the angle, the
/// weights and the sums are rounded, in Arb's balls, which keep the enclosure
/// [docs/errors.md section 6].
class MultiprecisionStage {
 public:
  /// Requires at least one term.
  MultiprecisionStage(ExactSum sum, Emission emission);

  /// The sum over the arcs of a contour, or over their ends. Requires at least
  /// one lit source.
  MultiprecisionStage(const WeightedContour& contour,
                      const EvaluationQuery& evaluation,
                      const HorizonPlanes& on_horizon);

  /// E per channel. precision: p >= 64 bits.
  [[nodiscard]] std::array<Enclosure, 3> Evaluate(mpfr_prec_t precision) const;

 private:
  ExactSum sum_;
  Emission emission_;
};

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_STAGES_MULTIPRECISION_STAGE_H_
