// SPDX-License-Identifier: GPL-3.0-or-later
// What the oracle and its parts cost.

#include <cstdint>
#include <vector>

#include <benchmark/benchmark.h>

#include "truelux/irradiance.h"

#include "radiometry/evaluate.h"
#include "scenes.h"
#include "visibility/contour.h"
#include "visibility/edges/contour_engine.h"

namespace truelux::bench {
namespace {

constexpr std::uint64_t kSeed = 1;

/// Argument: the number of blockers.
BenchScene Slab(const benchmark::State& state) {
  constexpr int kReceivers = 64;
  return MakeSlab(static_cast<int>(state.range(0)), kReceivers, kSeed);
}

std::int64_t CountOf(const benchmark::State& state, const BenchScene& scene) {
  return state.iterations() * static_cast<std::int64_t>(scene.receivers.size());
}

void TimeOracle(benchmark::State& state, Method method) {
  const BenchScene slab = Slab(state);
  const Oracle oracle(slab.scene, {.method = method});
  while (state.KeepRunning())
    benchmark::DoNotOptimize(oracle.Evaluate(slab.receivers));
  state.SetItemsProcessed(CountOf(state, slab));
}

void OracleCertified(benchmark::State& state) {
  TimeOracle(state, Method::kCertified);
}

void OracleDouble(benchmark::State& state) {
  TimeOracle(state, Method::kDouble);
}

void TimeRecordedContours(benchmark::State& state, Method method) {
  const BenchScene slab = Slab(state);
  const ContourEngine engine(slab.scene);
  std::vector<ContourQuery> queries;
  std::vector<Contour> contours;
  for (const Receiver& receiver : slab.receivers) {
    queries.push_back({slab.scene, receiver});
    contours.push_back(engine.Build(queries.back()));
  }
  while (state.KeepRunning()) {
    for (std::size_t i = 0; i < queries.size(); ++i) {
      benchmark::DoNotOptimize(
          EvaluateContour(queries[i], contours[i], {.method = method}));
    }
  }
  state.SetItemsProcessed(CountOf(state, slab));
}

void EvaluateContourCertified(benchmark::State& state) {
  TimeRecordedContours(state, Method::kCertified);
}

void EvaluateContourDouble(benchmark::State& state) {
  TimeRecordedContours(state, Method::kDouble);
}

/// Argument: 2 n (n - 1) triangles.
void OracleConstruction(benchmark::State& state) {
  const BenchScene sphere =
      MakeSphere(static_cast<int>(state.range(0)), 1, kSeed);
  while (state.KeepRunning())
    benchmark::DoNotOptimize(Oracle(sphere.scene));
  state.SetItemsProcessed(
      state.iterations() *
      static_cast<std::int64_t>(sphere.scene.triangles().size()));
}

BENCHMARK(OracleCertified)->Arg(10)->Arg(100);
BENCHMARK(OracleDouble)->Arg(10)->Arg(100);
BENCHMARK(EvaluateContourCertified)->Arg(10)->Arg(100);
BENCHMARK(EvaluateContourDouble)->Arg(10)->Arg(100);
BENCHMARK(OracleConstruction)->Arg(40)->Arg(187)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace truelux::bench
