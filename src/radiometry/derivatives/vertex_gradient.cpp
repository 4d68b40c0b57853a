// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstddef>

#include "truelux/derivatives.h"

namespace truelux {

VertexGradient::VertexGradient(const Scene& scene)
    : numbers_(scene.corner_numbers().begin(), scene.corner_numbers().end()) {
  std::ranges::sort(numbers_);
  numbers_.erase(std::unique(numbers_.begin(), numbers_.end()), numbers_.end());
  values_.resize(numbers_.size());
}

void VertexGradient::Add(const VertexDerivatives& derivatives,
                         const Rgb& weights) {
  for (const VertexDerivative& vertex : derivatives.vertices) {
    const auto at = std::ranges::lower_bound(numbers_, vertex.number);
    if (at == numbers_.end() || *at != vertex.number) continue;
    Vector3& value = values_[static_cast<std::size_t>(at - numbers_.begin())];
    const std::array<double*, 3> axes = {&value.x, &value.y, &value.z};
    for (std::size_t channel = 0; channel < 3; ++channel) {
      if (weights[channel] == 0) continue;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const VertexSlope& slope = vertex.slopes[channel][axis];
        if (!slope.IsSmooth()) ++one_sided_;
        const double mean = slope.IsSmooth()
                                ? slope.left
                                : 0.5 * slope.left + 0.5 * slope.right;
        *axes[axis] += weights[channel] * mean;
      }
    }
  }
}

}  // namespace truelux
