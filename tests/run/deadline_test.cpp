// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/deadline.h"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

namespace truelux {
namespace {

TEST(Deadline, SetsTheFlagWhenTheTimeIsUp) {
  StopFlag flag = false;
  const auto begin = std::chrono::steady_clock::now();
  const Deadline deadline(0.05, flag);
  while (!flag)
    std::this_thread::yield();
  EXPECT_GE(std::chrono::steady_clock::now() - begin,
            std::chrono::milliseconds(50));
}

TEST(Deadline, EndsAtOnceWithoutIt) {
  StopFlag flag = false;
  const auto begin = std::chrono::steady_clock::now();
  { const Deadline deadline(1000, flag); }
  EXPECT_LT(std::chrono::steady_clock::now() - begin,
            std::chrono::seconds(100));
  EXPECT_FALSE(flag);
}

}  // namespace
}  // namespace truelux
