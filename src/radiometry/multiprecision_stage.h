// Irradiance at any precision, from exact data, with a proven bound.

#ifndef TRUELUX_RADIOMETRY_MULTIPRECISION_STAGE_H_
#define TRUELUX_RADIOMETRY_MULTIPRECISION_STAGE_H_

#include <array>
#include <vector>

#include "exact/multiprecision.h"
#include "radiometry/weighted_contour.h"

namespace truelux {

/// lower <= E <= upper.
struct Enclosure {
  Multiprecision lower;
  Multiprecision upper;
};

/// A contour with everything that is rational evaluated exactly, once.
///
/// Both closed forms are sums of terms c * atan2(y, x), where c is n.N /
/// (|n| |N|) of the term's plane or 1, and one of y and x carries the factor
/// |N|; the rest are exact numbers. At p bits only |N|, c, the angle and the
/// sums are rounded.
class MultiprecisionStage {
 public:
  /// Requires at least one lit source.
  MultiprecisionStage(const WeightedContour& contour,
                      const EvaluationQuery& evaluation,
                      const std::vector<bool>& on_horizon);

  /// E per channel, with an error of at most (k + s + 16) 2^-p times the sum
  /// of the magnitudes of all its terms; k terms, s sources [docs/errors.md
  /// section 6]. precision: p >= 64 bits.
  [[nodiscard]] std::array<Enclosure, 3> Evaluate(mpfr_prec_t precision) const;

 private:
  struct Plane {
    Exact normal_square;  ///< N.N
    Exact cosine_part;    ///< n.N
    Exact both_squares;   ///< (N.N) (n.n)
  };

  /// sign * c * atan2(y, x)
  struct Term {
    std::size_t plane = 0;
    Exact y;
    Exact x;
    bool length_on_y = false;  ///< whether y or x is to be multiplied by |N|
    bool has_cosine = true;    ///< whether c is the cosine, or 1
    bool negative = false;
  };

  struct Source {
    Rgb weight{};
    std::vector<Term> terms;
  };

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

  [[nodiscard]] Sum SumOfTerms(const Source& source,
                               const std::vector<RoundedPlane>& planes,
                               mpfr_prec_t precision) const;
  void ToIrradiance(mpfr_prec_t precision, Multiprecision& x,
                    mpfr_rnd_t rounding) const;

  Emission emission_;
  std::vector<Plane> planes_;
  std::vector<Source> sources_;
  std::size_t term_count_ = 0;
};

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_MULTIPRECISION_STAGE_H_
