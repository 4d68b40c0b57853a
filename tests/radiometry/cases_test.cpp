// The hard cases in tests/data/cases: expected.csv is the correctly rounded
// answer of an independent program that subtracts cones from cones.

#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/io.h"
#include "truelux/irradiance.h"

#include "support/case_files.h"

namespace truelux::testing {
namespace {

struct Setup {
  const char* name;
  OracleOptions options;
};

void PrintTo(const Setup& setup, std::ostream* out) {
  *out << setup.name;
}

class Cases : public ::testing::TestWithParam<std::tuple<std::string, Setup>> {
};

TEST_P(Cases, EveryBitIsRight) {
  const auto& [name, setup] = GetParam();
  const auto folder = CaseFolder(name);
  const Result<Scene> scene = ReadScene(folder / "scene.obj");
  ASSERT_TRUE(scene.ok());
  const Oracle oracle(*scene.value, setup.options);
  const auto expected = ReadNumbers(folder / "expected.csv");
  ASSERT_FALSE(expected.empty());
  for (const std::vector<double>& row : expected) {
    ASSERT_EQ(row.size(), 9U);
    const Irradiance e = oracle.Evaluate(
        {{row[0], row[1], row[2]}, {row[3], row[4], row[5]}, 0});
    EXPECT_EQ(e.value, (Rgb{row[6], row[7], row[8]}));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Shared, Cases,
    ::testing::Combine(
        ::testing::ValuesIn(CaseNames()),
        ::testing::Values(Setup{"contour", {}},
                          Setup{"table", {.formula = Formula::kUnified}},
                          Setup{"arrangement",
                                {.engine = Engine::kArrangement}},
                          Setup{"spans", {.engine = Engine::kAngularSpans}})),
    [](const auto& instance) {
      return std::get<0>(instance.param) + "_" +
             std::get<1>(instance.param).name;
    });

}  // namespace
}  // namespace truelux::testing
