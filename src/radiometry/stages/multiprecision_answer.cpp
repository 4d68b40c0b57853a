// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/stages/multiprecision_answer.h"

#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "radiometry/stages/rounding.h"

namespace truelux {
namespace {

constexpr mpfr_prec_t kFirstPrecision = 128;

/// From here on an enclosure with one midpoint in it is taken as a tie.
constexpr mpfr_prec_t kTiePrecision = 4096;

/// No contour of area > 0 needs more; one without area (an engine's mistake)
/// would run for ever.
constexpr mpfr_prec_t kLastPrecision = 1 << 17;

}  // namespace

void AnswerCertified(double value, std::size_t channel, Channels& open,
                     Irradiance& result) {
  result.value[channel] = value;
  result.bound[channel] = HalfSpacing(value);
  open[channel] = false;
  if (std::isinf(value)) ++result.statistics.overflows;
}

void AnswerInMultiprecision(const MultiprecisionStage& stage, Channels& open,
                            Irradiance& result) {
  for (mpfr_prec_t p = kFirstPrecision; Any(open); p *= 2) {
    if (p > kLastPrecision) {
      throw std::logic_error("irradiance: a contour without area");
    }
    result.statistics.max_precision_bits = static_cast<std::uint64_t>(p);
    const std::array<Enclosure, 3> enclosures = stage.Evaluate(p);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      if (!open[channel]) continue;
      auto value = RoundIfCertain(enclosures[channel]);
      if (!value && p >= kTiePrecision) {
        value = RoundTieToEven(enclosures[channel]);
        if (value) ++result.statistics.ties;
      }
      if (value) AnswerCertified(*value, channel, open, result);
    }
  }
}

}  // namespace truelux
