// SPDX-License-Identifier: GPL-3.0-or-later
// Work spread over threads: each piece is done once, and what comes out does
// not depend on how many threads there are.

#include "run/parallel.h"

#include <atomic>
#include <cstddef>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/irradiance.h"

#include "run/progress.h"
#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scenes.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

/// A scene with shadows, and more receivers than one share of a thread.
class Batch : public ::testing::Test {
 protected:
  Batch() {
    PortableRandom random(3);
    std::vector<TestFace> faces = RandomScene(random, false, 12, 3);
    faces.push_back({Ceiling(-4, 4, -4, 4, 6), kLamp});
    scene_ = MakeScene(faces);
    for (int i = 0; i < 200; ++i)
      receivers_.push_back(RandomReceiver(random, false, 3));
    const Oracle oracle(scene_);
    for (const Receiver& receiver : receivers_)
      expected_.push_back(oracle.Evaluate(receiver).value);
  }

  Scene scene_;
  std::vector<Receiver> receivers_;
  std::vector<Rgb> expected_;
};

TEST_F(Batch, HasTheSameBitsOnAnyNumberOfThreads) {
  const Oracle oracle(scene_);
  for (const int threads : {1, 2, 5}) {
    std::vector<Rgb> values(receivers_.size());
    std::vector<int> calls(receivers_.size());
    Progress progress(receivers_.size());
    EvaluateInParallel(oracle, receivers_, threads, progress,
                       [&](std::size_t i, const Irradiance& irradiance) {
                         values[i] = irradiance.value;
                         ++calls[i];
                       });
    EXPECT_EQ(values, expected_);
    EXPECT_EQ(calls, std::vector<int>(receivers_.size(), 1));
    EXPECT_EQ(progress.done(), receivers_.size());
  }
}

TEST_F(Batch, OfOneOracleFromSeveralThreadsAtOnce) {
  const Oracle oracle(scene_);
  constexpr std::size_t kThreads = 4;
  std::vector<std::vector<Rgb>> values(kThreads);
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < kThreads; ++t) {
    threads.emplace_back([&, t] {
      for (const Irradiance& irradiance : oracle.Evaluate(receivers_))
        values[t].push_back(irradiance.value);
    });
  }
  for (std::thread& thread : threads)
    thread.join();
  for (const std::vector<Rgb>& own : values)
    EXPECT_EQ(own, expected_);
}

TEST(ForEachInParallel, CallsOnceForEach) {
  std::vector<std::atomic<int>> calls(1000);
  Progress progress(calls.size());
  ForEachInParallel(calls.size(), 3, progress,
                    [&](std::size_t i) { ++calls[i]; });
  for (const std::atomic<int>& count : calls)
    EXPECT_EQ(count, 1);
  EXPECT_EQ(progress.done(), calls.size());
}

TEST(ForEachInParallel, PassesOnWhatIsThrown) {
  Progress progress(100);
  const auto work = [](std::size_t i) {
    if (i == 57) throw std::runtime_error("57");
  };
  EXPECT_THROW(ForEachInParallel(100, 3, progress, work), std::runtime_error);
  EXPECT_LT(progress.done(), 100U);
}

}  // namespace
}  // namespace truelux
