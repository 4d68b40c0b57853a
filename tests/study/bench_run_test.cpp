// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/bench_run.h"

#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "support/scenes.h"

namespace truelux {
namespace {

/// Gives 1 for every receiver; never ends at receivers with x >= `patience`.
Contender Method(const std::string& name, double patience) {
  const auto stop = std::make_shared<StopFlag>(false);
  Contender method = EachReceiver(
      name, "", [stop, patience](const Receiver& receiver, std::size_t) {
        while (receiver.position.x >= patience) {
          if (*stop) throw Stopped();
          std::this_thread::yield();
        }
        return Rgb{1, 1, 1};
      });
  method.max_receivers = 100;  // one by one
  method.stop = stop;
  return method;
}

TEST(BenchRun, AMethodThatIsNotDoneInTimeIsLeftOutOrHasFewerReceivers) {
  std::vector<Receiver> receivers(4);
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    receivers[i].position.x = static_cast<double>(i);
    receivers[i].normal = {0, 0, 1};
  }
  MethodList list;
  list.methods = {Method("truth", 100), Method("slow", -1), Method("late", 1),
                  Method("quick", 100)};
  const Comparison comparison = RunMethods(testing::SceneOf(1), receivers, list,
                                           {.seconds = 0.01, .rounds = 1});
  ASSERT_EQ(comparison.methods.size(), 3U);
  EXPECT_EQ(comparison.methods[1].name, "late");
  EXPECT_EQ(comparison.methods[1].left_out, 3U);
  EXPECT_TRUE(comparison.methods[1].values[0]);
  EXPECT_FALSE(comparison.methods[1].values[2]);
  EXPECT_EQ(comparison.methods[2].left_out, 0U);
  ASSERT_EQ(comparison.absent.size(), 1U);
  EXPECT_EQ(comparison.absent[0],
            "slow: not done with one receiver in 1 s; more --seconds would do");
}

}  // namespace
}  // namespace truelux
