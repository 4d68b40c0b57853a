// SPDX-License-Identifier: GPL-3.0-or-later
// The same interface in a build without Embree.

#include <stdexcept>

#include "baselines/sampled.h"

namespace truelux {

struct ShadowRays::Impl {};

bool ShadowRaysAvailable() {
  return false;
}

ShadowRays::ShadowRays(const Scene& /*scene*/) {
  throw std::runtime_error("built without Embree 3 (Debian: libembree-dev)");
}

ShadowRays::~ShadowRays() = default;
ShadowRays::ShadowRays(ShadowRays&&) noexcept = default;
ShadowRays& ShadowRays::operator=(ShadowRays&&) noexcept = default;

Rgb ShadowRays::Estimate(const Receiver& /*receiver*/,
                         const EmitterSamples& /*samples*/) const {
  return {};
}

}  // namespace truelux
