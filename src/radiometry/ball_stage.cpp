#include "radiometry/ball_stage.h"

#include <algorithm>
#include <cmath>
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

/// 2 pi |n| F of one source.
template <class T>
Ball<T> SumOfTerms(const BallGeometry<T>& geometry, std::span<const Arc> arcs,
                   Formula formula, const std::vector<bool>& on_horizon) {
  if (!SumsOverVertices(formula)) return LambertTerms(geometry, arcs);
  Ball<T> sum(0.0);
  for (const Arc& arc : arcs) {
    const bool flat = on_horizon[static_cast<std::size_t>(arc.plane)];
    sum = sum + HomogeneousTerm(geometry, arc, flat);
  }
  return sum;
}

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
std::array<Ball<T>, 3> EvaluateInBalls(const WeightedContour& contour,
                                       const EvaluationQuery& evaluation,
                                       const std::vector<bool>& on_horizon,
                                       BallGeometry<T>& geometry) {
  geometry.Evaluate(contour);
  // Weights are taken relative to the channel's largest, so that neither faint
  // nor very bright sources leave the range in which balls are narrow.
  const std::array<int, 3> exponents = WeightExponents(contour);
  const std::array<std::size_t, 3> alike = {0, FirstAlike(contour, 1),
                                            FirstAlike(contour, 2)};
  std::array<Ball<T>, 3> result;
  for (std::size_t i = 0; i < contour.contour.sources.size(); ++i) {
    if (!contour.IsLit(i)) continue;
    const Ball<T> sum =
        SumOfTerms(geometry, contour.ArcsOf(contour.contour.sources[i]),
                   evaluation.formula, on_horizon);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      if (alike[channel] != channel || !contour.IsLit(i, channel)) continue;
      // Exact, or so small that kUnderflow covers what it lost.
      const double weight =
          TimesTwoTo(contour.weights[i][channel], -exponents[channel]);
      result[channel] = result[channel] + Ball<T>(weight) * sum;
    }
  }
  // E = M F = (M / 2 pi) sum / |n|, and M = pi L.
  const BallVector<T>& n = geometry.receiver_normal();
  const Ball<T> factor =
      (evaluation.emission == Emission::kRadiance ? Ball<T>(0.5)
                                                  : InverseTwoPi<T>()) /
      Sqrt(Dot(n, n));
  for (std::size_t channel = 0; channel < 3; ++channel) {
    result[channel] =
        alike[channel] != channel
            ? result[alike[channel]]
            : TimesTwoTo(result[channel] * factor, exponents[channel]);
  }
  return result;
}

template std::array<Ball<double>, 3> EvaluateInBalls(const WeightedContour&,
                                                     const EvaluationQuery&,
                                                     const std::vector<bool>&,
                                                     BallGeometry<double>&);
template std::array<Ball<DoubleDouble>, 3> EvaluateInBalls(
    const WeightedContour&, const EvaluationQuery&, const std::vector<bool>&,
    BallGeometry<DoubleDouble>&);

}  // namespace truelux
