// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/level_choice.h"

#include <vector>

#include <gtest/gtest.h>

namespace truelux {
namespace {

TEST(LevelChoice, StepsAreEvenAndRound) {
  EXPECT_EQ(EvenLevels(0, 10, 5), (std::vector<double>{1, 3, 5, 7, 9}));
  EXPECT_EQ(EvenLevels(0, 1, 3), (std::vector<double>{0.167, 0.5, 0.833}));
  EXPECT_EQ(EvenLevels(2, 2.5, 1), (std::vector<double>{2.25}));
}

TEST(LevelChoice, ANarrowRangeGetsMoreDigits) {
  const std::vector<double> levels = EvenLevels(1, 1.0001, 4);
  ASSERT_EQ(levels.size(), 4U);
  EXPECT_GT(levels.front(), 1);
  EXPECT_LT(levels.back(), 1.0001);
  for (std::size_t i = 1; i < levels.size(); ++i)
    EXPECT_LT(levels[i - 1], levels[i]);
}

TEST(LevelChoice, APointHasNone) {
  EXPECT_TRUE(EvenLevels(1, 1, 10).empty());
  EXPECT_TRUE(EvenLevels(0, 0, 10).empty());
}

TEST(LevelChoice, NeighboursHaveNoRoomForMany) {
  const double next = 1 + 0x1p-52;
  for (const double level : EvenLevels(1, next, 5)) {
    EXPECT_GE(level, 1);
    EXPECT_LE(level, next);
  }
}

}  // namespace
}  // namespace truelux
