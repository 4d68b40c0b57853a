// SPDX-License-Identifier: GPL-3.0-or-later
// Real numbers at a precision, with their enclosures: Arb's balls with
// operators, for formulas that are written once for all number types.

#ifndef TRUELUX_EXACT_ARB_REAL_H_
#define TRUELUX_EXACT_ARB_REAL_H_

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "exact/arb_ball.h"
#include "exact/vec3.h"

namespace truelux {

/// A ball that holds a real number, and the precision [bits] of what is
/// computed from it. An operation has the precision of the operand that has
/// more. What cannot be enclosed (a divisor that may be 0) is a ball of
/// infinite radius.
class ArbReal {
 public:
  /// 0, exactly.
  ArbReal() = default;

  ArbReal(slong precision, const Exact& x)
      : ball_(precision, x), precision_(precision) {}

  /// A small whole number, exactly.
  ArbReal(slong precision, long x) : precision_(precision) {
    arb_set_si(ball_.get(), x);
  }

  ArbReal(const ArbReal& other) : precision_(other.precision_) {
    arb_set(ball_.get(), other.ball_.get());
  }

  ArbReal& operator=(const ArbReal& other) {
    arb_set(ball_.get(), other.ball_.get());
    precision_ = other.precision_;
    return *this;
  }

  ArbReal(ArbReal&&) noexcept = default;
  ArbReal& operator=(ArbReal&&) noexcept = default;
  ~ArbReal() = default;

  [[nodiscard]] arb_srcptr get() const { return ball_.get(); }

  [[nodiscard]] slong precision() const { return precision_; }

  friend ArbReal operator+(const ArbReal& a, const ArbReal& b) {
    return Made(a, b, arb_add);
  }

  friend ArbReal operator-(const ArbReal& a, const ArbReal& b) {
    return Made(a, b, arb_sub);
  }

  friend ArbReal operator*(const ArbReal& a, const ArbReal& b) {
    return Made(a, b, arb_mul);
  }

  friend ArbReal operator/(const ArbReal& a, const ArbReal& b) {
    return Made(a, b, arb_div);
  }

  friend ArbReal operator-(const ArbReal& a) {
    ArbReal result(a);
    arb_neg(result.ball_.get(), result.ball_.get());
    return result;
  }

  friend ArbReal Sqrt(const ArbReal& a) {
    ArbReal result;
    result.precision_ = a.precision_;
    arb_sqrt(result.ball_.get(), a.ball_.get(), a.precision_);
    return result;
  }

  /// The angle of (x, y) in [-pi, pi].
  friend ArbReal Angle(const ArbReal& y, const ArbReal& x) {
    return Made(y, x, arb_atan2);
  }

  /// The same ball, wider by the largest magnitude in another one.
  [[nodiscard]] ArbReal WidenedBy(const ArbReal& error) const {
    ArbReal result(*this);
    arb_add_error(result.ball_.get(), error.get());
    return result;
  }

  /// |x|.
  [[nodiscard]] ArbReal Absolute() const {
    ArbReal result(*this);
    arb_abs(result.ball_.get(), result.ball_.get());
    return result;
  }

  /// x 2^exponent.
  [[nodiscard]] ArbReal TimesTwoTo(slong exponent) const {
    ArbReal result(*this);
    arb_mul_2exp_si(result.ball_.get(), result.ball_.get(), exponent);
    return result;
  }

  /// The binary64 nearest to the middle. Throws std::logic_error if the ball
  /// does not know that many digits, and is not 0.
  [[nodiscard]] double Nearest() const {
    constexpr slong kBits = 60;
    if (arb_rel_accuracy_bits(ball_.get()) < kBits &&
        arb_is_zero(ball_.get()) == 0) {
      throw std::logic_error("a number has lost its digits");
    }
    return arf_get_d(arb_midref(ball_.get()), ARF_RND_NEAR);
  }

  /// Whether |x| is certainly not above y.
  [[nodiscard]] bool IsAtMost(const ArbReal& y) const {
    return arb_le(Absolute().get(), y.get()) != 0;
  }

  static ArbReal Pi(slong precision) {
    ArbReal result;
    result.precision_ = precision;
    arb_const_pi(result.ball_.get(), precision);
    return result;
  }

 private:
  template <class Function>
  static ArbReal Made(const ArbReal& a, const ArbReal& b,
                      const Function& function) {
    ArbReal result;
    result.precision_ = std::max(a.precision_, b.precision_);
    function(result.ball_.get(), a.ball_.get(), b.ball_.get(),
             result.precision_);
    return result;
  }

  ArbBall ball_;
  slong precision_ = 2;
};

/// The components of an exact vector, each rounded.
inline Vec3<ArbReal> ArbVector(slong precision, const Vec3<Exact>& v) {
  return {ArbReal(precision, v.x), ArbReal(precision, v.y),
          ArbReal(precision, v.z)};
}

}  // namespace truelux

#endif  // TRUELUX_EXACT_ARB_REAL_H_
