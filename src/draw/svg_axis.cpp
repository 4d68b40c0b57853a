// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/svg_axis.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>

namespace truelux {

void DecadeAxis::Cover(double value) {
  constexpr double kRoom = 0.3;
  const double decade = std::log10(value);
  low = std::min(low, static_cast<int>(std::floor(decade - kRoom)));
  high = std::max(high, static_cast<int>(std::ceil(decade + kRoom)));
}

double DecadeAxis::At(double value) const {
  assert(low < high);
  return (std::log10(value) - low) / (high - low);
}

std::string TimeLabel(int exponent) {
  constexpr std::array<const char*, 4> kUnits = {"ns", "\u00b5s", "ms", "s"};
  const std::ptrdiff_t thousands =
      std::clamp(static_cast<int>(std::floor(exponent / 3.0)), -1, 2);
  return fmt::format(
      "{:g} {}", std::pow(10.0, static_cast<double>(exponent - 3 * thousands)),
      kUnits[static_cast<std::size_t>(thousands + 1)]);
}

}  // namespace truelux
