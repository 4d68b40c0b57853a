// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/stages/multiprecision_stage.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "exact/arb_ball.h"
#include "exact/recipe_evaluator.h"

namespace truelux {
namespace {

/// The vectors of a contour, exactly.
struct ExactVectors {  // NOLINT(bugprone-exception-escape): Mpzf's moves
  Vec3<Exact> receiver_normal;
  IdVector<PlaneId, Vec3<Exact>> planes;
  IdVector<DirectionId, Vec3<Exact>> directions;
};

ExactVectors EvaluateExactly(const WeightedContour& contour) {
  const RecipeEvaluator<Exact> recipes(contour.view);
  const Contour& c = contour.contour;
  ExactVectors result{recipes.ReceiverNormal(), {}, {}};
  result.planes.reserve(c.planes.size());
  for (const PlaneRecipe& plane : c.planes) {
    result.planes.push_back(recipes.Plane(plane, c.explicit_vectors.All()));
  }
  result.directions.reserve(c.directions.size());
  for (const DirectionRecipe& d : c.directions) {
    if (d.kind() == DirectionRecipe::Kind::kCrossing) {
      const Vec3<Exact> crossing = Cross(result.planes[d.first_plane()],
                                         result.planes[d.second_plane()]);
      result.directions.push_back(d.negated() ? -crossing : crossing);
    } else {
      result.directions.push_back(
          recipes.Direction(d, c.planes, c.explicit_vectors.All()));
    }
  }
  return result;
}

/// What one arc adds: by its angle, or by its two ends.
void AppendTerms(const ExactVectors& exact, const Arc& arc, bool over_ends,
                 bool on_horizon, std::vector<ExactTerm>& terms) {
  // The sum has the contour's planes in their order.
  const ExactPlaneId plane(arc.plane.value());
  const Vec3<Exact>& n = exact.receiver_normal;
  const Vec3<Exact>& normal = exact.planes[arc.plane];
  const Vec3<Exact>& d1 = exact.directions[arc.from];
  const Vec3<Exact>& d2 = exact.directions[arc.to];
  if (over_ends && !on_horizon) {
    const Vec3<Exact> ascent = Cross(n, normal);
    terms.push_back(EndTerm(plane, n, ascent, d1, false));
    terms.push_back(EndTerm(plane, n, ascent, d2, true));
    return;
  }
  const Exact t = Determinant(d1, d2, normal);
  const Exact across = arc.positive ? t : -t;
  if (over_ends) {
    const bool below =
        (SignOf(Dot(n, normal)) == Sign::kNegative) == arc.positive;
    terms.push_back(HorizonEndTerm(plane, d1, d2, across, below));
    terms.push_back(HorizonEndTerm(plane, d2, d1, across, below));
  } else {
    terms.push_back({plane, across, Dot(d1, d2), false, true, !arc.positive});
  }
}

/// |N| and n.N / (|n| |N|) at one precision.
struct BallPlane {
  ArbBall length;
  ArbBall cosine;
};

using BallPlanes = IdVector<ExactPlaneId, BallPlane>;

BallPlane PlaneOf(const ExactPlane& plane, slong precision) {
  BallPlane balls{ArbBall(precision, plane.normal_square),
                  ArbBall(precision, plane.both_squares)};
  arb_sqrt(balls.length.get(), balls.length.get(), precision);
  arb_sqrt(balls.cosine.get(), balls.cosine.get(), precision);
  const ArbBall part(precision, plane.cosine_part);
  arb_div(balls.cosine.get(), part.get(), balls.cosine.get(), precision);
  return balls;
}

ArbBall SumOfTerms(const WeightedTerms& group, const BallPlanes& planes,
                   slong precision) {
  ArbBall sum;
  for (const ExactTerm& term : group.terms) {
    const BallPlane& plane = planes[term.plane];
    ArbBall y(precision, term.y);
    ArbBall x(precision, term.x);
    const arb_ptr scaled = term.length_on_y ? y.get() : x.get();
    arb_mul(scaled, scaled, plane.length.get(), precision);
    arb_atan2(y.get(), y.get(), x.get(), precision);
    if (term.has_cosine) {
      arb_mul(y.get(), y.get(), plane.cosine.get(), precision);
    }
    if (term.negative) {
      arb_sub(sum.get(), sum.get(), y.get(), precision);
    } else {
      arb_add(sum.get(), sum.get(), y.get(), precision);
    }
  }
  return sum;
}

}  // namespace

ExactSum ExactSumOf(const WeightedContour& contour,
                    const EvaluationQuery& evaluation,
                    const HorizonPlanes& on_horizon) {
  const ExactVectors exact = EvaluateExactly(contour);
  const Vec3<Exact>& n = exact.receiver_normal;
  const Exact n_square = Dot(n, n);
  const bool over_ends = SumsOverVertices(evaluation.formula);
  ExactSum sum;
  sum.planes.reserve(exact.planes.size());
  for (const Vec3<Exact>& normal : exact.planes) {
    sum.planes.push_back(ExactPlaneOf(n, n_square, normal));
  }
  for (const SourceId source : contour.contour.sources.ids()) {
    if (!contour.IsLit(source)) continue;
    const Rgb& weight = contour.WeightOf(source);
    WeightedTerms group{{Exact(weight[0]), Exact(weight[1]), Exact(weight[2])},
                        {}};
    for (const Arc& arc : contour.ArcsOf(source)) {
      const bool flat = over_ends && on_horizon[arc.plane];
      AppendTerms(exact, arc, over_ends, flat, group.terms);
    }
    sum.groups.push_back(std::move(group));
  }
  return sum;
}

MultiprecisionStage::MultiprecisionStage(ExactSum sum, Emission emission)
    : sum_(std::move(sum)), emission_(emission) {
  assert(std::ranges::any_of(sum_.groups, [](const WeightedTerms& group) {
    return !group.terms.empty();
  }));
}

MultiprecisionStage::MultiprecisionStage(const WeightedContour& contour,
                                         const EvaluationQuery& evaluation,
                                         const HorizonPlanes& on_horizon)
    : MultiprecisionStage(ExactSumOf(contour, evaluation, on_horizon),
                          evaluation.emission) {}

std::array<Enclosure, 3> MultiprecisionStage::Evaluate(
    mpfr_prec_t precision) const {
  assert(precision >= 64);
  BallPlanes planes;
  planes.reserve(sum_.planes.size());
  for (const ExactPlane& plane : sum_.planes) {
    planes.push_back(PlaneOf(plane, precision));
  }
  std::vector<ArbBall> sums;
  sums.reserve(sum_.groups.size());
  for (const WeightedTerms& group : sum_.groups) {
    sums.push_back(SumOfTerms(group, planes, precision));
  }
  const auto channel_enclosure = [&](std::size_t channel) {
    ArbBall value;
    for (std::size_t i = 0; i < sums.size(); ++i) {
      if (sum_.groups[i].weight[channel].is_zero()) continue;
      const ArbBall weight(precision, sum_.groups[i].weight[channel]);
      arb_addmul(value.get(), sums[i].get(), weight.get(), precision);
    }
    // E = (M / 2 pi) sum, and M = pi L.
    if (emission_ == Emission::kExitance) {
      ArbBall pi;
      arb_const_pi(pi.get(), precision);
      arb_div(value.get(), value.get(), pi.get(), precision);
    }
    arb_mul_2exp_si(value.get(), value.get(), -1);
    Enclosure enclosure{Multiprecision(precision), Multiprecision(precision)};
    arb_get_interval_mpfr(enclosure.lower.get(), enclosure.upper.get(),
                          value.get());
    return enclosure;
  };
  return {channel_enclosure(0), channel_enclosure(1), channel_enclosure(2)};
}

}  // namespace truelux
