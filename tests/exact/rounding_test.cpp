// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/rounding.h"

#include <gtest/gtest.h>

#include "exact/number.h"

namespace truelux {
namespace {

TEST(Rounding, IsUpwardJustWhileARoundUpwardLives) {
  EXPECT_FALSE(IsRoundingUpward());
  {
    const RoundUpward outer;
    EXPECT_TRUE(IsRoundingUpward());
    {
      const RoundUpward inner;
      EXPECT_TRUE(IsRoundingUpward());
    }
    EXPECT_TRUE(IsRoundingUpward());
  }
  EXPECT_FALSE(IsRoundingUpward());
}

TEST(Rounding, ItIsWhatArithmeticDoes) {
  const volatile double one = 1;
  const volatile double tiny = 0x1p-60;
  EXPECT_EQ(one + tiny, 1);
  const RoundUpward rounding;
  const double sum = one + tiny;
  EXPECT_GT(sum, 1);
}

}  // namespace
}  // namespace truelux
