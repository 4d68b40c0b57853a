// SPDX-License-Identifier: GPL-3.0-or-later
// What double-double arithmetic costs.

#include <cstddef>
#include <cstdint>
#include <vector>

#include <benchmark/benchmark.h>

#include "exact/atan2.h"
#include "exact/double_double.h"
#include "support/portable_random.h"

namespace truelux::bench {
namespace {

constexpr std::uint64_t kSeed = 1;

/// Numbers of both signs with full low parts, the same in every run.
std::vector<DoubleDouble> Operands() {
  constexpr std::size_t kCount = 1024;
  testing::PortableRandom random(kSeed);
  std::vector<DoubleDouble> numbers;
  while (numbers.size() < kCount) {
    const double high = random.Uniform(-2, 2);
    numbers.push_back(TwoSum(high, high * random.Uniform(-0x1p-54, 0x1p-54)));
  }
  return numbers;
}

/// One operation on many independent pairs; the time is per operation.
template <class Operation>
void TimeOperation(benchmark::State& state, Operation operation) {
  const std::vector<DoubleDouble> numbers = Operands();
  while (state.KeepRunning()) {
    for (std::size_t i = 0; i + 1 < numbers.size(); ++i)
      benchmark::DoNotOptimize(operation(numbers[i], numbers[i + 1]));
  }
  state.SetItemsProcessed(state.iterations() *
                          static_cast<std::int64_t>(numbers.size() - 1));
}

void DoubleDoubleAdd(benchmark::State& state) {
  TimeOperation(state, [](const auto& a, const auto& b) { return a + b; });
}

void DoubleDoubleMultiply(benchmark::State& state) {
  TimeOperation(state, [](const auto& a, const auto& b) { return a * b; });
}

void DoubleDoubleDivide(benchmark::State& state) {
  TimeOperation(state, [](const auto& a, const auto& b) { return a / b; });
}

void DoubleDoubleSqrt(benchmark::State& state) {
  TimeOperation(
      state, [](const auto& a, const auto& b) { return Sqrt(a * a + b * b); });
}

void DoubleDoubleAtan2(benchmark::State& state) {
  TimeOperation(state,
                [](const auto& a, const auto& b) { return Atan2(a, b); });
}

BENCHMARK(DoubleDoubleAdd);
BENCHMARK(DoubleDoubleMultiply);
BENCHMARK(DoubleDoubleDivide);
BENCHMARK(DoubleDoubleSqrt);
BENCHMARK(DoubleDoubleAtan2);

}  // namespace
}  // namespace truelux::bench
