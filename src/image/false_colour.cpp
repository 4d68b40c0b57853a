// SPDX-License-Identifier: GPL-3.0-or-later
#include "image/false_colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace truelux {
namespace {

/// Viridis at 0, 1/8, .. 1.
constexpr std::array<Rgba8, 9> kViridis = {{{68, 1, 84, 255},
                                            {71, 44, 122, 255},
                                            {59, 81, 139, 255},
                                            {44, 113, 142, 255},
                                            {33, 144, 141, 255},
                                            {39, 173, 129, 255},
                                            {92, 200, 99, 255},
                                            {170, 220, 50, 255},
                                            {253, 231, 37, 255}}};

/// The least of 1, 2, 5, 10, .. times a power of ten that is not less than x.
double RoundStep(double x) {
  const double power = std::pow(10.0, std::floor(std::log10(x)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= x) return factor * power;
  }
  constexpr double kNext = 10;
  return kNext * power;
}

}  // namespace

Rgba8 FalseColour(double share) {
  constexpr double kLast = kViridis.size() - 1;
  // Written so that a NaN is the first colour.
  const double place = share > 0 ? std::min(share, 1.0) * kLast : 0;
  const auto index =
      std::min(static_cast<std::size_t>(place), kViridis.size() - 2);
  const double rest = place - static_cast<double>(index);
  const Rgba8& from = kViridis[index];
  const Rgba8& to = kViridis[index + 1];
  const auto mixed = [rest](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround((1 - rest) * a + rest * b));
  };
  return {mixed(from.red, to.red), mixed(from.green, to.green),
          mixed(from.blue, to.blue), 255};
}

ColourScale ColourScale::Linear(double most, bool whole) {
  constexpr double kMostTicks = 8;
  ColourScale scale;
  scale.high_ = most;
  double step = RoundStep(most / kMostTicks);
  if (whole) step = std::max(step, 1.0);
  // Rounding must not take the last one away, nor make endless many.
  constexpr double kSlack = 1 + 1e-12;
  for (int i = 0; i <= kMostTicks && i * step <= most * kSlack; ++i)
    scale.ticks_.push_back(i * step);
  return scale;
}

ColourScale ColourScale::Logarithmic(double least, double most) {
  ColourScale scale;
  scale.logarithmic_ = true;
  scale.high_ = std::ceil(std::log10(most));
  scale.low_ = std::max(std::floor(std::log10(least)), scale.high_ - kDecades);
  if (scale.low_ == scale.high_) scale.low_ -= 1;
  const auto last = static_cast<int>(scale.high_);
  for (auto power = static_cast<int>(scale.low_); power <= last; ++power)
    scale.ticks_.push_back(std::pow(10.0, power));
  return scale;
}

double ColourScale::At(double value) const {
  if (!(value > 0)) return 0;
  const double place = logarithmic_ ? std::log10(value) : value;
  if (place >= high_) return 1;
  return std::max(0.0, (place - low_) / (high_ - low_));
}

}  // namespace truelux
