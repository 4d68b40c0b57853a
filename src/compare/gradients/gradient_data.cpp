// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/gradients/gradient_data.h"

#include <cstddef>

#include "compare/gradients/nearest_gradient.h"

namespace truelux {

GradientRow ComparedGradients(const CandidateReceivers& candidate,
                              const Derivatives& derivatives) {
  GradientRow gradients{};
  for (std::size_t c = 0; c < candidate.channels.size(); ++c)
    gradients[c] = derivatives.channels[candidate.channels[c]].gradient;
  return gradients;
}

GradientTruth TruthFor(const CandidateReceivers& candidate,
                       const Derivatives& derivatives,
                       const GradientRow& value) {
  GradientTruth truth{derivatives.smoothness,
                      ComparedGradients(candidate, derivatives)};
  if (derivatives.kinks.empty()) return truth;
  for (std::size_t c = 0; c < candidate.channels.size(); ++c) {
    truth.gradient[c] = NearestGradient(truth.gradient[c], derivatives.kinks,
                                        candidate.channels[c], value[c]);
  }
  return truth;
}

GradientData SomeOf(const GradientData& data,
                    std::span<const std::size_t> indices) {
  GradientData some{SomeReceiversOf(data, indices), {}, {}};
  for (const std::size_t i : indices) {
    some.values.push_back(data.values[i]);
    some.truth.push_back(data.truth[i]);
  }
  return some;
}

}  // namespace truelux
