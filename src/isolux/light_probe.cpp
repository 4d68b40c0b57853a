// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/light_probe.h"

#include <cmath>
#include <cstddef>

#include "truelux/derivatives.h"

namespace truelux {

LightValue LightProbe::Weighted(const Irradiance& irradiance) const {
  LightValue sum;
  for (std::size_t k = 0; k < 3; ++k) {
    if (weights_[k] == 0) continue;
    const double term = weights_[k] * irradiance.value[k];
    sum.value += term;
    // The product and the sum are rounded, too; not with a weight of 1 alone.
    sum.bound += weights_[k] * irradiance.bound[k] +
                 (weights_[k] == 1 ? 0 : 0x1p-51 * term);
  }
  return sum;
}

LightValue LightProbe::ValueAt(const PlanPoint& p) const {
  count_.fetch_add(1, std::memory_order_relaxed);
  return Weighted(oracle_.Evaluate(plan_.ReceiverAt(p)));
}

LightSample LightProbe::SampleAt(const PlanPoint& p) const {
  count_.fetch_add(1, std::memory_order_relaxed);
  const Derivatives derivatives = oracle_.Derivatives(
      plan_.ReceiverAt(p), {.sphere = false, .jacobian = false});
  LightSample sample;
  sample.light = Weighted(derivatives.irradiance);
  if (derivatives.smoothness == Smoothness::kDiscontinuous) {
    sample.is_defined = false;
    return sample;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (weights_[k] == 0) continue;
    const PlanPoint part = plan_.Along(derivatives.channels[k].tangential);
    sample.gradient = sample.gradient + weights_[k] * part;
    const Vector3& bound = derivatives.bounds[k].tangential;
    // Turning the axes and adding rounds a few times.
    sample.gradient_bound +=
        weights_[k] *
        (std::hypot(bound.x, bound.y, bound.z) + 0x1p-48 * LengthOf(part));
  }
  return sample;
}

}  // namespace truelux
