// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/stamped_table.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace truelux {
namespace {

TEST(StampedTable, StartsWithNothingSet) {
  const StampedTable<int> table(3);
  for (int key = 0; key < 3; ++key)
    EXPECT_FALSE(table.Has(key)) << key;
}

TEST(StampedTable, KeepsWhatIsSetUntilItIsCleared) {
  StampedTable<int> table(3);
  table.Set(1, 7);
  EXPECT_TRUE(table.Has(1));
  EXPECT_EQ(table[1], 7);
  EXPECT_FALSE(table.Has(0));
  EXPECT_FALSE(table.Has(2));
  table.Set(1, 8);
  EXPECT_EQ(table[1], 8);
  table.Clear();
  EXPECT_FALSE(table.Has(1));
}

TEST(StampedTable, ReferencesWriteThrough) {
  StampedTable<int> table(1);
  table.Set(0, 3) += 2;
  table[0] *= 10;
  EXPECT_EQ(table[0], 50);
}

TEST(StampedTable, AsksOnceUntilItIsCleared) {
  StampedTable<int> table(2);
  int asked = 0;
  const auto make = [&asked] { return ++asked; };
  EXPECT_EQ(table.FindOrMake(1, make), 1);
  EXPECT_EQ(table.FindOrMake(1, make), 1);
  EXPECT_EQ(table.FindOrMake(0, make), 2);
  table.Clear();
  EXPECT_EQ(table.FindOrMake(1, make), 3);
}

TEST(StampedTable, AKeyWhoseMakingFailedIsNotSet) {
  StampedTable<int> table(1);
  const auto fail = []() -> int { throw 1; };
  EXPECT_THROW(table.FindOrMake(0, fail), int);
  EXPECT_FALSE(table.Has(0));
}

TEST(StampedTable, GrowingKeepsWhatIsSetAndSetsNothing) {
  StampedTable<int> table;
  table.Cover(1);
  table.Set(0, 5);
  table.Cover(100);
  EXPECT_TRUE(table.Has(0));
  EXPECT_EQ(table[0], 5);
  for (int key = 1; key < 100; ++key)
    EXPECT_FALSE(table.Has(key)) << key;
  table.Set(99, 6);
  table.Cover(2);  // does not shrink
  EXPECT_EQ(table[99], 6);
}

TEST(StampedTable, FindsWhatIsSetAndNothingElse) {
  StampedTable<int> table(2);
  table.Set(1, 5);
  ASSERT_NE(table.Find(1), nullptr);
  EXPECT_EQ(*table.Find(1), 5);
  EXPECT_EQ(table.Find(0), nullptr);
  EXPECT_EQ(table.Find(2), nullptr);  // no room
  table.Clear();
  EXPECT_EQ(table.Find(1), nullptr);
}

TEST(StampedTable, WhatWasAddedAfterAClearIsNotSet) {
  StampedTable<int> table(1);
  table.Clear();
  table.Cover(4);
  EXPECT_FALSE(table.Has(0));
  EXPECT_FALSE(table.Has(3));
}

TEST(StampedTable, RenewsTheMemoryOfAValue) {
  StampedTable<std::vector<int>> table(1);
  table.Set(0, std::vector<int>(1000));
  const int* const memory = table[0].data();
  table.Clear();
  EXPECT_FALSE(table.Has(0));
  std::vector<int>& renewed = table.Renew(0);
  EXPECT_TRUE(table.Has(0));
  EXPECT_EQ(renewed.data(), memory);
}

/// With 8 bits the stamps wrap around after 255 clears.
TEST(StampedTable, AnOldEntryDoesNotComeBackWhenTheStampsWrapAround) {
  using Small = StampedTable<int, int, std::uint8_t>;
  for (int clears = 1; clears < 1000; ++clears) {
    Small table(2);
    table.Set(0, 1);
    for (int i = 0; i < clears; ++i)
      table.Clear();
    ASSERT_FALSE(table.Has(0)) << clears;  // was set
    ASSERT_FALSE(table.Has(1)) << clears;  // never was
    table.Set(1, 2);
    ASSERT_TRUE(table.Has(1)) << clears;
  }
}

TEST(StampedTable, AnEntryWithoutValueIsItsStamp) {
  struct Nothing {};

  StampedTable<Nothing> table(2);
  table.Set(1, {});
  EXPECT_TRUE(table.Has(1));
  EXPECT_FALSE(table.Has(0));
}

TEST(StampedSet, HoldsWhatWasInsertedSinceTheLastClear) {
  StampedSet set(3);
  EXPECT_FALSE(set.Contains(0));
  set.Insert(0);
  set.Insert(2);
  EXPECT_TRUE(set.Contains(0));
  EXPECT_FALSE(set.Contains(1));
  EXPECT_TRUE(set.Contains(2));
  set.Clear();
  for (int key = 0; key < 3; ++key)
    EXPECT_FALSE(set.Contains(key)) << key;
  set.Insert(1);
  EXPECT_TRUE(set.Contains(1));
  EXPECT_FALSE(set.Contains(2));
}

}  // namespace
}  // namespace truelux
