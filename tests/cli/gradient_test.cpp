// SPDX-License-Identifier: GPL-3.0-or-later
// truelux gradient: columns, tables beside the output, notes, refusals.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "cli/program.h"

namespace truelux::test {
namespace {

bool Contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

std::vector<std::string> LinesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

std::vector<std::string> FieldsOf(const std::string& line, char separator) {
  std::vector<std::string> fields(1);
  for (const char c : line) {
    if (c == separator) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

class Gradient : public testing::Test {
 protected:
  [[nodiscard]] static Outcome Run(const std::vector<std::string>& words) {
    std::vector<std::string> all = {"gradient"};
    all.insert(all.end(), words.begin(), words.end());
    return RunTruelux(all);
  }

  TemporaryFolder folder_;
  std::string scene_ = WriteSquare(folder_);
  std::string table_ = folder_.Write("in.csv", Table(600));
};

TEST_F(Gradient, ColumnsComeInOneOrderWhateverIsAsked) {
  const Outcome usual = Run({scene_, table_});
  EXPECT_EQ(usual.exit_status, 0) << usual.err;
  const std::string receivers =
      "x,y,z,nx,ny,nz,E_r,E_g,E_b,status_r,status_g,"
      "status_b,";
  EXPECT_EQ(LinesOf(usual.out)[0],
            receivers +
                "grad_r_x,grad_r_y,grad_r_z,grad_g_x,grad_g_y,grad_g_z,"
                "grad_b_x,grad_b_y,grad_b_z");
  EXPECT_EQ(LinesOf(usual.out).size(), 601U);
  const Outcome flux = Run({scene_, table_, "--of", "flux,normal"});
  EXPECT_EQ(LinesOf(flux.out)[0],
            receivers +
                "dn_r_x,dn_r_y,dn_r_z,dn_g_x,dn_g_y,dn_g_z,dn_b_x,"
                "dn_b_y,dn_b_z,flux_r,flux_g,flux_b");
  const Outcome all =
      Run({scene_, table_, "--of",
           "gradient,tangential,normal,vector,sphere,flux,jacobian"});
  const auto header = FieldsOf(LinesOf(all.out)[0], ',');
  EXPECT_EQ(header.size(), 6U + 6 + 3 * (3 + 3 + 3 + 3 + 18 + 3 + 1));
  EXPECT_EQ(std::ranges::count(header, "Jsphere_b_zx"), 1);
  EXPECT_EQ(std::ranges::count(header, "J_g_xy"), 1);
}

TEST_F(Gradient, RefusesColumnsThatItWrites) {
  const std::string table = folder_.Write(
      "taken.csv",
      "x,y,z,nx,ny,nz,grad_g_y,status_r,flux_r\n0,0,0,0,0,1,1,2,3\n");
  const Outcome outcome = Run({scene_, table});
  EXPECT_EQ(outcome.exit_status, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(Contains(outcome.err, "'grad_g_y' has the name of a result"));
  EXPECT_TRUE(Contains(outcome.err, "'status_r' has the name of a result"));
  EXPECT_FALSE(Contains(outcome.err, "flux_r"));
  EXPECT_TRUE(Contains(Run({scene_, table, "--of", "flux"}).err, "flux_r"));
}

TEST_F(Gradient, IrradianceIsThatOfEvalAndThreadsChangeNothing) {
  const Outcome eval = RunTruelux({"eval", scene_, table_});
  const Outcome one = Run({scene_, table_, "--threads", "1"});
  const Outcome three = Run({scene_, table_, "--threads", "3"});
  EXPECT_EQ(one.out, three.out);
  const auto rows = LinesOf(one.out);
  const auto values = LinesOf(eval.out);
  ASSERT_EQ(rows.size(), values.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    EXPECT_TRUE(rows[i].starts_with(values[i] + ",")) << i;
}

TEST_F(Gradient, DoubleHasBoundsThatHold) {
  const std::string stats = folder_ / "stats.json";
  const Outcome certified = Run({scene_, table_, "--of", "gradient,vector"});
  const Outcome plain = Run({scene_, table_, "--of", "gradient,vector",
                             "--method", "double", "--stats", stats});
  EXPECT_EQ(plain.exit_status, 0) << plain.err;
  EXPECT_TRUE(Contains(ReadFile(stats), "\"receivers\": 600"));
  const auto header = FieldsOf(LinesOf(plain.out)[0], ',');
  ASSERT_EQ(header.size(), 6U + 6 + 18 + 3 + 18);
  EXPECT_EQ(header[30], "bound_E_r");
  EXPECT_EQ(header[33], "bound_grad_r_x");
  const auto truth = LinesOf(certified.out);
  const auto rows = LinesOf(plain.out);
  double largest = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto want = FieldsOf(truth[i], ',');
    const auto got = FieldsOf(rows[i], ',');
    for (std::size_t k = 12; k < 30; ++k) {
      const double error = std::fabs(std::stod(got[k]) - std::stod(want[k]));
      const double bound = std::stod(got[k + 21]);
      EXPECT_LE(error, bound) << i << ' ' << header[k];
      EXPECT_LT(bound, 1e-12) << i << ' ' << header[k];
      largest = std::max(largest, error);
    }
  }
  EXPECT_GT(largest, 0);
}

TEST_F(Gradient, TheSeparatorOfTheInputIsKept) {
  const std::string table =
      folder_.Write("in.tsv", "x\ty\tz\tnx\tny\tnz\n0\t0\t0\t0\t0\t1\n");
  const Outcome outcome = Run({scene_, table});
  const auto lines = LinesOf(outcome.out);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(FieldsOf(lines[1], '\t').size(), FieldsOf(lines[0], '\t').size());
  EXPECT_FALSE(Contains(lines[1], ","));
}

// The first receiver is in the plane of the square, the second on it.
TEST_F(Gradient, KinksAndFacesAreSaid) {
  const std::string table =
      folder_.Write("at.csv", std::string(kHeader) +
                                  "3,0,1,-1,0,0\n0,0,1,1,0,0\n0,0,0,0,0,1\n");
  const std::string kinks = folder_ / "kinks.csv";
  const Outcome outcome = Run({scene_, table, "--kinks", kinks});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_TRUE(Contains(outcome.err, "1 of 3 receivers is at a kink"));
  EXPECT_TRUE(Contains(outcome.err, "1 of 3 receivers lies on a face"));
  const auto rows = LinesOf(outcome.out);
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_TRUE(Contains(rows[1], ",kink,kink,kink,"));
  EXPECT_TRUE(
      rows[2].ends_with("discontinuous,discontinuous,discontinuous,,,,,,,,,"))
      << rows[2];
  EXPECT_TRUE(Contains(rows[3], ",C1,C1,C1,0,0,"));
  const auto lines = LinesOf(ReadFile(kinks));
  ASSERT_EQ(lines.size(), 3U);  // the square does not shine in blue
  EXPECT_EQ(lines[0], "receiver,channel,mx,my,mz,b,cause");
  EXPECT_TRUE(lines[1].starts_with("1,r,0,0,1,")) << lines[1];
  EXPECT_TRUE(lines[1].ends_with(",face 1 edge-on")) << lines[1];
}

TEST_F(Gradient, VerticesHaveTheNumbersOfTheFile) {
  const std::string table =
      folder_.Write("at.csv", std::string(kHeader) + "0,0,0,0,0,1\n");
  const std::string vertices = folder_ / "vertices.csv";
  const Outcome outcome = Run({scene_, table, "--vertices", vertices});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  const auto lines = LinesOf(ReadFile(vertices));
  EXPECT_EQ(lines[0], "receiver,channel,vertex,axis,value,left,right");
  ASSERT_EQ(lines.size(), 1U + 4 * 2 * 3);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto fields = FieldsOf(lines[i], ',');
    ASSERT_EQ(fields.size(), 7U);
    EXPECT_EQ(fields[0], "1");
    EXPECT_TRUE(fields[2] >= "1" && fields[2] <= "4");
    EXPECT_NE(fields[4], "");
  }
  // Opposite corners of the square pull in opposite directions.
  EXPECT_EQ(lines[1].substr(0, 8), "1,r,1,x,");
  EXPECT_TRUE(Contains(lines[1], "-"));
}

// Weight 1 in red alone: the sum is that of the rows of --vertices.
TEST_F(Gradient, VertexGradientIsTheWeightedSum) {
  const std::string table = folder_.Write(
      "at.csv",
      "x,y,z,nx,ny,nz,weight_r,weight_g,weight_b\n0.1,0,0,0,0,1,1,0,0\n"
      "0,0.2,0,0,0,1,2,0,0\n");
  const std::string vertices = folder_ / "vertices.csv";
  const std::string sum = folder_ / "sum.csv";
  const Outcome outcome =
      Run({scene_, table, "--vertices", vertices, "--vertex-gradient", sum});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  double expected = 0;
  for (const std::string& line : LinesOf(ReadFile(vertices))) {
    const auto fields = FieldsOf(line, ',');
    if (fields[1] != "r" || fields[2] != "3" || fields[3] != "y") continue;
    expected += (fields[0] == "1" ? 1 : 2) * std::stod(fields[4]);
  }
  const auto rows = LinesOf(ReadFile(sum));
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_EQ(rows[0], "vertex,x,y,z");
  EXPECT_NE(expected, 0);
  EXPECT_NEAR(std::stod(FieldsOf(rows[3], ',')[2]), expected, 1e-15);
  const Outcome missing =
      Run({scene_, table_, "--vertex-gradient", folder_ / "no.csv"});
  EXPECT_EQ(missing.exit_status, 2);
  EXPECT_TRUE(Contains(missing.err, "lacks the columns weight_r, weight_g"));
}

TEST_F(Gradient, WrongWordsAreRefused) {
  const Outcome group = Run({scene_, table_, "--of", "gradient,slope"});
  EXPECT_EQ(group.exit_status, 2);
  EXPECT_TRUE(Contains(group.err, "--of: 'slope' is none of gradient, "));
  EXPECT_EQ(Run({scene_, table_, "--of", ""}).exit_status, 2);
  EXPECT_EQ(Run({scene_}).exit_status, 2);
  EXPECT_EQ(Run({scene_, table_, "--kinks", "-"}).exit_status, 2);
  const Outcome twice = Run({scene_, table_, "-o", folder_ / "a.csv", "--kinks",
                             folder_ / "./a.csv"});
  EXPECT_EQ(twice.exit_status, 2);
  EXPECT_EQ(folder_.Names(),
            (std::vector<std::string>{"in.csv", "square.mtl", "square.obj"}));
}

}  // namespace
}  // namespace truelux::test
