// SPDX-License-Identifier: GPL-3.0-or-later
// Oracle::EvaluateFormula: any formula in any arithmetic, for users of the
// library.

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "truelux/truelux.h"

#include "support/scenes.h"

namespace truelux::testing {
namespace {

const Receiver kReceiver = {{0.1, 0.2, 0}, {0.1, -0.2, 1}, 0};

/// A lamp with two blockers before it, which cut its edges and each other.
Scene PartlyHidden() {
  return MakeScene(
      {{Ceiling(-1, 1, -1, 1, 2), {5, 10, 20}},
       {{{-0.5, -0.7, 1}, {0.3, 0.4, 1.1}, {0.6, -0.5, 0.9}}, kBlack},
       {{{-0.6, 0.1, 1.4}, {0.7, 0.2, 1.3}, {0, 0.8, 1.2}}, kBlack}});
}

/// Error that an arithmetic may leave on this scene, of angular size about 1.
double Tolerance(Arithmetic arithmetic) {
  switch (arithmetic) {
    case Arithmetic::kFloat:
      return 1e-4;
    case Arithmetic::kDouble:
      return 1e-12;
    case Arithmetic::kDoubleDouble:
    case Arithmetic::kMultiprecision:
      break;
  }
  return 1.2e-16;
}

TEST(EvaluateFormula, EveryOneInEveryArithmetic) {
  const Oracle oracle(PartlyHidden());
  const Rgb truth = oracle.Evaluate(kReceiver).value;
  std::map<Arithmetic, int> inexact;
  for (const Formula formula : AllFormulas()) {
    if (formula == Formula::kAuto || formula == Formula::kSeries) continue;
    for (const Arithmetic arithmetic :
         {Arithmetic::kFloat, Arithmetic::kDouble, Arithmetic::kDoubleDouble,
          Arithmetic::kMultiprecision}) {
      const auto value = oracle.EvaluateFormula(kReceiver, formula, arithmetic);
      ASSERT_TRUE(value.has_value()) << Name(formula);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        EXPECT_LE(std::fabs((*value)[channel] - truth[channel]),
                  Tolerance(arithmetic) * truth[channel])
            << Name(formula) << " " << Name(arithmetic);
      }
      if (*value != truth) ++inexact[arithmetic];
    }
  }
  // The arithmetics are what they are called.
  EXPECT_EQ(inexact[Arithmetic::kFloat], 12);
  EXPECT_GT(inexact[Arithmetic::kDouble], 3);
}

TEST(EvaluateFormula, ThePrecisionMatters) {
  const Oracle oracle(PartlyHidden());
  const double truth = oracle.Evaluate(kReceiver).value[0];
  const auto at = [&](int precision) {
    return oracle
        .EvaluateFormula(kReceiver, Formula::kLambertAcos,
                         Arithmetic::kMultiprecision, precision)
        .value()[0];
  };
  EXPECT_NE(at(53), truth);
  EXPECT_EQ(at(300), truth);
}

TEST(EvaluateFormula, RadianceIsTimesPi) {
  const Oracle exitance(PartlyHidden());
  const Oracle radiance(PartlyHidden(), {.emission = Emission::kRadiance});
  const auto value = [](const Oracle& oracle) {
    return oracle
        .EvaluateFormula(kReceiver, Formula::kUnified, Arithmetic::kDouble)
        .value()[1];
  };
  EXPECT_NEAR(value(radiance) / value(exitance), 3.141592653589793, 1e-15);
}

TEST(EvaluateFormula, SaysWhereAFormulaDoesNotApply) {
  const Oracle wide(PartlyHidden());
  EXPECT_EQ(
      wide.EvaluateFormula(kReceiver, Formula::kSeries, Arithmetic::kDouble),
      std::nullopt);
  const Oracle small(
      MakeScene({{Ceiling(-0.01, 0.01, -0.01, 0.01, 2), {1, 1, 1}}}));
  const auto value =
      small.EvaluateFormula(kReceiver, Formula::kSeries, Arithmetic::kDouble);
  ASSERT_TRUE(value.has_value());
  EXPECT_NEAR((*value)[0] / small.Evaluate(kReceiver).value[0], 1, 1e-12);
}

TEST(EvaluateFormula, RefusesWhatMakesNoSense) {
  const Oracle oracle(PartlyHidden());
  const auto refuses = [&oracle](const Receiver& receiver, Formula formula,
                                 Arithmetic arithmetic, int precision) {
    try {
      return !oracle.EvaluateFormula(receiver, formula, arithmetic, precision);
    } catch (const std::invalid_argument&) {
      return true;
    }
  };
  const Formula good = Formula::kUnified;
  const Arithmetic mpfr = Arithmetic::kMultiprecision;
  EXPECT_FALSE(refuses(kReceiver, good, mpfr, 53));
  EXPECT_TRUE(refuses(kReceiver, Formula::kAuto, mpfr, 53));
  EXPECT_TRUE(refuses(kReceiver, good, mpfr, 52));
  EXPECT_TRUE(refuses({{0, 0, 0}, {0, 0, 0}, 0}, good, mpfr, 53));
}

TEST(FormulaNames, GoBothWays) {
  EXPECT_EQ(AllFormulas().size(), 14U);
  for (const Formula formula : AllFormulas())
    EXPECT_EQ(FormulaByName(Name(formula)), formula);
  EXPECT_EQ(FormulaByName("lambert"), std::nullopt);
  EXPECT_EQ(FormulaByName(""), std::nullopt);
}

}  // namespace
}  // namespace truelux::testing
