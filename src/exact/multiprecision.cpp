// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/multiprecision.h"

#include <algorithm>
#include <cassert>

namespace truelux {
namespace {

/// MPFR keeps pi and its like per thread; a thread that ends gives it back.
struct CacheOwner {
  CacheOwner() = default;
  CacheOwner(const CacheOwner&) = delete;
  CacheOwner& operator=(const CacheOwner&) = delete;

  ~CacheOwner() { mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE); }
};

void OwnCacheOfThisThread() {
  static const thread_local CacheOwner owner;
}

/// function: of MPFR, with two operands.
template <class Function>
Multiprecision Apply(Function function, const Multiprecision& x,
                     const Multiprecision& y) {
  Multiprecision result(
      std::max(mpfr_get_prec(x.get()), mpfr_get_prec(y.get())));
  function(result.get(), x.get(), y.get(), MPFR_RNDN);
  return result;
}

}  // namespace

Multiprecision::Multiprecision(mpfr_prec_t precision) {
  OwnCacheOfThisThread();
  mpfr_init2(number_, precision);
  mpfr_set_zero(number_, 1);
}

Multiprecision::Multiprecision(mpfr_prec_t precision, double x)
    : Multiprecision(precision) {
  mpfr_set_d(number_, x, MPFR_RNDN);
}

Multiprecision::Multiprecision(const Multiprecision& other)
    : Multiprecision(mpfr_get_prec(other.number_)) {
  mpfr_set(number_, other.number_, MPFR_RNDN);
}

Multiprecision& Multiprecision::operator=(const Multiprecision& other) {
  if (this != &other) *this = Multiprecision(other);
  return *this;
}

Multiprecision operator+(const Multiprecision& x, const Multiprecision& y) {
  return Apply(mpfr_add, x, y);
}

Multiprecision operator-(const Multiprecision& x, const Multiprecision& y) {
  return Apply(mpfr_sub, x, y);
}

Multiprecision operator*(const Multiprecision& x, const Multiprecision& y) {
  return Apply(mpfr_mul, x, y);
}

Multiprecision operator/(const Multiprecision& x, const Multiprecision& y) {
  return Apply(mpfr_div, x, y);
}

Multiprecision operator-(const Multiprecision& x) {
  Multiprecision result(x);
  mpfr_neg(result.get(), result.get(), MPFR_RNDN);
  return result;
}

Multiprecision Sqrt(const Multiprecision& x) {
  assert(mpfr_sgn(x.get()) >= 0);
  Multiprecision result(mpfr_get_prec(x.get()));
  mpfr_sqrt(result.get(), x.get(), MPFR_RNDN);
  return result;
}

Multiprecision Angle(const Multiprecision& y, const Multiprecision& x) {
  return Apply(mpfr_atan2, y, x);
}

Multiprecision PiOf(mpfr_prec_t precision) {
  Multiprecision result(precision);
  mpfr_const_pi(result.get(), MPFR_RNDN);
  return result;
}

}  // namespace truelux
