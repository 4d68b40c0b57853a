// SPDX-License-Identifier: GPL-3.0-or-later
// A sign that is decided when it is first needed.

#ifndef TRUELUX_EXACT_CACHED_SIGN_H_
#define TRUELUX_EXACT_CACHED_SIGN_H_

#include <cassert>

#include "exact/sign.h"

namespace truelux {

/// A sign that is known or not known yet, in one byte. "Not known" differs
/// from zero, and nobody can take it for a sign by mistake.
class CachedSign {
 public:
  /// Not known yet.
  constexpr CachedSign() = default;

  /// Known.
  explicit constexpr CachedSign(Sign sign)
      : value_(static_cast<signed char>(sign)) {}

  [[nodiscard]] constexpr bool known() const { return value_ != kUnknown; }

  /// The sign. Requires known().
  [[nodiscard]] constexpr Sign sign() const {
    assert(known());
    return static_cast<Sign>(value_);
  }

  /// The sign, which is ask() if it is not known yet.
  template <class Ask>
  Sign Get(const Ask& ask) {
    if (!known()) *this = CachedSign(ask());
    return sign();
  }

 private:
  static constexpr signed char kUnknown = 2;

  signed char value_ = kUnknown;
};

static_assert(sizeof(CachedSign) == 1);

}  // namespace truelux

#endif  // TRUELUX_EXACT_CACHED_SIGN_H_
