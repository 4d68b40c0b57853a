// SPDX-License-Identifier: GPL-3.0-or-later
// How far a candidate's values are from the truth, receiver by receiver and in
// a few numbers.

#ifndef TRUELUX_COMPARE_CANDIDATE_ERRORS_H_
#define TRUELUX_COMPARE_CANDIDATE_ERRORS_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "truelux/geometry.h"

#include "compare/candidate_receivers.h"
#include "explain/value_error.h"

namespace truelux {

/// A candidate beside the certified truth. Values and truth of a receiver hold
/// the compared channels first; the other entries are 0 in both.
struct CandidateData : CandidateReceivers {
  std::vector<Rgb> values;
  std::vector<Rgb> truth;

  /// Only the channels that are compared.
  [[nodiscard]] Rgb Compared(const Rgb& all_channels) const;
};

/// One receiver of a candidate.
struct CandidateError {
  ValueError error;
  bool is_dark = false;    ///< E = 0 in all compared channels
  bool no_number = false;  ///< some value is nan
  bool passes = false;
  /// The largest over the channels of |value - E| / E or, where E is 0, of
  /// |value| / (the largest E of the channel in the table): what is held
  /// against the tolerance. Infinite for nan.
  double excess = 0;
  /// How many binary64 numbers the value is away from E, the largest over the
  /// channels with E > 0.
  std::uint64_t ulps = 0;
  /// (value - E) / E of the channel that error.relative is of.
  double signed_relative = 0;
};

/// One entry per receiver. A receiver passes if in every compared channel
/// |value - E| <= tolerance * E or, where E is 0, value is at most
/// tolerance * (the largest E of that channel in the table); no nan passes.
[[nodiscard]] std::vector<CandidateError> ErrorsOf(const CandidateData& data,
                                                   double tolerance);

/// The number of binary64 numbers from a to b, infinities included: 0 if
/// a == b, 1 for neighbours. Neither is nan.
[[nodiscard]] std::uint64_t UlpsBetween(double a, double b);

/// How many receivers are how many binary64 numbers away from the truth.
struct UlpHistogram {
  /// The largest number of ulps that a bin holds.
  static constexpr std::array<std::uint64_t, 10> kLast = {
      0,
      1,
      2,
      4,
      16,
      256,
      std::uint64_t{1} << 16U,
      std::uint64_t{1} << 32U,
      std::uint64_t{1} << 52U,
      ~std::uint64_t{0}};
  std::array<std::size_t, kLast.size()> counts{};

  void Add(std::uint64_t ulps);
  /// "0", "1", "3..4", "> 2^52".
  [[nodiscard]] static std::string BinText(std::size_t bin);
};

/// A candidate in a few numbers. Every receiver is lit (E > 0 in a compared
/// channel), dark (E = 0) or, whatever E, without a number.
struct CandidateSummary {
  std::size_t receivers = 0;
  std::size_t lit = 0;
  std::size_t dark = 0;
  std::size_t no_number = 0;
  std::size_t lit_exact = 0;   ///< all compared channels are the truth's bits
  std::size_t dark_exact = 0;  ///< 0 where E is 0
  std::size_t lit_failing = 0;
  std::size_t dark_failing = 0;

  /// Of the lit receivers' relative errors, each that of its worst channel.
  struct Relative {
    double mean = 0;  ///< of the sizes
    double bias = 0;  ///< mean with sign: > 0 is too bright
    double rms = 0;
    double median = 0;
    double percentile_95 = 0;
    double percentile_99 = 0;
    double max = 0;
  };

  std::optional<Relative> relative;
  double max_absolute = 0;       ///< over lit and dark receivers [W/m^2]
  double max_dark_absolute = 0;  ///< over dark ones
  UlpHistogram ulps;             ///< of the lit receivers

  [[nodiscard]] std::size_t failing() const {
    return lit_failing + dark_failing + no_number;
  }
};

[[nodiscard]] CandidateSummary Summarize(
    std::span<const CandidateError> errors);

/// The indices of the receivers with the largest excess, at most `most`,
/// largest first; of equal ones the first. Exact ones are left out.
[[nodiscard]] std::vector<std::size_t> WorstOf(
    std::span<const CandidateError> errors, std::size_t most);

}  // namespace truelux

#endif  // TRUELUX_COMPARE_CANDIDATE_ERRORS_H_
