// SPDX-License-Identifier: GPL-3.0-or-later
// What a diagnosis says.

#ifndef TRUELUX_COMPARE_VERDICT_H_
#define TRUELUX_COMPARE_VERDICT_H_

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/mistake_fit.h"

namespace truelux {

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
[[nodiscard]] std::string_view Name(Verdict verdict);

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

}  // namespace truelux

#endif  // TRUELUX_COMPARE_VERDICT_H_
