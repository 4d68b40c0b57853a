// SPDX-License-Identifier: GPL-3.0-or-later
// Arb's balls as values: a midpoint of any precision and a radius, which every
// operation of Arb keeps so that the ball holds the true value.

#ifndef TRUELUX_EXACT_ARB_BALL_H_
#define TRUELUX_EXACT_ARB_BALL_H_

#include <mpfr.h>

// FLINT 3 holds Arb; before that Arb was a library of its own.
#if __has_include(<flint/arb.h>)
#include <flint/arb.h>
#else
#include <arb.h>
#endif

#include "exact/number.h"

namespace truelux {

/// Owns one arb_t; starts as 0. Functions of Arb are told the precision [bits]
/// of their results.
class ArbBall {
 public:
  ArbBall();

  /// x with its midpoint rounded to a precision [bits].
  ArbBall(slong precision, const Exact& x);

  ArbBall(const ArbBall&) = delete;
  ArbBall& operator=(const ArbBall&) = delete;

  ArbBall(ArbBall&& other) noexcept : ArbBall() {
    arb_swap(ball_, other.ball_);
  }

  ArbBall& operator=(ArbBall&& other) noexcept {
    arb_swap(ball_, other.ball_);
    return *this;
  }

  ~ArbBall() { arb_clear(ball_); }

  [[nodiscard]] arb_ptr get() { return ball_; }

  [[nodiscard]] arb_srcptr get() const { return ball_; }

 private:
  arb_t ball_{};
};

}  // namespace truelux

#endif  // TRUELUX_EXACT_ARB_BALL_H_
