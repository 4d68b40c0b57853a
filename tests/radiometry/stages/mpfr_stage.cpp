// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/stages/mpfr_stage.h"

#include <utility>

#include "exact/exact_conversion.h"

namespace truelux::testing {

MpfrStage::MpfrStage(ExactSum sum, Emission emission)
    : sum_(std::move(sum)), emission_(emission) {
  for (const WeightedTerms& group : sum_.groups) {
    term_count_ += group.terms.size();
  }
}

MpfrStage::Sum MpfrStage::SumOfTerms(const WeightedTerms& group,
                                     const RoundedPlanes& planes,
                                     mpfr_prec_t precision) {
  Sum sum{Multiprecision(precision), Multiprecision(precision)};
  for (const ExactTerm& term : group.terms) {
    const RoundedPlane& plane = planes[term.plane];
    Multiprecision y = MultiprecisionOf(precision, term.y);
    Multiprecision x = MultiprecisionOf(precision, term.x);
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

void MpfrStage::ToIrradiance(mpfr_prec_t precision, Multiprecision& x,
                             mpfr_rnd_t rounding) const {
  // E = (M / 2 pi) sum, and M = pi L.
  if (emission_ == Emission::kExitance) {
    Multiprecision pi(precision);
    mpfr_const_pi(pi.get(), rounding == MPFR_RNDU ? MPFR_RNDD : rounding);
    mpfr_div(x.get(), x.get(), pi.get(), rounding);
  }
  mpfr_div_2ui(x.get(), x.get(), 1, rounding);
}

std::array<Enclosure, 3> MpfrStage::Evaluate(mpfr_prec_t precision) const {
  RoundedPlanes planes;
  planes.reserve(sum_.planes.size());
  for (const ExactPlane& plane : sum_.planes) {
    RoundedPlane rounded{MultiprecisionOf(precision, plane.normal_square),
                         MultiprecisionOf(precision, plane.both_squares)};
    mpfr_sqrt(rounded.length.get(), rounded.length.get(), MPFR_RNDN);
    mpfr_sqrt(rounded.cosine.get(), rounded.cosine.get(), MPFR_RNDN);
    const Multiprecision part = MultiprecisionOf(precision, plane.cosine_part);
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
      Multiprecision weight =
          MultiprecisionOf(precision, sum_.groups[i].weight[channel]);
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

}  // namespace truelux::testing
