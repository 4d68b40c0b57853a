// SPDX-License-Identifier: GPL-3.0-or-later
// The last stage: growing precision until an irradiance rounds one way.

#ifndef TRUELUX_RADIOMETRY_STAGES_MULTIPRECISION_ANSWER_H_
#define TRUELUX_RADIOMETRY_STAGES_MULTIPRECISION_ANSWER_H_

#include <array>
#include <cstddef>

#include "truelux/irradiance.h"

#include "radiometry/stages/multiprecision_stage.h"

namespace truelux {

/// Which channels are still to be answered.
using Channels = std::array<bool, 3>;

inline bool Any(const Channels& channels) {
  return channels[0] || channels[1] || channels[2];
}

/// Answers one channel by the binary64 nearest to E.
void AnswerCertified(double value, std::size_t channel, Channels& open,
                     Irradiance& result);

/// Answers all open channels, in each of which E is not zero: with 128, 256,
/// ... bits until the enclosure rounds one way; a midpoint still enclosed at
/// 4096 bits or more is a tie and goes to even.
void AnswerInMultiprecision(const MultiprecisionStage& stage, Channels& open,
                            Irradiance& result);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_STAGES_MULTIPRECISION_ANSWER_H_
