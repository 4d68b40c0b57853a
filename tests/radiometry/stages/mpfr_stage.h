// SPDX-License-Identifier: GPL-3.0-or-later
// A twin of MultiprecisionStage that shares no arithmetic with it: plain MPFR,
// with a bound that was derived by hand.

#ifndef TRUELUX_TESTS_RADIOMETRY_STAGES_MPFR_STAGE_H_
#define TRUELUX_TESTS_RADIOMETRY_STAGES_MPFR_STAGE_H_

#include <array>
#include <cstddef>
#include <vector>

#include "truelux/irradiance.h"

#include "exact/multiprecision.h"
#include "radiometry/stages/exact_sum.h"
#include "radiometry/stages/multiprecision_stage.h"

namespace truelux::testing {

/// Same input and same meaning as MultiprecisionStage. Errors in units of 2^-p,
/// relative, first order:
///
/// - |N|: 1 for rounding N.N, halved by the root, 1 for the root: 1.5. Its
///   operand: 1.5 + 1 + 1 = 3.5. The other: 1.
/// - The angle: a factor rho on y/x changes the angle's logarithm by at most
///   |ln rho|, as d ln theta / d ln(y/x) = sin 2 theta / 2 theta, at most 1 in
///   magnitude: 4.5, and 1 for rounding: 5.5.
/// - c: 1.5 for the root, 1 for g, 1 for the quotient: 3.5. The product: 1.
///
/// So a term has the relative error 10. With k terms and s groups of one
/// weight: the sums inside the groups at most k - 1, the weight 1 for rounding,
/// the product with it 1, the sum over groups s - 1, the division by 2 pi 2,
/// each relative to the sum A of the magnitudes of all weighted terms:
/// k + s + 12 in all. 4 more cover the second order.
class MpfrStage {
 public:
  /// Requires at least one term.
  MpfrStage(ExactSum sum, Emission emission);

  /// E per channel, with an error of at most (k + s + 16) 2^-p A. precision:
  /// p >= 64 bits.
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

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_RADIOMETRY_STAGES_MPFR_STAGE_H_
