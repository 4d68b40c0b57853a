// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/load_candidate.h"

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "run/user_error.h"
#include "support/scenes.h"

namespace truelux {
namespace {

CandidateData Load(std::string_view text) {
  TextSource source(text);
  const Scene scene = testing::SceneOf(3);
  FaceWords faces(scene);
  return LoadCandidate(source, "mine.csv", {.quantity = Quantity::kFormFactor},
                       faces);
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
  EXPECT_EQ(data.lines, (std::vector<int>{2, 4}));
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

}  // namespace
}  // namespace truelux
