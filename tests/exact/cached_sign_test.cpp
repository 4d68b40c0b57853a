// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/cached_sign.h"

#include <gtest/gtest.h>

namespace truelux {
namespace {

TEST(CachedSign, ZeroIsKnownAndUnknownIsNotZero) {
  EXPECT_FALSE(CachedSign().known());
  for (const Sign sign : {Sign::kNegative, Sign::kZero, Sign::kPositive}) {
    EXPECT_TRUE(CachedSign(sign).known());
    EXPECT_EQ(CachedSign(sign).sign(), sign);
  }
}

TEST(CachedSign, AsksOnceAlsoForZero) {
  for (const Sign sign : {Sign::kNegative, Sign::kZero, Sign::kPositive}) {
    CachedSign cached;
    int asked = 0;
    const auto ask = [&] {
      ++asked;
      return sign;
    };
    EXPECT_EQ(cached.Get(ask), sign);
    EXPECT_EQ(cached.Get(ask), sign);
    EXPECT_EQ(asked, 1);
    EXPECT_TRUE(cached.known());
  }
}

}  // namespace
}  // namespace truelux
