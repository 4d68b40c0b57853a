// SPDX-License-Identifier: GPL-3.0-or-later
// The way from exact numbers to MPFR and to binary64.

#include "exact/multiprecision.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "exact/exact_conversion.h"

namespace truelux {
namespace {

TEST(Multiprecision, TakesExactNumbersWithOneRounding) {
  const Exact x = Exact(1) + Exact(0x1p-100);
  const Exact square = x * x;  // 1 + 2^-99 + 2^-200
  const Multiprecision wide = MultiprecisionOf(256, square);
  mpfr_t truth;
  mpfr_init2(truth, 256);
  mpfr_set_ui_2exp(truth, 1, -200, MPFR_RNDN);
  mpfr_add_d(truth, truth, 0x1p-99, MPFR_RNDN);
  mpfr_add_d(truth, truth, 1, MPFR_RNDN);
  EXPECT_TRUE(mpfr_equal_p(wide.get(), truth));
  const Multiprecision narrow = MultiprecisionOf(128, square);
  mpfr_set_d(truth, 1, MPFR_RNDN);
  mpfr_add_d(truth, truth, 0x1p-99, MPFR_RNDN);
  EXPECT_TRUE(mpfr_equal_p(narrow.get(), truth));
  mpfr_clear(truth);
}

TEST(Multiprecision, TakesNumbersBeyondBinary64) {
  Exact tiny(0x1p-1074);
  Exact huge(std::numeric_limits<double>::max());
  for (int i = 0; i < 3; ++i)
    tiny = tiny * tiny;
  for (int i = 0; i < 3; ++i)
    huge = huge * huge;
  EXPECT_EQ(mpfr_get_exp(MultiprecisionOf(64, tiny).get()), -1074 * 8 + 1);
  EXPECT_EQ(mpfr_get_exp(MultiprecisionOf(64, huge).get()), 1024 * 8);
  EXPECT_EQ(mpfr_get_exp(MultiprecisionOf(64, -huge).get()), 1024 * 8);
  EXPECT_LT(mpfr_sgn(MultiprecisionOf(64, -huge).get()), 0);
  EXPECT_TRUE(mpfr_zero_p(MultiprecisionOf(64, Exact(0)).get()));
}

// A rounding to 53 bits first, then to the subnormal's bits, would give 2 of
// the lowest units for 1.5 - 2^-60 of them.
TEST(Multiprecision, RoundsSubnormalsOnce) {
  const auto of_units = [](double units, double extra) {
    Multiprecision x(200, units);
    mpfr_add_d(x.get(), x.get(), extra, MPFR_RNDN);
    mpfr_mul_2si(x.get(), x.get(), -1074, MPFR_RNDN);
    return x.ToDouble();
  };
  EXPECT_EQ(of_units(1.5, -0x1p-60), 0x1p-1074);
  EXPECT_EQ(of_units(1.5, 0), 2 * 0x1p-1074);
  EXPECT_EQ(of_units(2.5, 0), 2 * 0x1p-1074);
  EXPECT_EQ(of_units(2.5, 0x1p-60), 3 * 0x1p-1074);
  EXPECT_EQ(of_units(0.5, 0), 0);
  EXPECT_EQ(of_units(0.5, 0x1p-60), 0x1p-1074);
  EXPECT_EQ(of_units(0.5, -0x1p-60), 0);
}

TEST(Multiprecision, RoundsTooLargeNumbersToInfinity) {
  Multiprecision x(200, std::numeric_limits<double>::max());
  mpfr_add_d(x.get(), x.get(), 0x1p969, MPFR_RNDN);
  EXPECT_EQ(x.ToDouble(), std::numeric_limits<double>::max());
  mpfr_add_d(x.get(), x.get(), 0x1p969, MPFR_RNDN);
  EXPECT_TRUE(std::isinf(x.ToDouble()));
}

TEST(Multiprecision, CopiesAndMovesKeepPrecision) {
  const Multiprecision x(300, 1.5);
  Multiprecision copy(64);
  copy = x;
  EXPECT_EQ(mpfr_get_prec(copy.get()), 300);
  const Multiprecision moved(std::move(copy));
  EXPECT_EQ(mpfr_get_prec(moved.get()), 300);
  EXPECT_EQ(moved.ToDouble(), 1.5);
}

}  // namespace
}  // namespace truelux
