// SPDX-License-Identifier: GPL-3.0-or-later
// A candidate's gradients of irradiance beside the certified ones.

#ifndef TRUELUX_COMPARE_GRADIENTS_GRADIENT_DATA_H_
#define TRUELUX_COMPARE_GRADIENTS_GRADIENT_DATA_H_

#include <array>
#include <span>
#include <vector>

#include "truelux/derivatives.h"

#include "compare/candidate_receivers.h"
#include "compare/candidates.h"

namespace truelux {

/// Values and truth of a receiver hold the compared channels first; the other
/// entries are 0 in both.
struct GradientData : CandidateReceivers {
  std::vector<GradientRow> values;  ///< [W/m^3]
  std::vector<GradientTruth> truth;
};

/// The gradients of the compared channels.
[[nodiscard]] GradientRow ComparedGradients(const CandidateReceivers& candidate,
                                            const Derivatives& derivatives);

/// What the candidate's value at one receiver is held against.
[[nodiscard]] GradientTruth TruthFor(const CandidateReceivers& candidate,
                                     const Derivatives& derivatives,
                                     const GradientRow& value);

/// Some receivers of a candidate, by their indices.
[[nodiscard]] GradientData SomeOf(const GradientData& data,
                                  std::span<const std::size_t> indices);

}  // namespace truelux

#endif  // TRUELUX_COMPARE_GRADIENTS_GRADIENT_DATA_H_
