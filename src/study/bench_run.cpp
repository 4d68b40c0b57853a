// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/bench_run.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fstream>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "truelux/irradiance.h"
#include "truelux/stop.h"

#include "base/receiver_block.h"
#include "baselines/timing.h"
#include "explain/receiver_reason.h"
#include "run/announce.h"
#include "run/deadline.h"
#include "run/interrupt.h"
#include "study/worst_receivers.h"
#include "text/evenly_picked.h"
#include "text/quantile.h"

namespace truelux {
namespace {

/// 0 .. count - 1 in an order whose every beginning is spread over the whole:
/// van der Corput's, by reversed bits.
std::vector<std::size_t> SpreadOrder(std::size_t count) {
  std::size_t bits = 0;
  while ((std::size_t{1} << bits) < count)
    ++bits;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < (std::size_t{1} << bits); ++i) {
    std::size_t reversed = 0;
    for (std::size_t k = 0; k < bits; ++k)
      reversed |= ((i >> k) & 1U) << (bits - 1 - k);
    if (reversed < count) order.push_back(reversed);
  }
  return order;
}

/// A method may take so long for a block of receivers where the limit is
/// shorter, so that a short limit still says what every usual method gives [s].
constexpr double kPatience = 1;

/// One method on the receivers that it is tried on.
class Entry {
 public:
  Entry(const Contender& method, const std::vector<Receiver>& all)
      : method_(method) {
    const std::size_t most =
        method.max_receivers == 0 ? all.size() : method.max_receivers;
    result_.name = method.name;
    result_.group = method.group;
    result_.note = method.note;
    result_.values.resize(all.size());
    // A method that is limited to few receivers is slow. It runs one receiver
    // at a time, so Ctrl-C takes effect quickly.
    if (method.max_receivers != 0) block_size_ = 1;
    indices_ = EvenlyPicked(all.size(), most);
    for (const std::size_t i : indices_)
      receivers_.push_back(all[i]);
  }

  /// Finds the values, until `seconds` are used up. A block that takes longer
  /// than that alone, and than kPatience, is given up if the method can stop.
  /// nothing: without limit.
  void FindValues(std::optional<double> seconds) {
    const std::size_t blocks =
        (receivers_.size() + block_size_ - 1) / block_size_;
    std::vector<std::size_t> tried;
    for (const std::size_t block : SpreadOrder(blocks)) {
      if (seconds && !tried.empty() && spent_ > *seconds) break;
      Announce(fmt::format("{}: {} of {} receivers", method_.name,
                           block_size_ * tried.size(), receivers_.size()));
      if (!HasRunBlock(block, seconds)) break;
      tried.push_back(block);
    }
    KeepTried(tried);
    if (tried.empty()) return;
    const std::size_t all = result_.values.size();
    result_.left_out = all - receivers_.size();
    result_.microseconds =
        1e6 * spent_ / static_cast<double>(receivers_.size());
  }

  /// Times the method once more, unless `seconds` are used up.
  void TimeOnce(double seconds) {
    if (receivers_.empty() || spent_ > seconds) return;
    const double begin = ThreadSeconds();
    const double once =
        SecondsOfRun([this] { RunAll(); }, method_.not_counted.get());
    spent_ += ThreadSeconds() - begin;
    rounds_.push_back(1e6 * once / static_cast<double>(receivers_.size()));
    result_.microseconds = Median(rounds_);
  }

  [[nodiscard]] const std::string& name() const { return method_.name; }

  /// Whether there is a receiver that it was quick enough for.
  [[nodiscard]] bool HasValues() const { return !receivers_.empty(); }

  /// Processor time of a receiver, as it was found [s].
  [[nodiscard]] double SecondsOfOne() const {
    return 1e-6 * result_.microseconds;
  }

  /// One receiver at a time, for receivers of which a block takes too long.
  void TakeSingly() { block_size_ = 1; }

  [[nodiscard]] MethodResult TakeResult() { return std::move(result_); }

 private:
  [[nodiscard]] std::size_t SizeOf(std::size_t block) const {
    return std::min(block_size_, receivers_.size() - block_size_ * block);
  }

  /// False if the time was up before the block was done.
  bool HasRunBlock(std::size_t block, std::optional<double> seconds) {
    if (!seconds || !method_.stop) {
      RunBlock(block);
      return true;
    }
    bool is_done = true;
    {
      const Deadline deadline(std::max(*seconds, kPatience), *method_.stop);
      try {
        RunBlock(block);
      } catch (const Stopped&) {
        is_done = false;
      }
    }
    *method_.stop = false;
    return is_done;
  }

  void RunBlock(std::size_t block) {
    const std::size_t first = block_size_ * block;
    const double begin = ThreadSeconds();
    const auto answers =
        method_.run(std::span(receivers_).subspan(first, SizeOf(block)));
    spent_ += ThreadSeconds() - begin;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      if (answers[i]) result_.values[indices_[first + i]] = answers[i]->value;
    }
  }

  /// Drops the receivers of the blocks that were not tried.
  void KeepTried(std::vector<std::size_t> tried) {
    std::ranges::sort(tried);
    std::vector<Receiver> receivers;
    for (const std::size_t block : tried) {
      const auto of_block =
          std::span(receivers_).subspan(block_size_ * block, SizeOf(block));
      receivers.insert(receivers.end(), of_block.begin(), of_block.end());
    }
    receivers_ = std::move(receivers);
  }

  void RunAll() const {
    for (std::size_t at = 0; at < receivers_.size(); at += block_size_) {
      StopIfInterrupted();
      method_.run(
          std::span(receivers_)
              .subspan(at, std::min(block_size_, receivers_.size() - at)));
    }
  }

  const Contender& method_;
  /// Consecutive receivers that the method is given at once, as in truelux
  /// eval; the program can be interrupted in between.
  std::size_t block_size_ = kReceiverBlock;
  std::vector<std::size_t> indices_;  ///< of the receivers, in the comparison
  std::vector<Receiver> receivers_;
  std::vector<double> rounds_;  ///< microseconds a receiver
  double spent_ = 0;            ///< processor time [s]
  MethodResult result_;
};

void TimeInTurns(std::vector<Entry>& entries, const BenchLimits& limits) {
  for (int round = 1; round <= limits.rounds; ++round) {
    for (Entry& entry : entries) {
      Announce(fmt::format("timing, round {} of {}: {}", round, limits.rounds,
                           entry.name()));
      entry.TimeOnce(limits.seconds);
    }
  }
}

std::vector<Rgb> TruthOf(const MethodResult& oracle) {
  std::vector<Rgb> truth;
  for (const std::optional<Rgb>& value : oracle.values)
    truth.push_back(value.value());
  return truth;
}

/// Describes the receivers, first those that a report shows, until the time is
/// used up: finding out what coincides exactly may take long.
void FindReasons(const Scene& scene, double seconds, Comparison& comparison) {
  comparison.reasons.resize(comparison.receivers.size());
  std::vector<std::size_t> order = ReceiversOf(WorstReceivers(comparison));
  std::vector<bool> listed(comparison.receivers.size(), false);
  for (const std::size_t i : order)
    listed[i] = true;
  for (std::size_t i = 0; i < listed.size(); ++i) {
    if (!listed[i]) order.push_back(i);
  }
  const Oracle oracle(scene);
  const double begin = ThreadSeconds();
  for (std::size_t done = 0; done < order.size(); ++done) {
    if (ThreadSeconds() - begin > seconds) break;
    Announce(fmt::format("looking at receivers: {} of {}", done, order.size()));
    const Receiver& receiver = comparison.receivers[order[done]];
    comparison.reasons[order[done]] =
        ReasonOf(scene, receiver, oracle.Contour(receiver));
  }
}

/// The name of the processor, or "".
std::string ProcessorName() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos)
      return line.substr(colon + 2);
  }
  return "";
}

}  // namespace

Comparison RunMethods(const Scene& scene, std::vector<Receiver> receivers,
                      const MethodList& list, const BenchLimits& limits) {
  Comparison comparison;
  comparison.receivers = std::move(receivers);
  comparison.absent = list.absent;
  comparison.processor = ProcessorName();
  std::vector<Entry> entries;
  for (const Contender& method : list.methods)
    entries.emplace_back(method, comparison.receivers);
  Entry& truth = entries.front();
  truth.FindValues(std::nullopt);
  const bool is_block_long =
      truth.SecondsOfOne() * kReceiverBlock > limits.seconds;
  for (Entry& entry : std::span(entries).subspan(1)) {
    if (is_block_long) entry.TakeSingly();
    entry.FindValues(limits.seconds);
  }
  TimeInTurns(entries, limits);
  for (Entry& entry : entries) {
    if (entry.HasValues())
      comparison.methods.push_back(entry.TakeResult());
    else
      comparison.absent.push_back(fmt::format(
          "{}: not done with one receiver in {:g} s; more --seconds "
          "would do",
          entry.name(), std::max(limits.seconds, kPatience)));
  }
  comparison.truth = TruthOf(comparison.methods.front());
  FindReasons(scene, limits.seconds, comparison);
  Announce("");
  return comparison;
}

}  // namespace truelux
