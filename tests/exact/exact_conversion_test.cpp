// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/exact_conversion.h"

#include <gtest/gtest.h>

namespace truelux {
namespace {

TEST(TimesPowerOfTwo, GoesBeyondBinary64AndBack) {
  const Exact x(-0.3);
  for (const long exponent : {0L, 1L, -64L, 1074L, 5000L, -123457L}) {
    const Exact y = TimesPowerOfTwo(x, exponent);
    EXPECT_EQ(TimesPowerOfTwo(y, -exponent), x);
    EXPECT_EQ(TimesPowerOfTwo(y, 1), y + y);
  }
  EXPECT_EQ(TimesPowerOfTwo(x, 4), Exact(-4.8));
  EXPECT_TRUE(TimesPowerOfTwo(Exact(0), 3000).is_zero());
}

TEST(BinaryExponentOf, IsThatOfFrexp) {
  EXPECT_EQ(BinaryExponentOf(Exact(1)), 1);
  EXPECT_EQ(BinaryExponentOf(Exact(-0.75)), 0);
  EXPECT_EQ(BinaryExponentOf(TimesPowerOfTwo(Exact(0.5), -5000)), -5000);
}

}  // namespace
}  // namespace truelux
