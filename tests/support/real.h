// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers with many bits to hold results against: slow, simple, and
// independent of the library's own number types.

#ifndef TRUELUX_TESTS_SUPPORT_REAL_H_
#define TRUELUX_TESTS_SUPPORT_REAL_H_

#include <mpfr.h>

namespace truelux::testing {

/// Rounds to nearest with kBits bits.
template <int kBits>
class BasicReal {
 public:
  BasicReal(double x = 0) {  // NOLINT(google-explicit-constructor): a number
    mpfr_init2(number_, kBits);
    mpfr_set_d(number_, x, MPFR_RNDN);
  }

  BasicReal(const BasicReal& other) : BasicReal() {
    mpfr_set(number_, other.number_, MPFR_RNDN);
  }

  BasicReal& operator=(const BasicReal& other) {
    mpfr_set(number_, other.number_, MPFR_RNDN);
    return *this;
  }

  ~BasicReal() { mpfr_clear(number_); }

  [[nodiscard]] mpfr_ptr get() { return number_; }

  [[nodiscard]] mpfr_srcptr get() const { return number_; }

  /// The nearest double, rounded once.
  [[nodiscard]] double ToDouble() const {
    return mpfr_get_d(number_, MPFR_RNDN);
  }

  static BasicReal Pi() {
    BasicReal pi;
    mpfr_const_pi(pi.number_, MPFR_RNDN);
    return pi;
  }

  friend BasicReal operator+(const BasicReal& a, const BasicReal& b) {
    BasicReal r;
    mpfr_add(r.number_, a.number_, b.number_, MPFR_RNDN);
    return r;
  }

  friend BasicReal operator-(const BasicReal& a, const BasicReal& b) {
    BasicReal r;
    mpfr_sub(r.number_, a.number_, b.number_, MPFR_RNDN);
    return r;
  }

  friend BasicReal operator*(const BasicReal& a, const BasicReal& b) {
    BasicReal r;
    mpfr_mul(r.number_, a.number_, b.number_, MPFR_RNDN);
    return r;
  }

  friend BasicReal operator/(const BasicReal& a, const BasicReal& b) {
    BasicReal r;
    mpfr_div(r.number_, a.number_, b.number_, MPFR_RNDN);
    return r;
  }

  friend BasicReal operator-(const BasicReal& a) { return BasicReal(0) - a; }

  friend bool operator<(const BasicReal& a, const BasicReal& b) {
    return mpfr_less_p(a.number_, b.number_) != 0;
  }

  friend bool operator<=(const BasicReal& a, const BasicReal& b) {
    return mpfr_lessequal_p(a.number_, b.number_) != 0;
  }

  friend BasicReal Abs(const BasicReal& a) {
    BasicReal r;
    mpfr_abs(r.number_, a.number_, MPFR_RNDN);
    return r;
  }

  friend BasicReal Sqrt(const BasicReal& a) {
    BasicReal r;
    mpfr_sqrt(r.number_, a.number_, MPFR_RNDN);
    return r;
  }

  friend BasicReal Atan2(const BasicReal& y, const BasicReal& x) {
    BasicReal r;
    mpfr_atan2(r.number_, y.number_, x.number_, MPFR_RNDN);
    return r;
  }

 private:
  mpfr_t number_{};
};

using Real = BasicReal<1400>;      ///< 421 digits
using ShortReal = BasicReal<400>;  ///< 120 digits

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_SUPPORT_REAL_H_
