#include "radiometry/ball_stage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "radiometry/ball_terms.h"

namespace truelux {
namespace {

/// 1 / (2 pi); the low part is the error of the high one, and u^2 times the
/// value bounds the error of both.
constexpr DoubleDouble kInverseTwoPi{0x1.45f306dc9c883p-3,
                                     -0x1.6b01ec5417056p-57};

template <class T>
Ball<T> InverseTwoPi() {
  if constexpr (std::is_same_v<T, double>) {
    return {kInverseTwoPi.high, 0x1p-56};
  } else {
    return {kInverseTwoPi, kUnitSquared * kInverseTwoPi.high};
  }
}

/// 2 pi F of one source: the sum of its arcs' terms.
template <class T>
Ball<T> SumOfTerms(const BallGeometry<T>& geometry, std::span<const Arc> arcs,
                   Formula formula, const std::vector<bool>& on_horizon) {
  Ball<T> sum(0.0);
  for (const Arc& arc : arcs) {
    if (formula == Formula::kLambert) {
      sum = sum + LambertTerm(geometry, arc);
    } else {
      const bool flat = on_horizon[static_cast<std::size_t>(arc.plane)];
      sum = sum + HomogeneousTerm(geometry, arc, flat);
    }
  }
  return sum;
}

/// For each channel the power of two of its largest weight: 2^k <= M < 2^(k+1)
/// (-1074 if there is none).
std::array<int, 3> WeightExponents(const WeightedContour& contour) {
  std::array<int, 3> exponents{};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    double largest = std::numeric_limits<double>::denorm_min();
    for (const Rgb& weight : contour.weights) {
      largest = std::max(largest, weight[channel]);
    }
    exponents[channel] = std::ilogb(largest);
  }
  return exponents;
}

/// x 2^exponent. The value loses at most half the least subnormal in each
/// part, the bound another half.
Ball<double> TimesPowerOfTwo(const Ball<double>& x, int exponent) {
  return {std::ldexp(x.value, exponent),
          std::ldexp(x.error, exponent) + 0x1p-1073};
}

Ball<DoubleDouble> TimesPowerOfTwo(const Ball<DoubleDouble>& x, int exponent) {
  return {
      {std::ldexp(x.value.high, exponent), std::ldexp(x.value.low, exponent)},
      std::ldexp(x.error, exponent) + 0x1p-1073};
}

}  // namespace

template <class T>
std::array<Ball<T>, 3> EvaluateInBalls(const WeightedContour& contour,
                                       const EvaluationQuery& evaluation,
                                       const std::vector<bool>& on_horizon) {
  const BallGeometry<T> geometry(contour, evaluation.formula);
  // Weights are taken relative to the channel's largest, so that neither faint
  // nor very bright sources leave the range in which balls are narrow.
  const std::array<int, 3> exponents = WeightExponents(contour);
  std::array<Ball<T>, 3> result;
  for (std::size_t i = 0; i < contour.contour.sources.size(); ++i) {
    if (!contour.IsLit(i)) continue;
    const Ball<T> sum =
        SumOfTerms(geometry, contour.ArcsOf(contour.contour.sources[i]),
                   evaluation.formula, on_horizon);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      if (!contour.IsLit(i, channel)) continue;
      // Exact, or so small that kUnderflow covers what it lost.
      const double weight =
          std::ldexp(contour.weights[i][channel], -exponents[channel]);
      result[channel] = result[channel] + Ball<T>(weight) * sum;
    }
  }
  // E = M F = (M / 2 pi) sum, and M = pi L.
  const Ball<T> factor = evaluation.emission == Emission::kRadiance
                             ? Ball<T>(0.5)
                             : InverseTwoPi<T>();
  for (std::size_t channel = 0; channel < 3; ++channel) {
    result[channel] =
        TimesPowerOfTwo(result[channel] * factor, exponents[channel]);
  }
  return result;
}

template std::array<Ball<double>, 3> EvaluateInBalls<double>(
    const WeightedContour&, const EvaluationQuery&, const std::vector<bool>&);
template std::array<Ball<DoubleDouble>, 3> EvaluateInBalls<DoubleDouble>(
    const WeightedContour&, const EvaluationQuery&, const std::vector<bool>&);

}  // namespace truelux
