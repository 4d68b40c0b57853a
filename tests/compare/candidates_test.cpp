// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/candidates.h"

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "support/scenes.h"

namespace truelux {
namespace {

using Texts = std::vector<std::string>;

struct CandidateText {
  bool header_ok = false;
  std::vector<CandidateRow> rows;
  std::vector<std::size_t> channels;
  Texts names;
  Texts defects;
};

CandidateText Read(std::string_view text, const CandidateRules& rules = {}) {
  const Scene scene = testing::SceneOf(3);
  FaceWords faces(scene);
  TextSource source(text);
  CandidateReader reader(source, "t.csv", rules, faces);
  CandidateText result;
  std::vector<Diagnostic> defects;
  result.header_ok = reader.ReadHeader(defects);
  auto status = result.header_ok ? CandidateReader::Status::kRow
                                 : CandidateReader::Status::kEnd;
  CandidateRow row;
  while (status != CandidateReader::Status::kEnd) {
    status = reader.Next(row, defects);
    if (status == CandidateReader::Status::kRow) result.rows.push_back(row);
  }
  result.channels = reader.channels();
  result.names = reader.value_names();
  for (const Diagnostic& defect : defects)
    result.defects.push_back(defect.Text());
  return result;
}

constexpr CandidateRules kGrey{.is_grey = true};
constexpr CandidateRules kFormFactors{.quantity = Quantity::kFormFactor};
constexpr CandidateRules kGreen{.channel = 1};

TEST(Candidates, TakeWhatEvalWrites) {
  const CandidateText t = Read(
      "name,x,y,z,nx,ny,nz,on_face,E_r,E_g,E_b,bound_r,bound_g,bound_b\n"
      "\"a\nb\",1,2,3,0,0,1,2,0.5,1e-3,inf,0,nan,0\n"
      "c,1,2,3,0,0,1,,-0,nan,-inf,0,0,0\n");
  EXPECT_EQ(t.defects, Texts{});
  ASSERT_EQ(t.rows.size(), 2U);
  EXPECT_EQ(t.channels, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(t.rows[0].receiver.on_face, 2);
  EXPECT_EQ(t.rows[0].line, 2);
  EXPECT_EQ(t.rows[1].line, 4);
  EXPECT_EQ(t.rows[0].values[1], 1e-3);
  EXPECT_TRUE(std::isinf(t.rows[0].values[2]));
  EXPECT_TRUE(std::isnan(t.rows[1].values[1]));
  EXPECT_LT(t.rows[1].values[2], 0);
}

TEST(Candidates, OneColumnStandsForAChannel) {
  const std::string text = "x,y,z,nx,ny,nz,E\n0,0,0,0,0,1,7\n";
  EXPECT_EQ(Read(text, kGrey).channels, std::vector<std::size_t>{0});
  EXPECT_EQ(Read(text, kGreen).channels, std::vector<std::size_t>{1});
  EXPECT_EQ(Read(text, kGreen).rows.at(0).values, (Rgb{7, 0, 0}));
  EXPECT_EQ(Read(text).defects,
            Texts{"t.csv:1: error: column 'E' could be any channel, and the "
                  "scene's differ; say which by --channel r, g or b, or give "
                  "E_r,E_g,E_b"});
}

TEST(Candidates, AChannelMayBeTakenFromItsOwnColumn) {
  const CandidateText t =
      Read("x,y,z,nx,ny,nz,E_g,E_r\n0,0,0,0,0,1,7,8\n", kGreen);
  EXPECT_EQ(t.defects, Texts{});
  EXPECT_EQ(t.names, Texts{"E_g"});
  EXPECT_EQ(t.rows.at(0).values, (Rgb{7, 0, 0}));
}

TEST(Candidates, FormFactorsHaveAColumnOfTheirOwn) {
  const std::string text = "x,y,z,nx,ny,nz,F\n0,0,0,0,0,1,0.5\n";
  EXPECT_EQ(Read(text, kFormFactors).rows.at(0).values, (Rgb{0.5, 0, 0}));
  EXPECT_EQ(Read(text).defects,
            Texts{"t.csv:1: error: column 'F' but no E: form factors are "
                  "compared by --quantity form-factor"});
  EXPECT_EQ(Read("x,y,z,nx,ny,nz,E_r,E_g,E_b\n", kFormFactors).defects.size(),
            1U);
}

TEST(Candidates, EveryDefectOfAHeaderIsReported) {
  EXPECT_EQ(
      Read("x,y,nx,ny,nz,E_r,E_r,E_b\n").defects,
      (Texts{"t.csv:1: error: the header lacks the column z; expected names "
             "like x,y,z,nx,ny,nz with commas between (or semicolons, tabs, "
             "blanks), found "
             "'x,y,nx,ny,nz,E_r,E_r,E_b'",
             "t.csv:1: error: column 'E_r' stands twice",
             "t.csv:1: error: the header lacks the column E_g; expected the "
             "candidate's E_r,E_g,E_b, or one column E"}));
  EXPECT_EQ(Read("x,y,z,nx,ny,nz,E,E_g\n", kGrey).defects,
            Texts{"t.csv:1: error: both column 'E' and a column E_r, E_g or "
                  "E_b; expected one of them"});
  EXPECT_EQ(Read("x,y,z,nx,ny,nz\n").defects.size(), 1U);
  EXPECT_EQ(Read("").defects.size(), 1U);
}

TEST(Candidates, EveryDefectOfARowIsReportedAndTheNextIsRead) {
  const CandidateText t = Read(
      "x,y,z,nx,ny,nz,on_face,E\n"
      "a,0,0,0,0,0,9,bright\n"
      "0,0,0,0,0,1,1,\n"
      "0,0,0,0,0,1,1,1e999\n"
      "0,0,0\n"
      "0,0,0,0,0,1,1,+Infinity\n",
      kGrey);
  const std::string expected =
      "is not a number; expected a decimal number in the range of binary64";
  EXPECT_EQ(t.defects,
            (Texts{"t.csv:2: error: x: 'a' " + expected,
                   "t.csv:2: error: the normal is zero",
                   std::string("t.csv:2: error: on_face: '9' is out of range; "
                               "the scene has 3 faces"),
                   "t.csv:2: error: E: 'bright' " + expected + ", inf or nan",
                   "t.csv:3: error: E: '' " + expected + ", inf or nan",
                   "t.csv:4: error: E: '1e999' " + expected + ", inf or nan",
                   "t.csv:5: error: 3 fields, but the header has 8"}));
  EXPECT_EQ(t.rows.size(), 1U);
}

TEST(Candidates, GradientsHaveThreeColumnsAChannel) {
  const std::string place = "x,y,z,nx,ny,nz,";
  const CandidateText t =
      Read(place +
           "grad_r_x,grad_r_y,grad_r_z,grad_g_x,grad_g_y,grad_g_z,"
           "grad_b_x,grad_b_y,grad_b_z\n0,0,0,0,0,1,1,2,3,4,5,6,7,8,nan\n");
  EXPECT_EQ(t.defects, Texts{});
  EXPECT_EQ(t.channels, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(t.names.size(), 9U);
  EXPECT_EQ(t.rows.at(0).gradient[1].y, 5);
  EXPECT_TRUE(std::isnan(t.rows.at(0).gradient[2].z));
  const std::string single =
      place + "grad_x,grad_y,grad_z\n0,0,0,0,0,1,1,2,3\n";
  EXPECT_EQ(Read(single, kGrey).rows.at(0).gradient[0].z, 3);
  EXPECT_EQ(Read(single, kGreen).channels, std::vector<std::size_t>{1});
  EXPECT_EQ(Read(single).defects,
            Texts{"t.csv:1: error: columns 'grad_x', 'grad_y' and 'grad_z' "
                  "could be any channel, and the scene's differ; say which by "
                  "--channel r, g or b, or give grad_r_x .. grad_b_z"});
  EXPECT_EQ(
      Read(place + "grad_r_x,grad_r_y,grad_r_z\n", {.channel = 0}).defects,
      Texts{});
  EXPECT_EQ(Read(place + "grad_g_x,grad_g_z\n", kGreen).defects,
            Texts{"t.csv:1: error: the header lacks the column grad_g_y; "
                  "expected the candidate's grad_r_x .. grad_b_z, or "
                  "grad_x,grad_y,grad_z"});
  EXPECT_EQ(Read(single.substr(0, single.size() - 2) + "three\n", kGrey)
                .defects.size(),
            1U);
}

}  // namespace
}  // namespace truelux
