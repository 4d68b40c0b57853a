// SPDX-License-Identifier: GPL-3.0-or-later
// What a comparison with another program says (compare.h).

#ifndef TRUELUX_COMPARISON_H_
#define TRUELUX_COMPARISON_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "truelux/export.h"
#include "truelux/geometry.h"

namespace truelux {

/// How far a value is from the truth at one receiver, over its three channels.
/// A value that is no number, or infinite where the truth is not, is
/// infinitely far.
struct ValueError {
  bool exact = false;  ///< all three channels are the certified numbers
  /// The largest |value - truth| / truth over the channels with truth > 0;
  /// nothing if there are none.
  std::optional<double> relative;
  double absolute = 0;  ///< the largest |value - truth| [W/m^2]
  /// A channel whose truth is 0 has a value that is not 0.
  bool false_light = false;
  std::size_t channel = 0;  ///< that `relative`, or else `absolute`, is of
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

/// The distance of a candidate's value from the truth is measured by the
/// larger of truth and prediction, in absolute value (where both are 0, by the
/// largest truth of its channel); that from the prediction by the prediction,
/// or by 1e-9 of the former if that is more: values at or above the threshold
/// are not counted as dark. For a constant factor either is measured by itself. The loss of a
/// value is the square of its distance, at most 1.
///
/// A value is disputed if prediction and truth differ by more than the
/// candidate's noise can: 1e-12, and three times the median distance from the
/// prediction where that is not 0; for a constant factor wherever the truth is
/// not 0.
struct MistakeFit {
  std::size_t receivers = 0;  ///< tried
  std::size_t disputed = 0;   ///< of these, with a disputed value
  /// Over the disputed values: the median distance from the truth and from the
  /// prediction.
  double median_before = 0;
  double median_after = 0;
  /// The mean loss of all values.
  double loss_before = 0;
  double loss_after = 0;
  /// The mean loss of the disputed values.
  double disputed_loss_before = 0;
  double disputed_loss_after = 0;
  std::size_t passing_before = 0;  ///< receivers that pass
  std::size_t passing_after = 0;   ///< .. if the prediction were the truth
};

enum class Verdict {
  kNothingFails,  ///< every receiver passes; nothing was tried
  kMistake,       ///< a classic mistake explains the candidate
  kOffFaces,      ///< the candidate is right, but its receivers lie behind
                  ///< their faces by a rounding error
  kNoise,         ///< errors look like those of an unbiased Monte Carlo
  kUnexplained,
};

/// "nothing fails", "mistake", "receivers off their faces", "noise",
/// "unexplained".
[[nodiscard]] TRUELUX_EXPORT std::string_view Name(Verdict verdict);

/// The relative errors of the lit receivers, each the mean over its channels
/// with E > 0, as a random sample.
struct NoiseTraits {
  std::size_t receivers = 0;
  double size = 0;            ///< root of the mean square
  double bias = 0;            ///< mean, > 0 is too bright
  double standard_error = 0;  ///< of the mean
  /// No sign of anything but noise: at least 8 receivers; the bias, and that of
  /// the sum of all values, within three of its standard errors; at least a
  /// tenth of the errors of each sign; most receivers affected, and none that
  /// is dark or no number; no larger than the values themselves.
  bool looks_unbiased = false;
};

/// Why a candidate fails.
struct Diagnosis {
  Verdict verdict = Verdict::kNothingFails;
  std::string mistake;  ///< its name; "" unless the verdict is kMistake
  std::string text;     ///< one or more sentences
  std::optional<double> factor;      ///< if the mistake is one
  std::optional<MistakeFit> fit;     ///< of the mistake
  std::vector<std::string> equally;  ///< sentences of others that predict the
                                     ///< same values
  std::optional<NoiseTraits> noise;
  std::vector<std::string> tried;  ///< names of the mistakes
  std::vector<std::string> notes;  ///< what was not tried
  std::size_t receivers = 0;       ///< on so many it was tried
};

/// One of the receivers with the largest errors.
struct ReceiverReason {
  std::size_t receiver = 0;  ///< its index
  std::string reason;        ///< what it sees, and what is hard about it
};

/// What comparisons of every quantity have.
struct ComparisonReport {
  std::vector<ReceiverReason> worst;  ///< worst first, at most ten
  Diagnosis diagnosis;
  std::string text;  ///< the report of truelux compare
  std::string json;  ///< the same as one JSON object (docs/compare.md)
};

/// A candidate's irradiances, or form factors, held against the truth.
struct CandidateComparison : ComparisonReport {
  std::vector<Rgb> truth;  ///< certified, one per receiver; all channels
  std::vector<CandidateError> errors;  ///< one per receiver
  CandidateSummary summary;

  /// Whether every receiver is within the tolerance.
  [[nodiscard]] bool passes() const { return summary.failing() == 0; }
};

}  // namespace truelux

#endif  // TRUELUX_COMPARISON_H_
