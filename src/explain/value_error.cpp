// SPDX-License-Identifier: GPL-3.0-or-later
#include "explain/value_error.h"

#include <cmath>
#include <limits>

namespace truelux {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// |value - truth|, never "not a number".
double Distance(double value, double truth) {
  if (value == truth) return 0;
  const double distance = std::abs(value - truth);
  if (std::isnan(distance)) return kInfinity;
  return distance;
}

/// distance / truth for truth > 0; the truth itself may be infinite.
double RelativeTo(double truth, double distance) {
  if (distance == 0) return 0;
  return std::isinf(distance) ? kInfinity : distance / truth;
}

}  // namespace

ValueError ErrorOf(const Rgb& value, const Rgb& truth) {
  ValueError error;
  error.exact = true;
  std::size_t farthest = 0;
  for (std::size_t c = 0; c < truth.size(); ++c) {
    const double distance = Distance(value[c], truth[c]);
    if (distance != 0) error.exact = false;
    if (distance > error.absolute) {
      error.absolute = distance;
      farthest = c;
    }
    if (!(truth[c] > 0)) {
      if (distance != 0) error.false_light = true;
      continue;
    }
    const double relative = RelativeTo(truth[c], distance);
    if (!error.relative || relative > *error.relative) {
      error.relative = relative;
      error.channel = c;
    }
  }
  if (error.relative.value_or(0) == 0 && !error.exact) error.channel = farthest;
  return error;
}

}  // namespace truelux
