// SPDX-License-Identifier: GPL-3.0-or-later
// The hard cases in tests/data/cases: expected.csv is the correctly rounded
// answer of an independent program that subtracts cones from cones.

#include <ostream>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/io.h"
#include "truelux/irradiance.h"

#include "support/case_files.h"
#include "support/twin_values.h"

namespace truelux::testing {
namespace {

struct Setup {
  const char* name;
  OracleOptions options;
};

void PrintTo(const Setup& setup, std::ostream* out) {
  *out << setup.name;
}

struct Expected {
  Receiver receiver;
  Rgb value{};
};

/// The rows of a case's expected.csv.
std::vector<Expected> ExpectedOf(const std::string& name) {
  std::vector<Expected> expected;
  for (const std::vector<double>& row :
       ReadNumbers(CaseFolder(name) / "expected.csv")) {
    if (row.size() != 9) {
      ADD_FAILURE() << name << " has a row of " << row.size();
      continue;
    }
    expected.push_back({{{row[0], row[1], row[2]}, {row[3], row[4], row[5]}, 0},
                        {row[6], row[7], row[8]}});
  }
  EXPECT_FALSE(expected.empty());
  return expected;
}

class Cases : public ::testing::TestWithParam<std::tuple<std::string, Setup>> {
};

TEST_P(Cases, EveryBitIsRight) {
  const auto& [name, setup] = GetParam();
  const Result<Scene> scene = ReadScene(CaseFolder(name) / "scene.obj");
  ASSERT_TRUE(scene.ok());
  const Oracle oracle(*scene.value, setup.options);
  for (const Expected& expected : ExpectedOf(name))
    EXPECT_EQ(oracle.Evaluate(expected.receiver).value, expected.value);
}

INSTANTIATE_TEST_SUITE_P(
    Shared, Cases,
    ::testing::Combine(
        ::testing::ValuesIn(CaseNames()),
        ::testing::Values(Setup{"contour", {}},
                          Setup{"table", {.formula = Formula::kUnified}})),
    [](const auto& instance) {
      return std::get<0>(instance.param) + "_" +
             std::get<1>(instance.param).name;
    });

class TwinCases : public ::testing::TestWithParam<std::string> {};

TEST_P(TwinCases, EveryBitIsRight) {
  const Result<Scene> scene = ReadScene(CaseFolder(GetParam()) / "scene.obj");
  ASSERT_TRUE(scene.ok());
  for (const Expected& expected : ExpectedOf(GetParam())) {
    const TwinValues twins = TwinValuesOf(*scene.value, expected.receiver);
    EXPECT_EQ(twins.arrangement, expected.value);
    EXPECT_EQ(twins.spans, expected.value);
  }
}

INSTANTIATE_TEST_SUITE_P(Shared, TwinCases, ::testing::ValuesIn(CaseNames()),
                         [](const auto& instance) { return instance.param; });

}  // namespace
}  // namespace truelux::testing
