// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/arb_ball.h"

#include <CGAL/Gmpq.h>

namespace truelux {
namespace {

/// Arb and FLINT keep pi and spare memory per thread; a thread that ends gives
/// them back.
struct CacheOwner {
  CacheOwner() = default;
  CacheOwner(const CacheOwner&) = delete;
  CacheOwner& operator=(const CacheOwner&) = delete;

  ~CacheOwner() { flint_cleanup(); }
};

void OwnCacheOfThisThread() {
  static const thread_local CacheOwner owner;
}

}  // namespace

ArbBall::ArbBall() {
  OwnCacheOfThisThread();
  arb_init(ball_);
}

ArbBall::ArbBall(slong precision, const Exact& x) : ArbBall() {
  // The denominator of a dyadic number is 2^k: one rounding, no division.
  const CGAL::Gmpq quotient(x);
  const auto bits = mpz_sizeinbase(mpq_denref(quotient.mpq()), 2);
  arf_set_mpz(arb_midref(ball_), mpq_numref(quotient.mpq()));
  arb_mul_2exp_si(ball_, ball_, 1 - static_cast<slong>(bits));
  arb_set_round(ball_, ball_, precision);
}

}  // namespace truelux
