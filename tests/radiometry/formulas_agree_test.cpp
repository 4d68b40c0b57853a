// SPDX-License-Identifier: GPL-3.0-or-later
// All closed forms are one number: at 1024 bits they agree to 60 digits, on
// every source of every hard case; a usual run takes the first sources of each.

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/io.h"
#include "truelux/irradiance.h"

#include "radiometry/formula_evaluation.h"
#include "support/case_files.h"
#include "support/sweep.h"
#include "visibility/edges/contour_engine.h"

namespace truelux::testing {
namespace {

/// All formulas but auto, which chooses one of them, and those that are cut off.
std::vector<Formula> ClosedForms() {
  std::vector<Formula> forms;
  for (const Formula formula : AllFormulas()) {
    if (formula == Formula::kAuto || formula == Formula::kSeries ||
        formula == Formula::kCubature) {
      continue;
    }
    forms.push_back(formula);
  }
  return forms;
}

/// |x - y| / |y| as a power of ten; -1000 for 0.
double DigitsApart(const Multiprecision& x, const Multiprecision& y) {
  Multiprecision ratio = (x - y) / y;
  if (IsZero(ratio)) return -1000;
  const mpfr_exp_t exponent = mpfr_get_exp(ratio.get());
  return static_cast<double>(exponent) * std::log10(2.0);
}

Receiver ReceiverOf(const std::vector<double>& row) {
  return {{row[0], row[1], row[2]}, {row[3], row[4], row[5]}, 0};
}

/// Calls look(visible contour, with every source's weight 1) for each receiver
/// of a case.
template <class Look>
void LookAtEach(const std::string& name, const Look& look) {
  const auto folder = CaseFolder(name);
  const Result<Scene> scene = ReadScene(folder / "scene.obj");
  ASSERT_TRUE(scene.ok());
  const ContourEngine engine(*scene.value);
  ContourBuilder builder(engine);
  Contour contour;
  for (const auto& row : ReadNumbers(folder / "expected.csv")) {
    const ContourQuery query{*scene.value, ReceiverOf(row)};
    builder.Build(query, contour);
    const std::vector<Rgb> weights(contour.sources.size(), {1, 1, 1});
    const WeightedContour weighted{ViewOf(query), contour, weights};
    look(weighted);
  }
}

class FormulasAgree : public ::testing::TestWithParam<std::string> {};

TEST_P(FormulasAgree, ToSixtyDigits) {
  int sources = 0;
  int unbounded = 0;
  const int most = SweepSize(8, std::numeric_limits<int>::max());
  const std::vector<Formula> forms = ClosedForms();
  LookAtEach(GetParam(), [&](const WeightedContour& weighted) {
    if (sources >= most) return;
    FormulaEvaluation<Multiprecision> formulas(weighted, 0x1p20, 1024);
    for (const Formula formula : forms)
      formulas.Prepare(formula);
    for (std::size_t i = 0; i < formulas.lit().size(); ++i) {
      if (++sources > most) return;
      const Multiprecision truth =
          formulas.Evaluate(Formula::kLambertEdge, i).value;
      ASSERT_FALSE(IsNegative(truth) || IsZero(truth));
      for (const Formula formula : forms) {
        const auto sum = formulas.Evaluate(formula, i);
        ASSERT_TRUE(sum.applicable);
        if (sum.truncation > 0) {
          // The image plane cannot treat the horizon, and says so.
          ASSERT_TRUE(NeedsBoundedRegion(formula));
          ++unbounded;
          const double missing = Leading(truth - sum.value);
          EXPECT_GE(missing, 0);
          EXPECT_LE(missing, sum.truncation);
          continue;
        }
        if (DigitsApart(sum.value, truth) < -60) continue;
        // A vertex 1e-300 above the horizon is 1e300 away on the image plane,
        // and a y - b x loses 300 of the 308 digits.
        EXPECT_EQ(GetParam(), "h06_elevation_decimal");
        FormulaEvaluation<Multiprecision> more(weighted, 0x1p20, 2048);
        more.Prepare(formula);
        EXPECT_LT(DigitsApart(more.Evaluate(formula, i).value, truth), -60)
            << Name(formula) << " source " << i;
      }
    }
  });
  RecordProperty("sources", sources);
  RecordProperty("cut", unbounded);
}

/// What is not closed is as close as it says. 300 bits, as the cubature takes
/// many points, and heights of 1e-17 lose as much.
TEST_P(FormulasAgree, UpToTruncation) {
  int applicable = 0;
  const int most = 2 * SweepSize(1, 20);
  LookAtEach(GetParam(), [&](const WeightedContour& weighted) {
    if (applicable > most) return;
    FormulaEvaluation<Multiprecision> formulas(weighted, 0x1p20, 300);
    for (const Formula formula : {Formula::kSeries, Formula::kCubature})
      formulas.Prepare(formula);
    // Of a sliver 1e-49 wide, Lambert's sum loses 49 digits and those do not.
    FormulaEvaluation<Multiprecision> precise(weighted, 0x1p20, 1024);
    precise.Prepare(Formula::kLambertEdge);
    for (std::size_t i = 0; i < formulas.lit().size(); ++i) {
      const Multiprecision truth =
          precise.Evaluate(Formula::kLambertEdge, i).value;
      for (const Formula formula : {Formula::kSeries, Formula::kCubature}) {
        const auto sum = formulas.Evaluate(formula, i);
        if (!sum.applicable) continue;
        EXPECT_LE(std::fabs(Leading(truth - sum.value)),
                  sum.truncation + 1e-45 * Leading(truth))
            << Name(formula);
        ++applicable;
      }
      if (applicable > most) return;
    }
  });
  RecordProperty("applicable", applicable);
}

INSTANTIATE_TEST_SUITE_P(Cases, FormulasAgree,
                         ::testing::ValuesIn(CaseNames()));

}  // namespace
}  // namespace truelux::testing
