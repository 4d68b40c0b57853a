// SPDX-License-Identifier: GPL-3.0-or-later
// The sign of an exact quantity. "Zero" and "not known" are different types:
// a stage that may not know returns std::optional<Sign>.

#ifndef TRUELUX_EXACT_SIGN_H_
#define TRUELUX_EXACT_SIGN_H_

namespace truelux {

enum class Sign : signed char { kNegative = -1, kZero = 0, kPositive = 1 };

constexpr Sign operator-(Sign s) {
  return static_cast<Sign>(-static_cast<signed char>(s));
}

constexpr Sign operator*(Sign a, Sign b) {
  return static_cast<Sign>(static_cast<signed char>(a) *
                           static_cast<signed char>(b));
}

/// Sign of a number type that can be compared with zero exactly.
template <class T>
constexpr Sign SignOf(const T& x) {
  if (x < T(0)) return Sign::kNegative;
  if (T(0) < x) return Sign::kPositive;
  return Sign::kZero;
}

}  // namespace truelux

#endif  // TRUELUX_EXACT_SIGN_H_
