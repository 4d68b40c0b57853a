// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/load_candidate.h"

#include <cmath>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "run/user_error.h"
#include "support/scenes.h"

namespace truelux {
namespace {

LoadedCandidate LoadAny(std::string_view text, const CandidateRules& rules) {
  TextSource source(text);
  const Scene scene = testing::SceneOf(3);
  FaceWords faces(scene);
  return LoadCandidate(source, "mine.csv", rules, faces);
}

CandidateData Load(std::string_view text) {
  return std::get<CandidateData>(
      LoadAny(text, {.quantity = Quantity::kFormFactor}).data);
}

/// What is wrong with a table: "line: message" for each defect.
std::vector<std::string> DefectsOf(std::string_view text) {
  std::vector<std::string> defects;
  try {
    (void)Load(text);
  } catch (const UserError& error) {
    for (const Diagnostic& defect : error.diagnostics()) {
      EXPECT_EQ(defect.file, "mine.csv");
      defects.push_back(std::to_string(defect.line) + ": " + defect.message);
    }
  }
  return defects;
}

TEST(LoadCandidate, KeepsReceiversLinesAndValuesInTheOrderOfTheTable) {
  const CandidateData data = Load(
      "x,y,z,nx,ny,nz,F\n"
      "1,0,0,0,0,1,0.5\n"
      "\n"
      "2,0,0,0,0,1,0.25\n");
  ASSERT_EQ(data.receivers.size(), 2U);
  EXPECT_EQ(data.receivers[1].position.x, 2);
  EXPECT_EQ(data.lines, (std::vector<std::size_t>{2, 4}));
  EXPECT_EQ(data.values[0][0], 0.5);
  EXPECT_EQ(data.values[1][0], 0.25);
  EXPECT_EQ(data.value_names, std::vector<std::string>{"F"});
  EXPECT_EQ(data.channels, std::vector<std::size_t>{0});
  EXPECT_TRUE(data.truth.empty());
}

TEST(LoadCandidate, TellsAllDefectsAtOnce) {
  const std::vector<std::string> defects = DefectsOf(
      "x,y,z,nx,ny,nz,F\n"
      "one,0,0,0,0,1,0.5\n"
      "1,0,0,0,0,1,0.5\n"
      "1,0,0,0,0,1,half\n");
  ASSERT_EQ(defects.size(), 2U);
  EXPECT_TRUE(defects[0].starts_with("2: ")) << defects[0];
  EXPECT_TRUE(defects[1].starts_with("4: ")) << defects[1];
}

TEST(LoadCandidate, ReadsNoRowsWithoutAHeader) {
  const std::vector<std::string> defects = DefectsOf(
      "x,y,z,nx,ny,nz,E\n"
      "one,0,0,0,0,1,0.5\n");
  ASSERT_EQ(defects.size(), 1U);
  EXPECT_TRUE(defects[0].starts_with("1: ")) << defects[0];
}

TEST(LoadCandidate, ATableWithoutReceiversIsADefect) {
  EXPECT_EQ(
      DefectsOf("x,y,z,nx,ny,nz,F\n"),
      std::vector<std::string>{"0: no receivers: the table has only a header"});
}

TEST(LoadCandidate, TakesGradientsWhereTheTableHasThem) {
  const std::string text =
      "x,y,z,nx,ny,nz,E_r,grad_g_x,grad_g_y,grad_g_z\n"
      "1,0,0,0,0,1,0.5,1,2,3\n"
      "2,0,0,0,0,1,0.5,,,\n";
  const LoadedCandidate loaded = LoadAny(text, {.channel = 1});
  EXPECT_TRUE(loaded.ignores_irradiance);
  const auto& data = std::get<GradientData>(loaded.data);
  EXPECT_EQ(data.channels, std::vector<std::size_t>{1});
  EXPECT_EQ(data.value_names,
            (std::vector<std::string>{"grad_g_x", "grad_g_y", "grad_g_z"}));
  ASSERT_EQ(data.values.size(), 2U);
  EXPECT_EQ(data.values[0][0].z, 3);
  EXPECT_EQ(data.values[0][1].x, 0);
  EXPECT_TRUE(std::isnan(data.values[1][0].y));
  EXPECT_TRUE(data.truth.empty());
  // Who asks for irradiances gets them.
  const LoadedCandidate asked =
      LoadAny("x,y,z,nx,ny,nz,E,grad_x\n1,0,0,0,0,1,0.5,1\n",
              {.quantity = Quantity::kIrradiance, .is_grey = true});
  EXPECT_EQ(std::get<CandidateData>(asked.data).values[0][0], 0.5);
  EXPECT_FALSE(asked.ignores_irradiance);
}

}  // namespace
}  // namespace truelux
