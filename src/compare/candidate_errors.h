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

/// Counts a receiver that is so many ulps away.
void CountUlps(std::uint64_t ulps, UlpHistogram& histogram);

/// "0", "1", "3..4", "> 2^52".
[[nodiscard]] std::string UlpBinText(std::size_t bin);

/// One entry per receiver. A receiver passes if in every compared channel
/// |value - E| <= tolerance * E or, where E is 0, value is at most
/// tolerance * (the largest E of that channel in the table); no nan passes.
[[nodiscard]] std::vector<CandidateError> ErrorsOf(const CandidateData& data,
                                                   double tolerance);

/// The number of binary64 numbers from a to b, infinities included: 0 if
/// a == b, 1 for neighbours. Neither is nan.
[[nodiscard]] std::uint64_t UlpsBetween(double a, double b);

[[nodiscard]] CandidateSummary Summarize(
    std::span<const CandidateError> errors);

/// The indices of the receivers with the largest excess, at most `most`,
/// largest first; of equal ones the first. Exact ones are left out.
[[nodiscard]] std::vector<std::size_t> WorstOf(
    std::span<const CandidateError> errors, std::size_t most);

}  // namespace truelux

#endif  // TRUELUX_COMPARE_CANDIDATE_ERRORS_H_
