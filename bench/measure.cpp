#include "measure.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <fmt/format.h>
#include <span>
#include <utility>

#include "announce.h"

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

/// Microseconds a receiver. Short runs are repeated, after one that does not
/// count: the method before may have left the caches and the heap in a state
/// whose mending must not be charged here.
double Time(const Entry& entry) {
  constexpr double kLeastSeconds = 0.005;
  double begin = ThreadSeconds();
  entry.method->run(entry.Receivers());
  double seconds = ThreadSeconds() - begin;
  int runs = 1;
  if (seconds < kLeastSeconds) {
    begin = ThreadSeconds();
    for (runs = 0, seconds = 0; seconds < kLeastSeconds; ++runs) {
      entry.method->run(entry.Receivers());
      seconds = ThreadSeconds() - begin;
    }
  }
  return 1e6 * seconds / (runs * static_cast<double>(entry.receivers));
}

/// Runs the methods of a task once; the first one's values are the truth.
void FindErrors(std::span<Entry> entries) {
  std::vector<Irradiance> truth;
  for (Entry& entry : entries) {
    Announce(entry.scene->name + ": " + entry.method->name);
    const std::vector<Irradiance> results =
        entry.method->run(entry.Receivers());
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

double ThreadSeconds() {
  std::timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) +
         1e-9 * static_cast<double>(time.tv_nsec);
}

double WallSeconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

double Median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle]
                                : (values[middle - 1] + values[middle]) / 2;
}

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
      entry.result.family = method.family;
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
