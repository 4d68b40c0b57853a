// SPDX-License-Identifier: GPL-3.0-or-later
// truelux compare from outside: what it prints, its exit status, its JSON.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/program.h"

namespace truelux::test {
namespace {

using nlohmann::json;

/// The square, and what eval says about the receivers under it.
class Compare : public ::testing::Test {
 protected:
  [[nodiscard]] Outcome Run(std::vector<std::string> more,
                            const Surroundings& around = {}) const {
    more.insert(more.begin(), {"compare", scene_});
    return RunTruelux(more, around);
  }

  /// A table of some receivers and one value each.
  [[nodiscard]] std::string One(const std::string& column,
                                const std::string& value) const {
    return folder_.Write("one.csv", "x,y,z,nx,ny,nz," + column +
                                        "\n0,0,0,0,0,1," + value + "\n");
  }

  TemporaryFolder folder_;
  std::string scene_ = WriteSquare(folder_);
  std::string table_ = folder_.Write("in.csv", Table(9));
  std::string truth_ = RunTruelux({"eval", scene_, table_}).out;
};

bool Contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(Compare, TakesWhatEvalWrites) {
  const Outcome outcome = Run({"-"}, {.input = truth_});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_TRUE(Contains(outcome.out, "PASS: 0 of 9 receivers fail"));
  EXPECT_TRUE(Contains(outcome.out, "exact 9, failing 0"));
  EXPECT_FALSE(Contains(outcome.out, "diagnosis"));
  // With its columns of bounds, and within a tolerance.
  const std::string rough =
      RunTruelux({"eval", scene_, table_, "--method", "double"}).out;
  EXPECT_TRUE(Contains(rough, "bound_b"));
  EXPECT_EQ(Run({"-", "--tolerance", "1e-13"}, {.input = rough}).exit_status,
            0);
}

TEST_F(Compare, FailsWithStatusOneAndNamesTheMistake) {
  const std::string radiance =
      RunTruelux({"eval", scene_, table_, "--emission", "radiance"}).out;
  const Outcome outcome = Run({"-"}, {.input = radiance});
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_TRUE(Contains(outcome.out, "FAIL: 9 of 9 receivers fail"));
  EXPECT_TRUE(Contains(outcome.out, "--emission radiance would agree"))
      << outcome.out;
  EXPECT_EQ(
      Run({"-", "--emission", "radiance"}, {.input = radiance}).exit_status, 0);
}

TEST_F(Compare, OneChannelAndFormFactors) {
  const std::string e = "0.5541264";  // of M = 1, seven digits
  EXPECT_EQ(Run({One("F", e), "--quantity", "form-factor"}).exit_status, 0);
  EXPECT_EQ(Run({One("E", e), "--channel", "r"}).exit_status, 0);
  EXPECT_EQ(Run({One("E", e), "--channel", "g"}).exit_status, 1);
  EXPECT_EQ(
      Run({One("E", e), "--channel", "r", "--tolerance", "0"}).exit_status, 1);
  const Outcome outcome = Run({One("E", e)});
  EXPECT_EQ(outcome.exit_status, 2);
  EXPECT_TRUE(Contains(outcome.err, "one.csv:1: error: column 'E' could be"))
      << outcome.err;
}

TEST_F(Compare, NanFailsAndIsCountedApart) {
  const Outcome outcome =
      Run({One("E", "nan"), "--channel", "r", "--tolerance", "1e9"});
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_TRUE(Contains(outcome.out, "not a number           1")) << outcome.out;
}

TEST_F(Compare, DarkReceiversAreHeldAgainstTheBrightest) {
  const std::string head =
      "x,y,z,nx,ny,nz,E_r,E_g,E_b\n" + truth_.substr(truth_.find('\n') + 1);
  const auto with = [&](const std::string& red) {
    return Run({"-", "--tolerance", "0.01"},
               {.input = head + "0,0,0,0,0,-1," + red + ",0,0\n"});
  };
  EXPECT_EQ(with("0.005").exit_status, 0);
  EXPECT_EQ(with("0.006").exit_status, 1);
  EXPECT_TRUE(Contains(with("0.006").out,
                       "E = 0                  1   exact 0, "
                       "failing 1, largest value 6.00e-3"))
      << with("0.006").out;
  EXPECT_TRUE(Contains(with("0.006").out, "\n     unlit\n"));
}

TEST_F(Compare, JsonHoldsTheSame) {
  std::string half = "x,y,z,nx,ny,nz,E_r,E_g,E_b\n";
  half += "0,0,0,0,0,1,0.277063212,0.554126424,0\n";
  half += "0.5,0,0,0,0,1,nan,0,0\n0.25,0,0,0,0,1,inf,0,0\n";
  const Outcome outcome =
      Run({"-", "-o", folder_ / "r.txt", "--json", folder_ / "r.json"},
          {.input = half});
  EXPECT_EQ(outcome.exit_status, 1) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(Contains(ReadFile(folder_ / "r.txt"), "worst receivers"));
  const json report = json::parse(ReadFile(folder_ / "r.json"));
  EXPECT_EQ(report["candidate"], "<stdin>");
  EXPECT_EQ(report["passes"], false);
  EXPECT_EQ(report["columns"], (json{"E_r", "E_g", "E_b"}));
  EXPECT_EQ(report["summary"]["receivers"], 3);
  EXPECT_EQ(report["summary"]["failing"], 3);
  EXPECT_EQ(report["summary"]["not_a_number"], 1);
  EXPECT_EQ(report["summary"]["relative_error"]["p100"], "inf");
  ASSERT_EQ(report["worst"].size(), 3U);
  EXPECT_EQ(report["worst"][0]["line"], 3);
  EXPECT_EQ(report["worst"][0]["candidate"][0], "nan");
  EXPECT_EQ(report["worst"][2]["line"], 2);
  EXPECT_NEAR(report["worst"][2]["error"].get<double>(), 0.5, 1e-6);
  EXPECT_EQ(report["worst"][2]["reason"]["lighting"], "fully lit");
  EXPECT_EQ(report["worst"][2]["reason"]["arcs"], 4);
  EXPECT_EQ(report["diagnosis"]["verdict"], "unexplained");
  EXPECT_FALSE(report["diagnosis"]["mistakes_tried"].empty());
  EXPECT_FALSE(report["diagnosis"]["classes"].empty());
}

TEST_F(Compare, TheReportDoesNotDependOnThreads) {
  std::string wrong = truth_;
  wrong.replace(wrong.rfind("0."), 2, "1.");
  const Outcome one = Run({"-", "--threads", "1"}, {.input = wrong});
  EXPECT_EQ(one.exit_status, 1);
  EXPECT_EQ(Run({"-", "--threads", "5"}, {.input = wrong}).out, one.out);
}

TEST_F(Compare, DefectsAreReportedTogetherAndNothingIsWritten) {
  folder_.Write("bad.csv",
                "x,y,z,nx,ny,nz,E_r,E_g,E_b\n0,0,0,0,0,1,one,2,3\n1,2\n");
  const Outcome outcome = Run({folder_ / "bad.csv", "-o", folder_ / "r.txt",
                               "--json", folder_ / "r.json"});
  EXPECT_EQ(outcome.exit_status, 2);
  EXPECT_TRUE(Contains(outcome.err, "bad.csv:2: error: E_r: 'one' is not"));
  EXPECT_TRUE(Contains(outcome.err, "bad.csv:3: error: 2 fields, but"));
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(folder_.Names(),
            (std::vector<std::string>{"bad.csv", "in.csv", "square.mtl",
                                      "square.obj"}));
  const Outcome both = Run({table_, "--json", table_});
  EXPECT_EQ(both.exit_status, 2);
  EXPECT_EQ(ReadFile(table_), Table(9));
}

TEST_F(Compare, UsageErrors) {
  const auto refused = [&](std::vector<std::string> more,
                           const std::string& message) {
    more.insert(more.begin(), table_);
    const Outcome outcome = Run(more);
    EXPECT_EQ(outcome.exit_status, 2);
    EXPECT_TRUE(Contains(outcome.err, message)) << outcome.err;
  };
  refused({}, "in.csv:1: error: the header lacks the columns E_r, E_g, E_b");
  refused({"--channel", "x"}, "--channel: 'x' is none of r, g, b");
  refused({"--tolerance", "-1"}, "--tolerance: '-1' is not a number from 0");
  refused({"--quantity", "form-factor", "--emission", "radiance"},
          "a form factor does not depend on it");
  refused({"--quantity", "form-factor", "--channel", "r"},
          "a form factor has no channels");
  refused({"--json", "-"}, "--output");
  folder_.Write("in.csv", "x,y,z,nx,ny,nz,E_r,E_g,E_b\n");
  refused({}, "in.csv: error: no receivers: the table has only a header");
}

TEST_F(Compare, TakesWhatGradientWrites) {
  const std::string gradients = RunTruelux({"gradient", scene_, table_}).out;
  const Outcome outcome =
      Run({"-", "--json", folder_ / "r.json"}, {.input = gradients});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_TRUE(Contains(outcome.out, "PASS: 0 of 9 receivers fail"));
  EXPECT_TRUE(Contains(outcome.out, "gradient > 0           9   exact 9"));
  EXPECT_TRUE(Contains(outcome.err, "--quantity irradiance compares"));
  const json report = json::parse(ReadFile(folder_ / "r.json"));
  EXPECT_EQ(report["quantity"], "gradient");
  EXPECT_EQ(report["summary"]["sloping"]["exact"], 9);
  EXPECT_EQ(report["columns"].size(), 9U);
  // The irradiances of the same table, if they are asked for.
  const Outcome irradiances =
      Run({"-", "--quantity", "irradiance"}, {.input = gradients});
  EXPECT_EQ(irradiances.exit_status, 0);
  EXPECT_TRUE(Contains(irradiances.out, "irradiance E_r,E_g,E_b"));
  EXPECT_EQ(irradiances.err, "");
}

TEST_F(Compare, NamesWhatIsWrongWithGradients) {
  const std::string table =
      folder_.Write("wrong.csv",
                    "x,y,z,nx,ny,nz,grad_r_x,grad_r_y,grad_r_z\n"
                    "0,0,0,0,0,1,1,2,3\n"
                    "0.1,0,0,0,0,1,nan,2,3\n"
                    "0.2,0,0,0,0,1,,,\n");
  const Outcome outcome =
      Run({table, "--channel", "r", "--json", folder_ / "r.json"});
  EXPECT_EQ(outcome.exit_status, 1) << outcome.err;
  EXPECT_TRUE(Contains(outcome.out, "FAIL: 3 of 3 receivers fail"));
  EXPECT_TRUE(Contains(outcome.out, "not a number           2"));
  EXPECT_TRUE(Contains(outcome.out, "worst receivers"));
  const json report = json::parse(ReadFile(folder_ / "r.json"));
  EXPECT_EQ(report["worst"].size(), 3U);
  EXPECT_EQ(report["worst"][0]["candidate"][0], "nan");
  EXPECT_EQ(report["diagnosis"]["verdict"], "unexplained");
  // A table with some of the columns says which are missing.
  const Outcome missing = Run({table});
  EXPECT_EQ(missing.exit_status, 2);
  EXPECT_TRUE(Contains(missing.err, "lacks the columns grad_g_x, grad_g_y"));
}

}  // namespace
}  // namespace truelux::test
