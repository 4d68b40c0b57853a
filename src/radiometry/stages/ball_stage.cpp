// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/stages/ball_stage.h"

#include <type_traits>

#include "radiometry/stages/ball_terms.h"
#include "radiometry/stages/channel_sums.h"

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
                   Formula formula, const HorizonPlanes& on_horizon) {
  if (!SumsOverVertices(formula)) return LambertTerms(geometry, arcs);
  Ball<T> sum(0.0);
  for (const Arc& arc : arcs) {
    const bool flat = on_horizon[arc.plane];
    sum = sum + HomogeneousTerm(geometry, arc, flat);
  }
  return sum;
}

}  // namespace

template <class T>
std::array<Ball<T>, 3> EvaluateInBalls(const WeightedContour& contour,
                                       const EvaluationQuery& evaluation,
                                       const HorizonPlanes& on_horizon,
                                       BallGeometry<T>& geometry) {
  geometry.Evaluate(contour);
  ChannelSums<T> sums(contour);
  for (const SourceId source : contour.contour.sources.ids()) {
    if (!contour.IsLit(source)) continue;
    sums.Add(source, SumOfTerms(geometry, contour.ArcsOf(source),
                                evaluation.formula, on_horizon));
  }
  // E = M F = (M / 2 pi) sum / |n|, and M = pi L.
  const BallVector<T>& n = geometry.receiver_normal();
  const Ball<T> factor =
      (evaluation.emission == Emission::kRadiance ? Ball<T>(0.5)
                                                  : InverseTwoPi<T>()) /
      Sqrt(Dot(n, n));
  return sums.Finish(factor);
}

template std::array<Ball<double>, 3> EvaluateInBalls(const WeightedContour&,
                                                     const EvaluationQuery&,
                                                     const HorizonPlanes&,
                                                     BallGeometry<double>&);
template std::array<Ball<DoubleDouble>, 3> EvaluateInBalls(
    const WeightedContour&, const EvaluationQuery&, const HorizonPlanes&,
    BallGeometry<DoubleDouble>&);

}  // namespace truelux
