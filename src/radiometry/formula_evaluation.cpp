// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/formula_evaluation.h"

#include <cassert>
#include <stdexcept>

#include "radiometry/formulas/cubature.h"
#include "radiometry/formulas/difference.h"
#include "radiometry/formulas/directions.h"
#include "radiometry/formulas/homogeneous.h"
#include "radiometry/formulas/image_plane.h"
#include "radiometry/formulas/lambert_acos.h"
#include "radiometry/formulas/lambert_atan2.h"
#include "radiometry/formulas/lambert_edge.h"
#include "radiometry/formulas/projective.h"
#include "radiometry/formulas/series.h"
#include "radiometry/formulas/sphere.h"
#include "radiometry/formulas/unified.h"
#include "radiometry/formulas/vertex_lambert.h"

namespace truelux {
namespace {

template <class T>
T ClosedForm(Formula formula, const Boundary<T>& region) {
  switch (formula) {
    case Formula::kLambertAcos:
      return LambertAcos(region);
    case Formula::kLambertAtan2:
      return LambertAtan2(region);
    case Formula::kLambertEdge:
      return LambertEdge(region);
    case Formula::kVertexLambert:
      return VertexLambert(region);
    case Formula::kImagePlane:
      return ImagePlane(region);
    case Formula::kDirections:
      return Directions(region);
    case Formula::kSphere:
      return SphereVertices(region);
    case Formula::kProjective:
      return Projective(region);
    case Formula::kHomogeneous:
      return Homogeneous(region);
    case Formula::kUnified:
      return Unified(region);
    case Formula::kDifference:
      return Difference(region);
    case Formula::kAuto:
    case Formula::kSeries:
    case Formula::kCubature:
      break;
  }
  throw std::logic_error("this formula is no closed form");
}

/// The rules of the types whose precision is fixed are made once.
template <class T>
std::shared_ptr<const GaussRules<T>> RulesFor(mpfr_prec_t precision) {
  const auto make = [precision] {
    return std::make_shared<const GaussRules<T>>(MakeGaussRules<T>(precision));
  };
  if constexpr (std::is_same_v<T, Multiprecision>) {
    return make();
  } else {
    static const std::shared_ptr<const GaussRules<T>> rules = make();
    return rules;
  }
}

}  // namespace

template <class T>
PartialSum<T> EvaluateFormula(Formula formula, const Boundary<T>& region,
                              const GaussRules<T>& rules) {
  if (region.arcs.empty()) return {Make<T>(0)};
  if (formula == Formula::kSeries) return Series(region);
  if (formula == Formula::kCubature) return Cubature(region, rules);
  return {ClosedForm(formula, region)};
}

template <class T>
FormulaEvaluation<T>::FormulaEvaluation(const WeightedContour& contour,
                                        double half_side, mpfr_prec_t precision)
    : contour_(contour), half_side_(half_side), precision_(precision) {
  for (const SourceId source : contour.contour.sources.ids()) {
    if (contour.IsLit(source)) lit_.push_back(source);
  }
}

template <class T>
void FormulaEvaluation<T>::Prepare(Formula formula) {
  if (!RegionsFor(formula).empty()) return;
  if (NeedsBoundedRegion(formula)) {
    PrepareBounded();
    return;
  }
  if (!geometry_) {
    geometry_ = std::make_unique<const FrameGeometry<W>>(contour_, precision_);
  }
  if (NeedsFan(formula)) {
    with_fan_ = RegionsOf(*geometry_, true);
    rules_ = RulesFor<T>(precision_);
  } else {
    plain_ = RegionsOf(*geometry_, false);
  }
}

template <class T>
void FormulaEvaluation<T>::PrepareBounded() {
  bounded_contour_ =
      std::make_unique<const BoundedContour>(CutToSquare(contour_, half_side_));
  const WeightedContour bounded = {contour_.view, bounded_contour_->contour,
                                   contour_.weights};
  bounded_ = RegionsOf(FrameGeometry<W>(bounded, precision_), false);
}

template <class T>
auto FormulaEvaluation<T>::RegionsOf(const FrameGeometry<W>& geometry,
                                     bool with_fan) const -> Regions {
  Regions regions;
  for (const SourceId source : lit_) {
    regions.push_back(BoundaryOf<T>(geometry, source, with_fan));
  }
  return regions;
}

template <class T>
auto FormulaEvaluation<T>::RegionsFor(Formula formula) const -> const Regions& {
  if (NeedsBoundedRegion(formula)) return bounded_;
  // Regions with a fan serve all formulas.
  return NeedsFan(formula) || !with_fan_.empty() ? with_fan_ : plain_;
}

template <class T>
PartialSum<T> FormulaEvaluation<T>::Evaluate(Formula formula,
                                             std::size_t i) const {
  assert(i < RegionsFor(formula).size());  // Prepare was called
  static const GaussRules<T> none;
  PartialSum<T> sum =
      EvaluateFormula(formula, RegionsFor(formula)[i], rules_ ? *rules_ : none);
  if (NeedsBoundedRegion(formula) && bounded_contour_->is_cut[lit_[i]]) {
    sum.truncation += FormFactorBeyond(half_side_);
  }
  return sum;
}

template PartialSum<float> EvaluateFormula(Formula, const Boundary<float>&,
                                           const GaussRules<float>&);
template PartialSum<double> EvaluateFormula(Formula, const Boundary<double>&,
                                            const GaussRules<double>&);
template PartialSum<DoubleDouble> EvaluateFormula(
    Formula, const Boundary<DoubleDouble>&, const GaussRules<DoubleDouble>&);
template PartialSum<Ball<double>> EvaluateFormula(
    Formula, const Boundary<Ball<double>>&, const GaussRules<Ball<double>>&);
template PartialSum<Multiprecision> EvaluateFormula(
    Formula, const Boundary<Multiprecision>&,
    const GaussRules<Multiprecision>&);
template class FormulaEvaluation<float>;
template class FormulaEvaluation<double>;
template class FormulaEvaluation<DoubleDouble>;
template class FormulaEvaluation<Ball<double>>;
template class FormulaEvaluation<Multiprecision>;

}  // namespace truelux
