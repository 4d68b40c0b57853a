// SPDX-License-Identifier: GPL-3.0-or-later
// A method's errors in a few numbers.

#ifndef TRUELUX_STUDY_COMPARISON_SUMMARY_H_
#define TRUELUX_STUDY_COMPARISON_SUMMARY_H_

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "explain/value_error.h"
#include "study/comparison.h"

namespace truelux {

/// How many receivers have which error; each of the comparison counts once.
struct ErrorHistogram {
  static constexpr int kLowest = -17;  ///< decimal exponent of the first decade
  static constexpr std::size_t kDecades = 18;

  std::size_t exact = 0;
  /// decades[i]: 10^(kLowest + i) <= relative error < 10^(kLowest + i + 1);
  /// the first one also holds what is smaller, the last one, >= 1, has no end.
  std::array<std::size_t, kDecades> decades{};
  /// Light where there is none, all channels with truth > 0 being right.
  std::size_t false_light = 0;
  std::size_t no_value = 0;  ///< the method does not apply, or was not tried

  /// The largest count of a decade.
  [[nodiscard]] std::size_t HighestDecade() const;
};

/// The index into ErrorHistogram::decades for a relative error > 0.
[[nodiscard]] std::size_t DecadeOf(double relative_error);

/// What a method did on the receivers of a comparison.
struct MethodSummary {
  std::size_t answered = 0;     ///< receivers with a value
  std::size_t lit = 0;          ///< of these, with truth > 0 in some channel
  std::size_t exact = 0;        ///< receivers with all three certified numbers
  std::size_t false_light = 0;  ///< receivers with light in a dark channel

  /// Of the relative errors of the `lit` receivers; nothing if there are none.
  struct Relative {
    double median = 0;
    double percentile_95 = 0;
    double max = 0;
    double rms = 0;  ///< root of the mean square
  };

  std::optional<Relative> relative;
  double max_absolute = 0;  ///< over all answered receivers [W/m^2]
  ErrorHistogram histogram;

  [[nodiscard]] bool AnswersAll(const Comparison& comparison) const {
    return answered == comparison.receivers.size();
  }
};

/// Requires one value, or nothing, per receiver of the comparison.
[[nodiscard]] MethodSummary Summarize(const Comparison& comparison,
                                      const MethodResult& method);

/// The same for every method, in their order.
[[nodiscard]] std::vector<MethodSummary> SummarizeAll(
    const Comparison& comparison);

/// A method as what it costs and what it gives.
struct CostAndError {
  double cost = 0;
  double error = 0;
};

/// The indices of the points that no other point beats: none has at most their
/// cost and at most their error and is better in one of them. By cost; of
/// equal points the first.
[[nodiscard]] std::vector<std::size_t> ParetoFront(
    std::span<const CostAndError> points);

/// The groups of the methods, each once, in the order of appearance.
[[nodiscard]] std::vector<std::string> GroupsOf(const Comparison& comparison);

/// The index of a method's group in GroupsOf: its series in the pictures.
[[nodiscard]] std::size_t SeriesOf(const MethodResult& method,
                                   std::span<const std::string> groups);

}  // namespace truelux

#endif  // TRUELUX_STUDY_COMPARISON_SUMMARY_H_
