// SPDX-License-Identifier: GPL-3.0-or-later
// What derivatives cost beside the irradiance alone, on the same receivers and
// in turns: medians of the time per receiver, one thread.
//
//   derivatives [ROUNDS [SCENE [ROW]]]
//
// SCENE and ROW: only what has these words in its name.

#include "truelux/derivatives.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <fmt/format.h>
#include <functional>
#include <string>
#include <vector>

#include "truelux/io.h"
#include "truelux/irradiance.h"

#include "scenes.h"
#include "text/quantile.h"

namespace truelux::bench {
namespace {

using Run = std::function<void()>;

double SecondsOf(const Run& run) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  run();
  const std::chrono::duration<double> time = Clock::now() - start;
  return time.count();
}

/// A grid of receivers on the floor of an example scene, face 1, at the height
/// 0 of the axis that is up.
BenchScene Example(const std::string& name, double low, double high,
                   bool y_is_up) {
  BenchScene scene;
  scene.name = name;
  scene.scene =
      *ReadScene(std::string(TRUELUX_EXAMPLES "/scenes/") + name + ".obj")
           .value;
  constexpr int kSide = 20;
  for (int i = 0; i < kSide * kSide; ++i) {
    const double u = low + (high - low) * (i % kSide + 0.37) / kSide;
    const double v = low + (high - low) * (i / kSide + 0.41) / kSide;
    scene.receivers.push_back(y_is_up ? Receiver{{u, 0, v}, {0, 1, 0}, 1}
                                      : Receiver{{u, v, 0}, {0, 0, 1}, 1});
  }
  return scene;
}

/// What is measured.
struct Choice {
  int rounds = 11;
  std::string scene;  ///< part of the name
  std::string row;    ///< likewise
};

void Measure(const BenchScene& bench, const Choice& choice) {
  if (bench.name.find(choice.scene) == std::string::npos) return;
  const Oracle certified(bench.scene);
  const Oracle plain(certified.prepared(), {.method = Method::kDouble});
  const auto& receivers = bench.receivers;
  const auto derivatives = [&receivers](const Oracle& oracle,
                                        const DerivativeOptions& options) {
    return [&oracle, &receivers, options] {
      oracle.Derivatives(receivers, options,
                         [](std::size_t, const Derivatives&) {});
    };
  };

  struct Row {
    const char* name;
    Run run;
    std::vector<double> times = {};
  };

  std::vector<Row> rows = {
      {"E", [&] { (void)certified.Evaluate(receivers); }},
      {"gradient, V, dE/dn", derivatives(certified, {false, false})},
      {"with J", derivatives(certified, {false, true})},
      {"with the sphere", derivatives(certified, {true, true})},
      {"E, double", [&] { (void)plain.Evaluate(receivers); }},
      {"gradient, V, dE/dn, double", derivatives(plain, {false, false})},
      {"six E (differences)",
       [&] {
         for (int i = 0; i < 6; ++i)
           (void)certified.Evaluate(receivers);
       }},
      {"dE/dv", [&] {
         for (const Receiver& receiver : receivers)
           (void)certified.VertexDerivatives(receiver);
       }}};
  std::erase_if(rows, [&choice](const Row& row) {
    return std::string(row.name).find(choice.row) == std::string::npos;
  });
  for (int round = 0; round < choice.rounds; ++round) {
    for (Row& row : rows)
      row.times.push_back(SecondsOf(row.run));
  }
  const double first = Median(rows.front().times);
  for (const Row& row : rows) {
    const double median = Median(row.times);
    fmt::print("{:12} {:28} {:9.2f} us  {:6.2f}\n", bench.name, row.name,
               1e6 * median / static_cast<double>(receivers.size()),
               median / first);
  }
}

}  // namespace
}  // namespace truelux::bench

int main(int argc, char** argv) {
  using namespace truelux::bench;
  Choice choice;
  if (argc > 1) choice.rounds = std::atoi(argv[1]);
  if (argc > 2) choice.scene = argv[2];
  if (argc > 3) choice.row = argv[3];
  Measure(MakeSlab(100, 200, 1), choice);
  Measure(Example("cornell_box", 5, 545, true), choice);
  Measure(Example("figure7_b", -3.5, 3.5, false), choice);
  return 0;
}
