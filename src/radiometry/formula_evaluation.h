// SPDX-License-Identifier: GPL-3.0-or-later
// Any closed formula on any visible contour, at any number type.

#ifndef TRUELUX_RADIOMETRY_FORMULA_EVALUATION_H_
#define TRUELUX_RADIOMETRY_FORMULA_EVALUATION_H_

#include <memory>
#include <vector>

#include "truelux/formulas.h"

#include "radiometry/boundary.h"
#include "radiometry/formulas/gauss_rule.h"
#include "radiometry/formulas/partial_sum.h"
#include "radiometry/square_clip.h"

namespace truelux {

/// Whether a formula needs a region that is bounded on the image plane.
constexpr bool NeedsBoundedRegion(Formula formula) {
  return formula == Formula::kImagePlane || formula == Formula::kDirections;
}

/// Whether a formula needs Boundary::fan.
constexpr bool NeedsFan(Formula formula) {
  return formula == Formula::kSeries || formula == Formula::kCubature;
}

/// The form factor [1] of one region by any formula but kAuto. rules: used by
/// kCubature only. Of a Ball, the bound does not hold the truncation.
template <class T>
PartialSum<T> EvaluateFormula(Formula formula, const Boundary<T>& region,
                              const GaussRules<T>& rules);

/// The lit sources of a contour, at a number type, and the formulas on them.
///
/// The contour and the weights must outlive this object. What a formula needs
/// is made when it is first asked for and shared with others of its kind.
template <class T>
class FormulaEvaluation {
 public:
  /// half_side: as OracleOptions::half_side. precision [bits]: of
  /// Multiprecision; not looked at otherwise.
  explicit FormulaEvaluation(const WeightedContour& contour,
                             double half_side = 0x1p20,
                             mpfr_prec_t precision = 128);

  /// The lit sources of the contour.
  [[nodiscard]] const std::vector<SourceId>& lit() const { return lit_; }

  /// Makes what `formula` needs, so that Evaluate costs its sum only.
  void Prepare(Formula formula);

  /// The form factor of the i-th lit source by any formula but kAuto. The
  /// truncation holds what was cut off. Requires Prepare(formula).
  [[nodiscard]] PartialSum<T> Evaluate(Formula formula, std::size_t i) const;

 private:
  using W = typename WorkingType<T>::Type;

  /// The boundaries of all lit sources of one contour.
  using Regions = std::vector<Boundary<T>>;

  [[nodiscard]] Regions RegionsOf(const FrameGeometry<W>& geometry,
                                  bool with_fan) const;
  void PrepareBounded();
  [[nodiscard]] const Regions& RegionsFor(Formula formula) const;

  WeightedContour contour_;
  double half_side_;
  mpfr_prec_t precision_;
  std::vector<SourceId> lit_;
  std::unique_ptr<const FrameGeometry<W>> geometry_;
  Regions plain_;
  Regions with_fan_;
  std::unique_ptr<const BoundedContour> bounded_contour_;
  Regions bounded_;
  std::shared_ptr<const GaussRules<T>> rules_;
};

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_FORMULA_EVALUATION_H_
