// SPDX-License-Identifier: GPL-3.0-or-later
// The library alone over a grid of receivers on the floor of the Cornell box,
// beside which python_overhead.py sets the Python package.
//
//   oracle_grid SCENE.obj SIDE THREADS
//
// Writes the seconds of one evaluation of all SIDE x SIDE receivers for every
// line that it reads, so that whoever writes these lines can measure in turns.

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <span>
#include <string>
#include <vector>

#include "truelux/io.h"
#include "truelux/irradiance.h"
#include "truelux/receiver.h"

#include "run/parallel.h"
#include "run/progress.h"

namespace truelux::bench {
namespace {

/// As numpy.linspace(5, 545, side).
double Coordinate(int i, int side) {
  constexpr double kFirst = 5;
  constexpr double kLength = 540;
  return side == 1 ? kFirst : kFirst + i * (kLength / (side - 1));
}

std::vector<Receiver> FloorGrid(int side) {
  std::vector<Receiver> receivers;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      receivers.push_back(
          {{Coordinate(i, side), 0, Coordinate(j, side)}, {0, 1, 0}, 1});
    }
  }
  return receivers;
}

int Run(const char* scene_path, int side, int threads) {
  const Result<Scene> scene = ReadScene(scene_path);
  if (!scene.ok() || side < 1 || threads < 1) return 2;
  const Oracle oracle(*scene.value);
  const std::vector<Receiver> receivers = FloorGrid(side);
  std::vector<Rgb> values(receivers.size());
  for (std::string line; std::getline(std::cin, line);) {
    const auto start = std::chrono::steady_clock::now();
    Progress progress(receivers.size(), kReceivers, {});
    EvaluateInParallel(oracle, receivers, threads, progress,
                       [&](std::size_t i, const Irradiance& irradiance) {
                         values[i] = irradiance.value;
                       });
    const std::chrono::duration<double> seconds =
        std::chrono::steady_clock::now() - start;
    std::printf("%.9g\n", seconds.count());
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace
}  // namespace truelux::bench

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fputs("usage: oracle_grid SCENE.obj SIDE THREADS\n", stderr);
    return 2;
  }
  return truelux::bench::Run(argv[1], std::atoi(argv[2]), std::atoi(argv[3]));
}
