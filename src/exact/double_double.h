// SPDX-License-Identifier: GPL-3.0-or-later
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

#include <cassert>
#include <cmath>

namespace truelux {

/// The unit roundoff of binary64 and its square.
constexpr double kUnitRoundoff = 0x1p-53;
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

/// Whether 2^-900 <= |x| <= 2^900, where the errors of quotients and roots are
/// proven.
inline bool IsWithinBounds(const DoubleDouble& x) {
  const double size = std::fabs(x.high);
  return 0x1p-900 <= size && size <= 0x1p900;
}

/// Error <= 11 u^2 (relative; [JMP] Algorithm 17 with the last correction in
/// one step; docs/errors.md section 3). Requires 2^-900 <= |y| <= 2^900.
/// Underflow costs at most 2^-1070 / |y| besides.
inline DoubleDouble operator/(const DoubleDouble& x, const DoubleDouble& y) {
  assert(IsWithinBounds(y));
  const double quotient = x.high / y.high;
  const double rest =
      std::fma(-quotient, y.high, x.high) + std::fma(-quotient, y.low, x.low);
  return FastTwoSum(quotient, rest / y.high);
}

/// The square root. Error <= 4.2 u^2 (relative; docs/errors.md section 3).
/// Requires 2^-900 <= x <= 2^900.
inline DoubleDouble Sqrt(const DoubleDouble& x) {
  assert(IsWithinBounds(x) && x.high > 0);
  const double root = std::sqrt(x.high);
  const double rest = x.low + std::fma(-root, root, x.high);
  return FastTwoSum(root, rest / (2 * root));
}

/// What a b adds to the low part of a sum of products whose high part has
/// taken TwoProduct(a.high, b.high): its error and the mixed products. Error
/// <= 6 u^2 |a b|, docs/errors.md section 3.
inline double LowOfProduct(const DoubleDouble& a, const DoubleDouble& b,
                           double product_error) {
  return std::fma(a.low, b.high, std::fma(a.high, b.low, product_error));
}

/// a b + c d. Error <= 13 u^2 (|a b| + |c d|), docs/errors.md section 3.
inline DoubleDouble SumOfProducts(const DoubleDouble& a, const DoubleDouble& b,
                                  const DoubleDouble& c,
                                  const DoubleDouble& d) {
  const DoubleDouble first = TwoProduct(a.high, b.high);
  const DoubleDouble second = TwoProduct(c.high, d.high);
  const DoubleDouble high = TwoSum(first.high, second.high);
  const double low =
      LowOfProduct(a, b, first.low) + LowOfProduct(c, d, second.low);
  return FastTwoSum(high.high, high.low + low);
}

/// a b + c d + e f. Error <= 19 u^2 (|a b| + |c d| + |e f|), docs/errors.md
/// section 3.
inline DoubleDouble SumOfProducts(const DoubleDouble& a, const DoubleDouble& b,
                                  const DoubleDouble& c, const DoubleDouble& d,
                                  const DoubleDouble& e,
                                  const DoubleDouble& f) {
  const DoubleDouble first = TwoProduct(a.high, b.high);
  const DoubleDouble second = TwoProduct(c.high, d.high);
  const DoubleDouble third = TwoProduct(e.high, f.high);
  const DoubleDouble two = TwoSum(first.high, second.high);
  const DoubleDouble high = TwoSum(two.high, third.high);
  const double low = LowOfProduct(a, b, first.low) +
                     LowOfProduct(c, d, second.low) +
                     LowOfProduct(e, f, third.low);
  return TwoSum(high.high, (two.low + high.low) + low);
}

/// a b + c d. Error <= 2 u (1 + u) (|a b| + |c d|): one rounding of c d, one
/// of the sum.
inline double SumOfProducts(double a, double b, double c, double d) {
  return std::fma(a, b, c * d);
}

/// a b + c d + e f. Error <= 3 u (1 + u)^2 (|a b| + |c d| + |e f|).
inline double SumOfProducts(double a, double b, double c, double d, double e,
                            double f) {
  return std::fma(a, b, std::fma(c, d, e * f));
}

}  // namespace truelux

#endif  // TRUELUX_EXACT_DOUBLE_DOUBLE_H_
