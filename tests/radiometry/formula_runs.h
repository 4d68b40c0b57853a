// SPDX-License-Identifier: GPL-3.0-or-later
// Any formula at any number type on contours made by hand.

#ifndef TRUELUX_TESTS_RADIOMETRY_FORMULA_RUNS_H_
#define TRUELUX_TESTS_RADIOMETRY_FORMULA_RUNS_H_

#include <string>
#include <type_traits>

#include <gtest/gtest.h>

#include "radiometry/formula_evaluation.h"
#include "radiometry/hand_contour.h"
#include "radiometry/reference.h"

namespace truelux::testing {

/// Precision of Multiprecision in these tests [bits].
inline constexpr mpfr_prec_t kRunBits = 300;

inline Real ToReal(float x) {
  return {x};
}

inline Real ToReal(double x) {
  return {x};
}

inline Real ToReal(const DoubleDouble& x) {
  return Real(x.high) + Real(x.low);
}

inline Real ToReal(const Ball<double>& x) {
  return {x.value};
}

inline Real ToReal(const Multiprecision& x) {
  Real result;
  mpfr_set(result.get(), x.get(), MPFR_RNDN);
  return result;
}

/// What the plain types are off by at most where nothing cancels [relative].
template <class T>
double PlainError() {
  if (std::is_same_v<T, float>) return 1e-4;
  if (std::is_same_v<T, double>) return 1e-12;
  if (std::is_same_v<T, DoubleDouble>) return 1e-26;
  return 1e-80;
}

/// One formula on the first source of a contour.
template <class T>
PartialSum<T> RunFormula(Formula formula, const WeightedContour& contour,
                         double half_side = 0x1p20) {
  FormulaEvaluation<T> formulas(contour, half_side, kRunBits);
  formulas.Prepare(formula);
  return formulas.Evaluate(formula, 0);
}

template <class T>
PartialSum<T> RunFormula(Formula formula, const HandContour& contour,
                         double half_side = 0x1p20) {
  return RunFormula<T>(formula, contour.Weighted(), half_side);
}

inline HandContour PolygonContour(const std::vector<Point3>& ring,
                                  const Point3& position, const Vector3& normal,
                                  Ends ends = Ends::kNatural) {
  HandContour contour(position, normal);
  contour.AddConvexPolygon(ring, {1, 1, 1}, ends);
  return contour;
}

/// The name of a test of one formula.
inline std::string TestNameOf(const ::testing::TestParamInfo<Formula>& test) {
  std::string name(Name(test.param));
  std::erase(name, '-');
  return name;
}

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_RADIOMETRY_FORMULA_RUNS_H_
