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
/// weights and the sums are rounded.
class MultiprecisionStage {
 public:
  /// Requires at least one term.
  MultiprecisionStage(ExactSum sum, Emission emission);

  /// The sum over the arcs of a contour, or over their ends. Requires at least
  /// one lit source.
  MultiprecisionStage(const WeightedContour& contour,
                      const EvaluationQuery& evaluation,
                      const HorizonPlanes& on_horizon);

  /// E per channel, with an error of at most (k + s + 16) 2^-p times the sum
  /// of the magnitudes of all its terms; k terms, s groups of one weight
  /// [docs/errors.md section 6]. precision: p >= 64 bits.
  [[nodiscard]] std::array<Enclosure, 3> Evaluate(mpfr_prec_t precision) const;

 private:
  /// A sum of terms and the sum of their magnitudes, rounded up.
  struct Sum {
    Multiprecision value;
    Multiprecision magnitude;
  };

  /// |N| and n.N / (|n| |N|) at one precision.
  struct RoundedPlane {
    Multiprecision length;
    Multiprecision cosine;
  };

  using RoundedPlanes = IdVector<ExactPlaneId, RoundedPlane>;

  [[nodiscard]] static Sum SumOfTerms(const WeightedTerms& group,
                                      const RoundedPlanes& planes,
                                      mpfr_prec_t precision);
  void ToIrradiance(mpfr_prec_t precision, Multiprecision& x,
                    mpfr_rnd_t rounding) const;

  ExactSum sum_;
  Emission emission_;
  std::size_t term_count_ = 0;
};

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_STAGES_MULTIPRECISION_STAGE_H_
