// SPDX-License-Identifier: GPL-3.0-or-later
// atan2: octants, a table of arctangents, Taylor. The proofs are
// docs/errors.md section 4; its step names are repeated here.

#include "exact/atan2.h"

#include <cassert>
#include <cmath>
#include <cstddef>

#include "exact/atan_table.h"

namespace truelux {
namespace {

constexpr DoubleDouble kPi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
constexpr DoubleDouble kHalfPi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

// -1/3 and 1/5.
constexpr DoubleDouble kTaylor3{-0x1.5555555555555p-2, -0x1.5555555555555p-56};
constexpr DoubleDouble kTaylor5{0x1.999999999999ap-3, -0x1.999999999999ap-57};

/// The table entry next to a / b, 0 <= a <= b: j with
/// |a / b - j / steps| <= (1 + 2^-40) / (2 steps), and a >= b / (2 steps)
/// exactly if j > 0.
std::size_t NearestEntry(double a, double b) {
  const auto half_steps = static_cast<int>(a / b * (2 * kAtanTableSteps));
  return static_cast<std::size_t>((half_steps + 1) / 2);
}

double TangentOf(std::size_t j) {
  return static_cast<double>(j) * (1.0 / kAtanTableSteps);
}

/// Step D: atan(a / b), 0 <= a <= b, b > 0. Error <= 5.2 u (relative).
double AtanOfQuotient(double a, double b) {
  const std::size_t j = NearestEntry(a, b);
  const double tangent = TangentOf(j);
  const double t = std::fma(-tangent, b, a) / std::fma(tangent, a, b);
  const double z = t * t;
  const double cubic = t * z * std::fma(z, kTaylor5.high, kTaylor3.high);
  const DoubleDouble& entry = kAtanTable[j];
  return entry.high + (t + (cubic + entry.low));
}

/// Step R: (a - tangent b) / (b + tangent a), tangent that of the nearest
/// entry; high + low, not normalised.
DoubleDouble TangentOfRest(const DoubleDouble& a, const DoubleDouble& b,
                           double tangent) {
  const DoubleDouble removed = TwoProduct(tangent, b.high);
  const double above = a.high - removed.high;  // exact
  const double above_low = std::fma(-tangent, b.low, a.low) - removed.low;
  const DoubleDouble added = TwoProduct(tangent, a.high);
  const DoubleDouble sum = FastTwoSum(b.high, added.high);
  const DoubleDouble below = FastTwoSum(
      sum.high, sum.low + (std::fma(tangent, a.low, b.low) + added.low));
  const double inverse = 1 / below.high;
  const double quotient = above * inverse;
  const double rest = std::fma(-quotient, below.high, above) +
                      std::fma(-quotient, below.low, above_low);
  return {quotient, rest * inverse};
}

/// a b as high + low, for factors that need not be normalised: error below
/// 100 u^2 |a b| if their low parts are below 5 u of their high parts.
DoubleDouble RoughProduct(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble product = TwoProduct(a.high, b.high);
  return {product.high, LowOfProduct(a, b, product.low)};
}

/// a + b as high + low, |a.high| >= |b.high|: rounds the low parts' sum only.
DoubleDouble RoughSum(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble sum = FastTwoSum(a.high, b.high);
  return {sum.high, sum.low + (a.low + b.low)};
}

/// Step T: atan t - t for |t| <= 2^-9 (1 + 2^-40), high + low. Error <= u^2
/// |t|.
DoubleDouble AtanTail(const DoubleDouble& t) {
  const DoubleDouble z = RoughProduct(t, t);
  const double tail =
      z.high * std::fma(z.high, std::fma(z.high, -1.0 / 11, 1.0 / 9), -1.0 / 7);
  const DoubleDouble fifth = RoughSum(kTaylor5, {tail, 0});
  const DoubleDouble third = RoughSum(kTaylor3, RoughProduct(z, fifth));
  return RoughProduct(t, RoughProduct(z, third));
}

/// Step A: atan(a / b), 0 <= a.high <= b.high, b > 0. Error <= 74 u^2
/// (relative).
DoubleDouble AtanOfQuotient(const DoubleDouble& a, const DoubleDouble& b) {
  const std::size_t j = NearestEntry(a.high, b.high);
  const DoubleDouble t = TangentOfRest(a, b, TangentOf(j));
  const DoubleDouble rest = RoughSum(t, AtanTail(t));
  const DoubleDouble angle = RoughSum(kAtanTable[j], rest);
  return FastTwoSum(angle.high, angle.low);
}

double HighOf(double x) {
  return x;
}

double HighOf(const DoubleDouble& x) {
  return x.high;
}

double Constant(const DoubleDouble& value, double /*type*/) {
  return value.high;
}

DoubleDouble Constant(const DoubleDouble& value, const DoubleDouble& /*type*/) {
  return value;
}

/// Step O: atan2 for y >= 0.
template <class T>
T UpperAtan2(const T& y, const T& x) {
  assert(std::isfinite(HighOf(x)) && std::isfinite(HighOf(y)));
  const bool left = HighOf(x) < 0;
  const T abs_x = left ? -x : x;
  if (HighOf(y) > HighOf(abs_x)) {
    const T complement = AtanOfQuotient(abs_x, y);
    const T half_pi = Constant(kHalfPi, y);
    return left ? half_pi + complement : half_pi - complement;
  }
  if (HighOf(abs_x) == 0) return T{};
  const T angle = AtanOfQuotient(y, abs_x);
  return left ? Constant(kPi, y) - angle : angle;
}

}  // namespace

double Atan2(double y, double x) {
  return y < 0 ? -UpperAtan2(-y, x) : UpperAtan2(y, x);
}

DoubleDouble Atan2(const DoubleDouble& y, const DoubleDouble& x) {
  return y.high < 0 ? -UpperAtan2(-y, x) : UpperAtan2(y, x);
}

}  // namespace truelux
