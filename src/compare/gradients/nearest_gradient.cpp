// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/gradients/nearest_gradient.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/vector_math.h"

namespace truelux {

Vector3 NearestGradient(const Vector3& mean, std::span<const Kink> kinks,
                        std::size_t channel, const Vector3& value) {
  Vector3 missing = Difference(value, mean);
  if (!std::isfinite(LengthOf(missing))) return mean;
  // The distance is convex in the t, so that going over them one by one
  // comes to the nearest; kinks in few directions come there in few rounds.
  constexpr int kRounds = 1000;
  constexpr double kDone = 1e-13;
  std::vector<double> t(kinks.size(), 0);
  for (int round = 0; round < kRounds; ++round) {
    double change = 0;
    for (std::size_t k = 0; k < kinks.size(); ++k) {
      const double b = kinks[k].size[channel];
      if (b == 0) continue;
      const double next =
          std::clamp(t[k] + Dot(missing, kinks[k].normal) / b, -1.0, 1.0);
      missing = Difference(missing, Times((next - t[k]) * b, kinks[k].normal));
      change = std::max(change, std::abs(next - t[k]));
      t[k] = next;
    }
    if (change <= kDone) break;
  }
  Vector3 nearest = mean;
  for (std::size_t k = 0; k < kinks.size(); ++k) {
    nearest =
        Sum(nearest, Times(t[k] * kinks[k].size[channel], kinks[k].normal));
  }
  return nearest;
}

}  // namespace truelux
