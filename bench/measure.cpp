// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <span>
#include <utility>

#include "baselines/timing.h"
#include "run/announce.h"

namespace truelux::bench {
namespace {

/// One method on one scene.
struct Entry {
  const BenchScene* scene = nullptr;
  const Contender* method = nullptr;
  std::size_t receivers = 0;
  Measurement result;

  [[nodiscard]] std::span<const Receiver> Receivers() const {
    return std::span(scene->receivers).first(receivers);
  }
};

/// Root of the mean of (error / truth)^2 over the entries with truth > 0.
template <class Error>
std::optional<double> RootMeanSquare(const std::vector<Irradiance>& results,
                                     const std::vector<Irradiance>& truth,
                                     Error error) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const double value = truth[i].value[0];
    if (value == 0) continue;
    const double relative = error(results[i], value) / value;
    sum += relative * relative;
    ++count;
  }
  if (count == 0) return std::nullopt;
  return std::sqrt(sum / count);
}

/// Microseconds a receiver.
double Time(const Entry& entry) {
  const double seconds =
      SecondsOfRun([&entry] { entry.method->run(entry.Receivers()); },
                   entry.method->not_counted.get());
  return 1e6 * seconds / static_cast<double>(entry.receivers);
}

/// The answers of a method that has one everywhere.
std::vector<Irradiance> Run(const Entry& entry) {
  std::vector<Irradiance> results;
  for (const std::optional<Irradiance>& e :
       entry.method->run(entry.Receivers()))
    results.push_back(e.value());
  return results;
}

/// Runs the methods of a task once; the first one's values are the truth.
void FindErrors(std::span<Entry> entries) {
  std::vector<Irradiance> truth;
  for (Entry& entry : entries) {
    Announce(entry.scene->name + ": " + entry.method->name);
    const std::vector<Irradiance> results = Run(entry);
    for (const Irradiance& irradiance : results)
      entry.result.statistics += irradiance.statistics;
    if (truth.empty()) {
      truth = results;
      entry.result.error = RootMeanSquare(
          results, truth,
          [](const Irradiance& e, double /*truth*/) { return e.bound[0]; });
    } else {
      entry.result.error = RootMeanSquare(
          results, truth, [](const Irradiance& e, double truth_of_it) {
            return e.value[0] - truth_of_it;
          });
    }
  }
}

}  // namespace

std::vector<Measurement> Measure(const std::vector<Task>& tasks,
                                 const Limits& limits) {
  std::vector<Entry> entries;
  for (const Task& task : tasks) {
    for (const Contender& method : task.methods) {
      const std::size_t all = task.scene->receivers.size();
      const std::size_t most =
          method.max_receivers == 0 ? all : method.max_receivers;
      Entry entry{task.scene, &method, std::min(all, most), {}};
      entry.result.scene = task.scene->name;
      entry.result.method = method.name;
      entry.result.family = method.group;
      entry.result.receivers = static_cast<int>(entry.receivers);
      entries.push_back(std::move(entry));
    }
  }
  std::size_t first = 0;
  for (const Task& task : tasks) {
    FindErrors(std::span(entries).subspan(first, task.methods.size()));
    first += task.methods.size();
  }
  const double start = WallSeconds();
  for (int round = 0; round < limits.rounds; ++round) {
    if (round > 0 && WallSeconds() - start > limits.seconds) break;
    for (Entry& entry : entries) {
      Announce(fmt::format("{}: {}, round {}", entry.scene->name,
                           entry.method->name, round + 1));
      entry.result.rounds.push_back(Time(entry));
    }
  }
  Announce("");
  std::vector<Measurement> results;
  results.reserve(entries.size());
  for (Entry& entry : entries)
    results.push_back(std::move(entry.result));
  return results;
}

const Measurement* Find(const std::vector<Measurement>& measurements,
                        std::string_view scene, std::string_view method) {
  const auto found =
      std::ranges::find_if(measurements, [&](const Measurement& m) {
        return m.scene == scene && m.method == method;
      });
  return found == measurements.end() ? nullptr : &*found;
}

double Ratio(const Measurement& a, const Measurement& b) {
  if (a.rounds.size() != b.rounds.size())
    return a.Microseconds() / b.Microseconds();
  std::vector<double> ratios;
  for (std::size_t i = 0; i < a.rounds.size(); ++i)
    ratios.push_back(a.rounds[i] / b.rounds[i]);
  return Median(std::move(ratios));
}

}  // namespace truelux::bench
