// The hard cases in tests/data/cases: expected.csv is the correctly rounded
// answer of an independent program that subtracts cones from cones.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/io.h"
#include "truelux/irradiance.h"

namespace truelux {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> CaseNames() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(TRUELUX_TEST_DATA "/cases")) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// The numbers of a CSV without quotes, below its header.
std::vector<std::vector<double>> ReadNumbers(const fs::path& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  std::vector<std::vector<double>> rows;
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    std::string field;
    rows.emplace_back();
    while (std::getline(fields, field, ',')) {
      rows.back().push_back(ParseNumber(field).value());
    }
  }
  return rows;
}

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
  const fs::path folder = fs::path(TRUELUX_TEST_DATA "/cases") / name;
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
}  // namespace truelux
