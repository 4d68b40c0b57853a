// atan2 in double-double: octants, a table of arctangents, Taylor.
// The proof of kAtan2Error is docs/errors.md section 4; its step names are
// repeated here.

#include <cstddef>
#include <utility>

#include "exact/atan_table.h"
#include "exact/double_double.h"

namespace truelux {
namespace {

constexpr DoubleDouble kPi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
constexpr DoubleDouble kHalfPi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

// -1/3, 1/5, -1/7 as double-doubles.
constexpr DoubleDouble kTaylor3{-0x1.5555555555555p-2, -0x1.5555555555555p-56};
constexpr DoubleDouble kTaylor5{0x1.999999999999ap-3, -0x1.999999999999ap-57};
constexpr DoubleDouble kTaylor7{-0x1.2492492492492p-3, -0x1.2492492492492p-57};

/// Step T: atan t for |t| <= 2^-8 (1 + 2^-40). Error <= 3.1 u^2 (relative).
DoubleDouble AtanTaylor(const DoubleDouble& t) {
  const DoubleDouble z = t * t;
  const double tail =
      z.high * (1.0 / 9 - z.high * (1.0 / 11 - z.high * (1.0 / 13)));
  const DoubleDouble p = kTaylor3 + z * (kTaylor5 + z * (kTaylor7 + tail));
  return t + t * (z * p);
}

/// Step A: atan(a / b), 0 <= a <= b (1 + 2 u), b > 0.
/// Error <= 30 u^2 (relative).
DoubleDouble AtanOfQuotient(const DoubleDouble& a, const DoubleDouble& b) {
  const double position = a.high / b.high * kAtanTableSteps + 0.5;
  const auto j = static_cast<std::size_t>(position);
  if (j == 0) return AtanTaylor(a / b);
  const double tangent = static_cast<double>(j) / kAtanTableSteps;
  const DoubleDouble t = (a - b * tangent) / (b + a * tangent);
  return kAtanTable[j] + AtanTaylor(t);
}

/// atan2 for y >= 0.
DoubleDouble UpperAtan2(const DoubleDouble& y, const DoubleDouble& x) {
  const bool left = x.high < 0;
  const DoubleDouble abs_x = left ? -x : x;
  if (y.high > abs_x.high) {
    const DoubleDouble complement = AtanOfQuotient(abs_x, y);
    return left ? kHalfPi + complement : kHalfPi - complement;
  }
  if (abs_x.high == 0) return {0, 0};
  const DoubleDouble angle = AtanOfQuotient(y, abs_x);
  return left ? kPi - angle : angle;
}

}  // namespace

DoubleDouble Atan2(const DoubleDouble& y, const DoubleDouble& x) {
  return y.high < 0 ? -UpperAtan2(-y, x) : UpperAtan2(y, x);
}

}  // namespace truelux
