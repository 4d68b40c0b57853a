#include "radiometry/stages/multiprecision_stage.h"

#include <cassert>
#include <utility>

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

ExactSum SumOf(const WeightedContour& contour,
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

}  // namespace

MultiprecisionStage::MultiprecisionStage(ExactSum sum, Emission emission)
    : sum_(std::move(sum)), emission_(emission) {
  for (const WeightedTerms& group : sum_.groups) {
    term_count_ += group.terms.size();
  }
  assert(term_count_ > 0);
}

MultiprecisionStage::MultiprecisionStage(const WeightedContour& contour,
                                         const EvaluationQuery& evaluation,
                                         const HorizonPlanes& on_horizon)
    : MultiprecisionStage(SumOf(contour, evaluation, on_horizon),
                          evaluation.emission) {}

MultiprecisionStage::Sum MultiprecisionStage::SumOfTerms(
    const WeightedTerms& group, const RoundedPlanes& planes,
    mpfr_prec_t precision) {
  Sum sum{Multiprecision(precision), Multiprecision(precision)};
  for (const ExactTerm& term : group.terms) {
    const RoundedPlane& plane = planes[term.plane];
    Multiprecision y(precision, term.y);
    Multiprecision x(precision, term.x);
    const mpfr_ptr scaled = term.length_on_y ? y.get() : x.get();
    mpfr_mul(scaled, scaled, plane.length.get(), MPFR_RNDN);
    mpfr_atan2(y.get(), y.get(), x.get(), MPFR_RNDN);
    if (term.has_cosine) {
      mpfr_mul(y.get(), y.get(), plane.cosine.get(), MPFR_RNDN);
    }
    if (term.negative) mpfr_neg(y.get(), y.get(), MPFR_RNDN);
    mpfr_add(sum.value.get(), sum.value.get(), y.get(), MPFR_RNDN);
    mpfr_abs(y.get(), y.get(), MPFR_RNDN);
    mpfr_add(sum.magnitude.get(), sum.magnitude.get(), y.get(), MPFR_RNDU);
  }
  return sum;
}

void MultiprecisionStage::ToIrradiance(mpfr_prec_t precision, Multiprecision& x,
                                       mpfr_rnd_t rounding) const {
  // E = (M / 2 pi) sum, and M = pi L.
  if (emission_ == Emission::kExitance) {
    Multiprecision pi(precision);
    mpfr_const_pi(pi.get(), rounding == MPFR_RNDU ? MPFR_RNDD : rounding);
    mpfr_div(x.get(), x.get(), pi.get(), rounding);
  }
  mpfr_div_2ui(x.get(), x.get(), 1, rounding);
}

std::array<Enclosure, 3> MultiprecisionStage::Evaluate(
    mpfr_prec_t precision) const {
  assert(precision >= 64);
  RoundedPlanes planes;
  planes.reserve(sum_.planes.size());
  for (const ExactPlane& plane : sum_.planes) {
    RoundedPlane rounded{Multiprecision(precision, plane.normal_square),
                         Multiprecision(precision, plane.both_squares)};
    mpfr_sqrt(rounded.length.get(), rounded.length.get(), MPFR_RNDN);
    mpfr_sqrt(rounded.cosine.get(), rounded.cosine.get(), MPFR_RNDN);
    const Multiprecision part(precision, plane.cosine_part);
    mpfr_div(rounded.cosine.get(), part.get(), rounded.cosine.get(), MPFR_RNDN);
    planes.push_back(std::move(rounded));
  }
  std::vector<Sum> sums;
  sums.reserve(sum_.groups.size());
  for (const WeightedTerms& group : sum_.groups) {
    sums.push_back(SumOfTerms(group, planes, precision));
  }
  const auto count = static_cast<double>(term_count_ + sum_.groups.size() + 16);
  const auto channel_enclosure = [&](std::size_t channel) {
    Multiprecision value(precision);
    Multiprecision error(precision);
    Multiprecision product(precision);
    for (std::size_t i = 0; i < sums.size(); ++i) {
      if (sum_.groups[i].weight[channel].is_zero()) continue;
      Multiprecision weight(precision, sum_.groups[i].weight[channel]);
      mpfr_mul(product.get(), sums[i].value.get(), weight.get(), MPFR_RNDN);
      mpfr_add(value.get(), value.get(), product.get(), MPFR_RNDN);
      mpfr_abs(weight.get(), weight.get(), MPFR_RNDN);
      mpfr_mul(product.get(), sums[i].magnitude.get(), weight.get(), MPFR_RNDU);
      mpfr_add(error.get(), error.get(), product.get(), MPFR_RNDU);
    }
    ToIrradiance(precision, value, MPFR_RNDN);
    ToIrradiance(precision, error, MPFR_RNDU);
    mpfr_mul_d(error.get(), error.get(), count, MPFR_RNDU);
    mpfr_div_2ui(error.get(), error.get(),
                 static_cast<unsigned long>(precision), MPFR_RNDU);
    Enclosure enclosure{value, value};
    mpfr_sub(enclosure.lower.get(), value.get(), error.get(), MPFR_RNDD);
    mpfr_add(enclosure.upper.get(), value.get(), error.get(), MPFR_RNDU);
    return enclosure;
  };
  return {channel_enclosure(0), channel_enclosure(1), channel_enclosure(2)};
}

}  // namespace truelux
