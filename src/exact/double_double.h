// Unevaluated sums of two doubles: about 106 bits with double's exponents.
//
// Every operation has a proven relative error, given as a multiple of
// kUnitSquared = u^2, u = 2^-53, valid in round-to-nearest as long as nothing
// overflows or underflows (Ball adds what underflow can cost). The algorithms
// and their proofs are those of
//   [JMP]   Joldes, Muller, Popescu: Tight and rigorous error bounds for basic
//           building blocks of double-word arithmetic, ACM TOMS 44(2), 2017.
// docs/errors.md section 3 lists the constants; a test holds every one of
// them against MPFR.

#ifndef TRUELUX_EXACT_DOUBLE_DOUBLE_H_
#define TRUELUX_EXACT_DOUBLE_DOUBLE_H_

#include <cmath>

namespace truelux {

/// The unit roundoff of binary64 and its square.
constexpr double kUnit = 0x1p-53;
constexpr double kUnitSquared = 0x1p-106;

/// The number high + low; high is the sum rounded to nearest.
struct DoubleDouble {
  double high = 0;
  double low = 0;

  friend bool operator==(const DoubleDouble&, const DoubleDouble&) = default;
};

/// a + b without error, |a| >= |b| or a = 0 ([JMP] Algorithm 1).
inline DoubleDouble FastTwoSum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a + b without error ([JMP] Algorithm 2).
inline DoubleDouble TwoSum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// a * b without error ([JMP] Algorithm 3).
inline DoubleDouble TwoProduct(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

inline DoubleDouble operator-(const DoubleDouble& x) {
  return {-x.high, -x.low};
}

/// Error <= 3 u^2 + 13 u^3 (relative; [JMP] Algorithm 6).
inline DoubleDouble operator+(const DoubleDouble& x, const DoubleDouble& y) {
  const DoubleDouble high = TwoSum(x.high, y.high);
  const DoubleDouble low = TwoSum(x.low, y.low);
  const DoubleDouble sum = FastTwoSum(high.high, high.low + low.high);
  return FastTwoSum(sum.high, low.low + sum.low);
}

/// Error <= 3 u^2 + 13 u^3 (relative).
inline DoubleDouble operator-(const DoubleDouble& x, const DoubleDouble& y) {
  return x + -y;
}

/// Error <= 2 u^2 (relative; [JMP] Algorithm 4).
inline DoubleDouble operator+(const DoubleDouble& x, double y) {
  const DoubleDouble sum = TwoSum(x.high, y);
  return FastTwoSum(sum.high, x.low + sum.low);
}

/// Error <= 2 u^2 (relative; [JMP] Algorithm 9).
inline DoubleDouble operator*(const DoubleDouble& x, double y) {
  const DoubleDouble product = TwoProduct(x.high, y);
  return FastTwoSum(product.high, std::fma(x.low, y, product.low));
}

/// Error <= 5 u^2 (relative; [JMP] Algorithm 12).
inline DoubleDouble operator*(const DoubleDouble& x, const DoubleDouble& y) {
  const DoubleDouble product = TwoProduct(x.high, y.high);
  const double cross =
      std::fma(x.low, y.high, std::fma(x.high, y.low, x.low * y.low));
  return FastTwoSum(product.high, product.low + cross);
}

/// Error <= 9.8 u^2 (relative; [JMP] Algorithm 18). Requires
/// 2^-900 <= |y| <= 2^900.
inline DoubleDouble operator/(const DoubleDouble& x, const DoubleDouble& y) {
  const double inverse = 1 / y.high;
  const DoubleDouble rest =
      FastTwoSum(std::fma(-y.high, inverse, 1.0), -(y.low * inverse));
  return x * (rest * inverse + inverse);
}

/// The square root. Error <= 4.2 u^2 (relative; docs/errors.md section 3).
/// Requires 2^-900 <= x <= 2^900.
inline DoubleDouble Sqrt(const DoubleDouble& x) {
  const double root = std::sqrt(x.high);
  const double rest = x.low + std::fma(-root, root, x.high);
  return FastTwoSum(root, rest / (2 * root));
}

/// Relative error of Atan2 [u^2]; the proof is docs/errors.md section 4.
constexpr double kAtan2Error = 32;

/// The angle of (x, y), in [-pi, pi] up to the error; 0 for (0, 0).
/// Error <= kAtan2Error u^2 (relative) + 2^-1060 (absolute). Requires
/// max(|x|, |y|) = 0 or in [2^-900, 2^900].
DoubleDouble Atan2(const DoubleDouble& y, const DoubleDouble& x);

}  // namespace truelux

#endif  // TRUELUX_EXACT_DOUBLE_DOUBLE_H_
