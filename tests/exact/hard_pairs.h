// SPDX-License-Identifier: GPL-3.0-or-later
// Double-doubles with trouble in them, and how far a result is off.

#ifndef TRUELUX_TESTS_EXACT_HARD_PAIRS_H_
#define TRUELUX_TESTS_EXACT_HARD_PAIRS_H_

#include <cmath>

#include "exact/double_double.h"
#include "support/portable_random.h"
#include "support/real.h"

namespace truelux::testing {

inline ShortReal ToReal(const DoubleDouble& x) {
  return ShortReal(x.high) + ShortReal(x.low);
}

/// |computed - truth| / (|truth| unit).
inline double RelativeError(const ShortReal& computed, const ShortReal& truth,
                            double unit) {
  if (truth.ToDouble() == 0) return computed.ToDouble() == 0 ? 0 : HUGE_VAL;
  return (Abs(computed - truth) / (Abs(truth) * ShortReal(unit))).ToDouble();
}

/// Double-doubles with trouble in them: full and sparse mantissas, low parts
/// of exactly half an ulp, of zero, far below the high part.
class HardPairs {
 public:
  explicit HardPairs(std::uint64_t seed) : random_(seed) {}

  DoubleDouble Next(int max_exponent) {
    const int exponent = random_.Integer(-max_exponent, max_exponent);
    double high = std::ldexp(1 + Mantissa(), exponent);
    if (random_.OneIn(2)) high = -high;
    const double half_ulp =
        std::ldexp(1.0, std::ilogb(high) - 53) * (random_.OneIn(2) ? 1 : -1);
    double low = half_ulp * Mantissa();
    if (random_.OneIn(6)) low = 0;
    if (random_.OneIn(6)) low = half_ulp * (1 - 0x1p-53);
    if (random_.OneIn(8)) low *= 0x1p-40;
    return FastTwoSum(high, low);
  }

  /// A number whose sum with x cancels in most bits.
  DoubleDouble NextNear(const DoubleDouble& x) {
    DoubleDouble y =
        FastTwoSum(-random_.Nudge(x.high), x.low * random_.Uniform(-1.5, 1.5));
    if (random_.OneIn(4) && x.low != 0)
      y = FastTwoSum(-x.high, -random_.Nudge(x.low));
    return y;
  }

  PortableRandom& random() { return random_; }

 private:
  double Mantissa() {
    switch (random_.Integer(0, 4)) {
      case 0:
        return 0;
      case 1:
        return 1 - std::ldexp(1.0, random_.Integer(-52, -48));
      case 2:
        return std::ldexp(1.0, random_.Integer(-52, -1));
      default:
        return random_.Unit();
    }
  }

  PortableRandom random_;
};

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_EXACT_HARD_PAIRS_H_
