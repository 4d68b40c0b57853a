// SPDX-License-Identifier: GPL-3.0-or-later
// The formulas lose what an independent transcription loses, no bound fails,
// and a seed gives the same errors again.

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/io.h"

#include "baselines/stability_study.h"
#include "support/sweep.h"
#include "text/quantile.h"

namespace truelux::testing {
namespace {

const auto kNothing = [] {};

/// A row of stability_reference.csv.
struct Reference {
  std::string regime;
  Formula formula = Formula::kAuto;
  double median = 0;
  double max = 0;
};

std::vector<Reference> ReadReferences() {
  std::ifstream file(TRUELUX_TEST_DATA "/stability_reference.csv");
  std::string line;
  std::getline(file, line);
  std::vector<Reference> references;
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    Reference reference;
    std::string formula;
    std::string median;
    std::string max;
    std::getline(fields, reference.regime, ',');
    std::getline(fields, formula, ',');
    std::getline(fields, median, ',');
    std::getline(fields, max, ',');
    reference.formula = FormulaByName(formula).value();
    reference.median = ParseNumber(median).value();
    reference.max = ParseNumber(max).value();
    references.push_back(reference);
  }
  return references;
}

/// Below this all medians are as good as each other: 4 u.
constexpr double kFloor = 4e-16;

/// Whether two errors are within a factor of each other.
bool AreNear(double x, double y, double factor) {
  x = std::max(x, kFloor);
  y = std::max(y, kFloor);
  return x <= factor * y && y <= factor * x;
}

StabilityOptions OptionsOf(int cases,
                           std::vector<StudyArithmetic> arithmetics) {
  StabilityOptions options;
  options.cases = cases;
  options.seed = 7;
  options.timed_cases = 0;
  options.arithmetics = std::move(arithmetics);
  return options;
}

/// Where the transcription computes otherwise, its median when it is written
/// like the C++ formula. Everywhere else the same operations in another order,
/// rounding coordinates once, and an arctangent of 5 u make no difference.
struct Rewritten {
  Formula formula;
  std::string regime;
  double median;
};

std::vector<Rewritten> RewrittenRows() {
  // The partial sums of exterior angles, vertex by vertex as the paper has it,
  // are as large as pi; edge by edge the two angles of an edge nearly cancel
  // before the next are added. It shows where the result is rounding only.
  std::vector<Rewritten> rows = {
      {Formula::kVertexLambert, "source plane 1e-8 up beside", 5.4}};
  // The C++ formulas work in the receiver's frame, where n.N is one component,
  // v_x v'_y - v_y v'_x; the transcription takes n.N in the axes of the scene,
  // where all three round. From 1e9 away the latter are multiples of 1e-7, and
  // v x v' is nearly exact, as luck will have it.
  for (const char* offset : {"0", "1e3", "1e6", "1e9"}) {
    rows.push_back({Formula::kLambertAtan2,
                    std::string("far ") + offset + " size 1e-3", 3.6e-12});
  }
  return rows;
}

double ExpectedMedian(const Reference& reference) {
  for (const Rewritten& row : RewrittenRows()) {
    if (row.regime == reference.regime && row.formula == reference.formula) {
      return row.median;
    }
  }
  return reference.median;
}

TEST(Stability, MedianAndLargestErrorsAreThoseOfTheTranscription) {
  std::map<std::string, RegimeStability> results;
  for (const Regime& regime : Regimes()) {
    if (regime.occluded) continue;
    results.emplace(
        regime.name,
        MeasureStability(regime, OptionsOf(1000, {StudyArithmetic::kDouble}),
                         kNothing));
  }
  const std::vector<Reference> references = ReadReferences();
  EXPECT_GT(references.size(), 400U);
  for (const Reference& reference : references) {
    const auto found = results.find(reference.regime);
    ASSERT_NE(found, results.end()) << reference.regime;
    const StabilityCell& cell =
        found->second.At(StudyArithmetic::kDouble, reference.formula);
    const std::string where =
        reference.regime + ", " + std::string(Name(reference.formula));
    EXPECT_EQ(cell.not_applicable, 0) << where;
    const double median = ExpectedMedian(reference);
    EXPECT_TRUE(AreNear(Median(cell.errors), median, 3))
        << where << ": median " << Median(cell.errors) << ", transcription "
        << median;
    EXPECT_TRUE(AreNear(Largest(cell.errors), reference.max, 100))
        << where << ": largest " << Largest(cell.errors) << ", transcription "
        << reference.max;
  }
}

/// Cases of each regime.
int CasesForBounds() {
  return SweepSize(10, 40);
}

RegimeStability MeasureBounds(const Regime& regime, int cases) {
  RegimeStability result = MeasureStability(
      regime, OptionsOf(cases, {StudyArithmetic::kBounded}), kNothing);
  for (const BoundViolation& v : result.violations) {
    ADD_FAILURE() << v.regime << ", case " << v.index << ", " << Name(v.formula)
                  << ": " << v.value << " +- " << v.bound << ", but "
                  << v.truth;
  }
  return result;
}

TEST(Stability, EveryBoundHolds) {
  std::int64_t checked = 0;
  for (const Regime& regime : Regimes()) {
    const RegimeStability result = MeasureBounds(regime, CasesForBounds());
    EXPECT_EQ(result.dark, 0) << regime.name;
    checked += result.bounds_checked;
  }
  // All formulas but, in many regimes, the series.
  EXPECT_GT(checked, std::int64_t{69} * CasesForBounds() * 12);
}

/// Three triangles around the receiver, across its horizon: integers, so that
/// corners meet edges, planes and the horizon; and some a few ulps off that.
/// Two emit, at least in front of the receiver.
RegimeCase Soup(CaseRandom& random, double nudge) {
  const auto coordinate = [&random, nudge] {
    const double x = random.Below(7) - 3;
    return x + nudge * (random.Below(5) - 2);
  };
  const auto vector = [&coordinate] {
    const double x = coordinate();
    const double y = coordinate();
    const double z = coordinate();
    return Point3{x, y, z};
  };
  SceneBuilder builder;
  for (int i = 0; i < 3; ++i) {
    const Point3 a = vector();
    const Point3 b = vector();
    const Point3 c = vector();
    const double emission = i < 2 ? 1 : 0;
    builder.AddFace({a, b, c}, {emission, emission, emission});
  }
  Receiver receiver;
  do {
    const Point3 n = vector();
    receiver.normal = {n.x, n.y, n.z};
  } while (receiver.normal.x == 0 && receiver.normal.y == 0 &&
           receiver.normal.z == 0);
  return {builder.Build().value.value(), receiver, {}};
}

/// Degenerate contours, cut by the horizon: arcs in the receiver plane, whole
/// edges as parts of edges, coincident vertices; image planes that are cut.
TEST(Stability, EveryBoundHoldsAcrossTheHorizon) {
  for (const double nudge : {0.0, 0x1p-51, 0x1p-30, 0.4}) {
    const Regime regime{"soup", true, [nudge](CaseRandom& random) {
                          return Soup(random, nudge);
                        }};
    const int cases = 10 * CasesForBounds();
    const RegimeStability result = MeasureBounds(regime, cases);
    EXPECT_GT(result.arcs.size(), static_cast<std::size_t>(cases) / 4);
    EXPECT_GT(Largest({result.sources.begin(), result.sources.end()}), 1);
  }
}

/// The bounds are not only right but mean something: the best formula of each
/// source bounds its error to a few digits less than all, whatever the regime.
TEST(Stability, TheBoundsOfAutoAreNarrow) {
  for (const Regime& regime : Regimes()) {
    const RegimeStability result = MeasureStability(
        regime, OptionsOf(40, {StudyArithmetic::kBounded}), kNothing);
    const StabilityCell& cell =
        result.At(StudyArithmetic::kBounded, Formula::kAuto);
    EXPECT_LT(Median(cell.errors), 1e-9) << regime.name;
  }
}

TEST(Stability, DoubleDoubleAndMpfrRoundCorrectlyWhereNothingIsHard) {
  for (const Regime& regime : Regimes()) {
    if (regime.name != "size 1e-0" && regime.name != "vertical edges") continue;
    const RegimeStability result = MeasureStability(
        regime,
        OptionsOf(50,
                  {StudyArithmetic::kDoubleDouble, StudyArithmetic::kMpfr128}),
        kNothing);
    for (const Formula formula : AllFormulas()) {
      if (formula == Formula::kAuto || formula == Formula::kSeries) continue;
      for (const StudyArithmetic arithmetic :
           {StudyArithmetic::kDoubleDouble, StudyArithmetic::kMpfr128}) {
        const StabilityCell& cell = result.At(arithmetic, formula);
        EXPECT_EQ(cell.errors.size(), 50U) << Name(formula);
        EXPECT_LT(Largest(cell.errors), 1.2e-16)
            << regime.name << ", " << Name(arithmetic) << ", " << Name(formula);
      }
    }
  }
}

TEST(Stability, TheSameSeedGivesTheSameErrors) {
  StabilityOptions options =
      OptionsOf(2, {kArithmetics.begin(), kArithmetics.end()});
  options.slow_cases = 1;
  StabilityOptions other = OptionsOf(2, {StudyArithmetic::kDouble});
  other.seed = 8;
  int different = 0;
  for (const Regime& regime : Regimes()) {
    const RegimeStability first = MeasureStability(regime, options, kNothing);
    const RegimeStability again = MeasureStability(regime, options, kNothing);
    EXPECT_TRUE(first.cells == again.cells) << regime.name;
    EXPECT_EQ(first.arcs, again.arcs);
    const RegimeStability third = MeasureStability(regime, other, kNothing);
    const auto edge = [](const RegimeStability& result) {
      return result.At(StudyArithmetic::kDouble, Formula::kLambertEdge).errors;
    };
    if (edge(third) != edge(first)) ++different;
  }
  EXPECT_EQ(different, 69);
}

TEST(Stability, TimesAreMeasuredOnTheFirstCases) {
  StabilityOptions options = OptionsOf(4, {StudyArithmetic::kDouble});
  options.timed_cases = 3;
  const RegimeStability result =
      MeasureStability(Regimes().front(), options, kNothing);
  const StabilityCell& cell =
      result.At(StudyArithmetic::kDouble, Formula::kLambertEdge);
  EXPECT_EQ(cell.errors.size(), 4U);
  ASSERT_EQ(cell.nanoseconds.size(), 3U);
  EXPECT_GT(Median(cell.nanoseconds), 0);
}

}  // namespace
}  // namespace truelux::testing
