// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/stages/channel_sums.h"

#include <algorithm>
#include <cmath>

#include "exact/ball_vector.h"

namespace truelux {
namespace {

/// numeric_limits' is a long double that -frounding-math has converted at run
/// time, which takes longer than the rest of this file.
constexpr double kLeastSubnormal = 0x1p-1074;

/// For each channel the power of two of its largest weight: 2^k <= M < 2^(k+1)
/// (-1074 if there is none).
std::array<int, 3> WeightExponents(const WeightedContour& contour) {
  std::array<int, 3> exponents{};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    double largest = kLeastSubnormal;
    for (const Rgb& weight : contour.weights) {
      largest = std::max(largest, weight[channel]);
    }
    exponents[channel] =
        largest < 0x1p-1022 ? std::ilogb(largest) : ExponentOf(largest);
  }
  return exponents;
}

/// x 2^exponent, any exponent, rounded once.
double TimesTwoTo(double x, int exponent) {
  if (exponent < -1022 || exponent > 1023) return std::ldexp(x, exponent);
  return x * PowerOfTwo(exponent);
}

/// The value loses at most half the least subnormal in each part, the bound
/// another half.
Ball<double> TimesTwoTo(const Ball<double>& x, int exponent) {
  return {TimesTwoTo(x.value, exponent),
          TimesTwoTo(x.error, exponent) + 0x1p-1073};
}

Ball<DoubleDouble> TimesTwoTo(const Ball<DoubleDouble>& x, int exponent) {
  return {
      {TimesTwoTo(x.value.high, exponent), TimesTwoTo(x.value.low, exponent)},
      TimesTwoTo(x.error, exponent) + 0x1p-1073};
}

/// An earlier channel with the same weights, or the channel itself.
std::size_t FirstAlike(const WeightedContour& contour, std::size_t channel) {
  for (std::size_t earlier = 0; earlier < channel; ++earlier) {
    const auto same = [&](const Rgb& w) { return w[earlier] == w[channel]; };
    if (std::ranges::all_of(contour.weights, same)) return earlier;
  }
  return channel;
}

}  // namespace

template <class T>
ChannelSums<T>::ChannelSums(const WeightedContour& contour)
    : contour_(contour),
      exponents_(WeightExponents(contour)),
      alike_{0, FirstAlike(contour, 1), FirstAlike(contour, 2)} {}

template <class T>
void ChannelSums<T>::Add(SourceId source, const Ball<T>& sum) {
  for (std::size_t channel = 0; channel < 3; ++channel) {
    if (alike_[channel] != channel || !contour_.IsLit(source, channel))
      continue;
    // Exact, or so small that kUnderflow covers what it lost.
    const double weight =
        TimesTwoTo(contour_.WeightOf(source)[channel], -exponents_[channel]);
    sums_[channel] = sums_[channel] + Ball<T>(weight) * sum;
  }
}

template <class T>
std::array<Ball<T>, 3> ChannelSums<T>::Finish(const Ball<T>& factor) const {
  std::array<Ball<T>, 3> result;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    result[channel] =
        alike_[channel] != channel
            ? result[alike_[channel]]
            : TimesTwoTo(sums_[channel] * factor, exponents_[channel]);
  }
  return result;
}

template class ChannelSums<double>;
template class ChannelSums<DoubleDouble>;

}  // namespace truelux
