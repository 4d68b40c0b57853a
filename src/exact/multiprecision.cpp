#include "exact/multiprecision.h"

#include <CGAL/Gmpq.h>

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

}  // namespace

Multiprecision::Multiprecision(mpfr_prec_t precision) {
  OwnCacheOfThisThread();
  mpfr_init2(number_, precision);
  mpfr_set_zero(number_, 1);
}

Multiprecision::Multiprecision(mpfr_prec_t precision, const Exact& x)
    : Multiprecision(precision) {
  // The denominator of a dyadic number is 2^k: one rounding, no division.
  const CGAL::Gmpq quotient(x);
  const auto bits = mpz_sizeinbase(mpq_denref(quotient.mpq()), 2);
  mpfr_set_z_2exp(number_, mpq_numref(quotient.mpq()),
                  1 - static_cast<mpfr_exp_t>(bits), MPFR_RNDN);
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

}  // namespace truelux
