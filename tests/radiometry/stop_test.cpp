// SPDX-License-Identifier: GPL-3.0-or-later
// Calls that are asked to end: they do, and the oracle answers afterwards as if
// nothing had been.

#include "truelux/stop.h"

#include <array>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/io.h"
#include "truelux/irradiance.h"

#include "support/scenes.h"

namespace truelux {
namespace {

constexpr std::array kEngines = {Engine::kContour, Engine::kArrangement,
                                 Engine::kAngularSpans};

/// A grid of lamps that hide each other a little.
Scene Lamps(int side) {
  std::vector<testing::TestFace> faces;
  for (int i = 0; i < side; ++i) {
    for (int k = 0; k < side; ++k) {
      const double z = 2 + 0.125 * ((i * 7 + k * 3) % 5);
      faces.push_back({testing::Ceiling(i, i + 1.25, k, k + 1.25, z),
                       {1.0 + i, 2.0 + k, 1}});
    }
  }
  return testing::MakeScene(faces);
}

TEST(Stop, EveryCallLooksAtTheFlag) {
  StopFlag stop = true;
  const Receiver receiver{{0, 0, 0}, {0, 0, 1}};
  for (const Engine engine : kEngines) {
    const Oracle oracle(Lamps(2), {.engine = engine, .stop = &stop});
    stop = true;
    EXPECT_THROW((void)oracle.Evaluate(receiver), Stopped);
    EXPECT_THROW((void)oracle.Evaluate(std::vector{receiver, receiver}),
                 Stopped);
    EXPECT_THROW((void)oracle.FormFactor(receiver, 1), Stopped);
    EXPECT_THROW((void)oracle.FormFactors(receiver), Stopped);
    EXPECT_EQ(oracle.scene().faces().size(), 4U);
    stop = false;
    const Oracle other(Lamps(2), {.engine = engine});
    EXPECT_EQ(oracle.Evaluate(receiver).value, other.Evaluate(receiver).value);
  }
}

// Stopped in the middle of a receiver, at whatever source it was.
TEST(Stop, TheOracleIsAsGoodAsNewAfterwards) {
  const Scene scene = Lamps(60);
  const Oracle untouched(scene);
  const std::vector<Receiver> receivers = {{{0, 0, 0}, {0, 0, 1}},
                                           {{30, 30, 0}, {0, 0, 1}},
                                           {{50, 9, 0}, {1, 0, 2}}};
  std::vector<Rgb> wanted;
  for (const Irradiance& e : untouched.Evaluate(receivers))
    wanted.push_back(e.value);
  StopFlag stop = false;
  const Oracle oracle(scene, {.stop = &stop});
  int stopped = 0;
  for (int microseconds = 100; microseconds < 30000; microseconds *= 2) {
    std::thread setter([&] {
      std::this_thread::sleep_for(std::chrono::microseconds(microseconds));
      stop = true;
    });
    try {
      for (;;)
        (void)oracle.Evaluate(receivers);
    } catch (const Stopped&) {
      ++stopped;
    }
    setter.join();
    stop = false;
    std::size_t i = 0;
    for (const Irradiance& e : oracle.Evaluate(receivers))
      ASSERT_EQ(e.value, wanted[i++]);
  }
  EXPECT_EQ(stopped, 9);
}

TEST(Stop, ReadingLooksAtTheFlag) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / "truelux_stop_test.obj";
  std::ofstream(path) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  StopFlag stop = true;
  EXPECT_THROW((void)ReadScene(path, {.stop = &stop}), Stopped);
  stop = false;
  EXPECT_TRUE(ReadScene(path, {.stop = &stop}).ok());
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace truelux
