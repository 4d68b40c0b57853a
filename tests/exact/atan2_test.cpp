// SPDX-License-Identifier: GPL-3.0-or-later
// atan2 in double and double-double: every constant against MPFR.

#include "exact/atan2.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "exact/atan_table.h"
#include "exact/hard_pairs.h"

namespace truelux::testing {
namespace {

/// Around the border between two entries of the table, most often the first
/// ones, where an error of the table weighs most.
double BetweenEntries(PortableRandom& random) {
  const int last = random.OneIn(2) ? 2 : kAtanTableSteps - 1;
  const double tangent = (random.Integer(0, last) + 0.5) / kAtanTableSteps;
  const double distance = std::ldexp(1.0, -random.Integer(5, 52));
  return tangent * (1 + random.Uniform(-1, 1) * distance);
}

TEST(Atan2OfDoubleDouble, EveryTableEntryIsTheNearestPair) {
  for (int j = 0; j <= kAtanTableSteps; ++j) {
    const ShortReal truth = Atan2(ShortReal(j), ShortReal(kAtanTableSteps));
    const DoubleDouble& entry = kAtanTable[static_cast<std::size_t>(j)];
    EXPECT_EQ(entry.high, truth.ToDouble()) << j;
    EXPECT_EQ(entry.low, (truth - ShortReal(entry.high)).ToDouble()) << j;
  }
}

TEST(Atan2OfDoubleDouble, StaysWithinItsProvenConstant) {
  HardPairs pairs(6);
  PortableRandom& random = pairs.random();
  double worst = 0;
  for (int i = 0; i < 300000; ++i) {
    DoubleDouble x = pairs.Next(20);
    DoubleDouble y = pairs.Next(20);
    switch (i % 4) {
      case 0: {  // around a table entry's border, in every octant
        const double tangent = BetweenEntries(random);
        y = x * tangent;
        if (random.OneIn(2)) std::swap(x, y);
        if (random.OneIn(2)) y = -y;
        break;
      }
      case 1:  // any angle
        y = x * random.Uniform(-3, 3);
        break;
      case 2:  // small angles, and angles near pi
        y = x * std::ldexp(random.Uniform(-1, 1), random.Integer(-60, 0));
        break;
      default:
        break;
    }
    worst = std::max(
        worst, RelativeError(ToReal(Atan2(y, x)), Atan2(ToReal(y), ToReal(x)),
                             kUnitSquared));
  }
  RecordProperty("worst_u2", std::to_string(worst));
  EXPECT_LE(worst, kAtan2Error);
  // What docs/errors.md states as measured.
  EXPECT_LE(worst, 12.5);
  EXPECT_GT(worst, 10);
}

TEST(Atan2OfDoubleDouble, HitsTheAxesAndDiagonals) {
  const DoubleDouble one{1, 0};
  const DoubleDouble zero{0, 0};
  EXPECT_EQ(Atan2(zero, one), zero);
  EXPECT_EQ(Atan2(zero, zero), zero);
  EXPECT_EQ(Atan2(one, zero).high, std::acos(-1) / 2);
  EXPECT_EQ(Atan2(zero, -one).high, std::acos(-1));
  EXPECT_EQ(Atan2(-one, zero).high, -std::acos(-1) / 2);
  EXPECT_EQ(Atan2(one, one).high, std::acos(-1) / 4);
  EXPECT_EQ(Atan2(one, -one).high, 3 * (std::acos(-1) / 4));
}

TEST(Atan2OfDouble, StaysWithinItsProvenConstant) {
  PortableRandom random(7);
  double worst = 0;
  for (int i = 0; i < 300000; ++i) {
    double x = std::ldexp(random.Uniform(1, 2), random.Integer(-20, 20));
    double y = x * random.Uniform(0, 1);
    if (i % 4 == 0) y = x * BetweenEntries(random);
    if (i % 4 == 1) y = std::ldexp(y, -random.Integer(0, 800));
    if (random.OneIn(2)) std::swap(x, y);
    if (random.OneIn(2)) x = -x;
    if (random.OneIn(2)) y = -y;
    worst = std::max(
        worst, RelativeError(ShortReal(Atan2(y, x)),
                             Atan2(ShortReal(y), ShortReal(x)), kUnitRoundoff));
  }
  RecordProperty("worst_u", std::to_string(worst));
  EXPECT_LE(worst, kAtan2ErrorOfDouble);
  // What docs/errors.md states as measured.
  EXPECT_LE(worst, 3.0);
  EXPECT_GT(worst, 2.0);
}

TEST(Atan2OfDouble, KeepsItsWordAtTheEndsOfTheRange) {
  for (const double y : {0.0, 0x1p-1074, 0x1p-1022, 0x1p-900, 1.0, 0x1p900}) {
    for (const double x : {0x1p-900, 0x1p-500, 1.0, 0x1p900}) {
      for (const double sign : {1.0, -1.0}) {
        const ShortReal truth = Atan2(ShortReal(y), ShortReal(sign * x));
        const ShortReal error = Abs(ShortReal(Atan2(y, sign * x)) - truth);
        EXPECT_LE(error,
                  Abs(truth) * ShortReal(kAtan2ErrorOfDouble * kUnitRoundoff) +
                      ShortReal(0x1p-1070))
            << y << " " << sign * x;
      }
    }
  }
}

TEST(Atan2OfDouble, HitsTheAxesAndDiagonals) {
  EXPECT_EQ(Atan2(0.0, 1.0), 0);
  EXPECT_EQ(Atan2(0.0, 0.0), 0);
  EXPECT_EQ(Atan2(1.0, 0.0), std::acos(-1) / 2);
  EXPECT_EQ(Atan2(0.0, -1.0), std::acos(-1));
  EXPECT_EQ(Atan2(1.0, 1.0), std::acos(-1) / 4);
  EXPECT_EQ(Atan2(-1.0, 1.0), -std::acos(-1) / 4);
}

}  // namespace
}  // namespace truelux::testing
