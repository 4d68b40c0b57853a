// SPDX-License-Identifier: GPL-3.0-or-later
// truelux bench from outside: what it writes, and what it refuses.

#include <algorithm>
#include <csignal>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/program.h"
#include "support/well_formed.h"

namespace truelux::test {
namespace {

using testing::CountOf;
using testing::MarkupDefect;

/// The square, a table of receivers under it, and quick runs.
class Bench : public ::testing::Test {
 protected:
  [[nodiscard]] Outcome Run(std::vector<std::string> more,
                            const Surroundings& around = {}) const {
    more.insert(more.begin(), {"bench", scene_, table_, "--quick"});
    if (std::ranges::find(more, "--seconds") == more.end())
      more.insert(more.end(), {"--seconds", "2"});
    return RunTruelux(more, around);
  }

  /// Exit status 2, the message, and nothing written.
  void ExpectRefused(const Outcome& outcome, const std::string& message) const {
    EXPECT_EQ(outcome.exit_status, 2);
    EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(folder_.Names(),
              (std::vector<std::string>{"in.csv", "square.mtl", "square.obj"}));
  }

  TemporaryFolder folder_;
  std::string scene_ = WriteSquare(folder_);
  std::string table_ = folder_.Write("in.csv", Table(9));
};

TEST_F(Bench, WritesAPageAndTwoTables) {
  const Outcome outcome = Run({"-o", folder_ / "report.html"});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(folder_.Names(),
            (std::vector<std::string>{"in.csv", "report.csv", "report.html",
                                      "report_receivers.csv", "square.mtl",
                                      "square.obj"}));
  const std::string html = ReadFile(folder_ / "report.html");
  EXPECT_EQ(MarkupDefect(html), "");
  EXPECT_EQ(CountOf(html, "<h1>Speed and error: square.obj</h1>"), 1U);
  const std::string methods = ReadFile(folder_ / "report.csv");
  EXPECT_EQ(methods.find("method,group,microseconds,"), 0U);
  EXPECT_EQ(CountOf(methods, "\ncertified,truelux,"), 1U);
  EXPECT_EQ(CountOf(methods, "\nscanline 64,scanline,"), 1U);
  // The series applies to none of these receivers, in any arithmetic.
  EXPECT_EQ(CountOf(methods, "\nseries "), 4U);
  EXPECT_EQ(CountOf(html, "class=\"mark\""), CountOf(methods, "\n") - 1 - 4);
  EXPECT_EQ(CountOf(ReadFile(folder_ / "report_receivers.csv"), "\n"), 10U);
}

TEST_F(Bench, TheTruthIsThatOfEval) {
  ASSERT_EQ(Run({"-o", folder_ / "report.html"}).exit_status, 0);
  const std::string receivers = ReadFile(folder_ / "report_receivers.csv");
  const std::string eval = RunTruelux({"eval", scene_, table_}).out;
  // x,y,z,nx,ny,nz,E_r,E_g,E_b of the last row.
  std::string row = eval.substr(eval.rfind("0.8,"));
  row = row.substr(std::string("0.8,0,0,0,0,1,").size());
  row.pop_back();
  EXPECT_EQ(CountOf(receivers, "\n9,0.8,0,0,0,0,1,," + row + ",\"fully lit"),
            1U)
      << receivers;
}

TEST_F(Bench, TheSameSeedGivesTheSameNoise) {
  const auto noise = [this](const std::string& seed) {
    EXPECT_EQ(Run({"-o", folder_ / "r.html", "--seed", seed}).exit_status, 0);
    return ReadFile(folder_ / "r_receivers.csv");
  };
  const std::string first = noise("1");
  if (CountOf(first, "Embree") == 0) GTEST_SKIP() << "built without Embree 3";
  EXPECT_EQ(first, noise("1"));
  EXPECT_NE(first, noise("2"));
}

TEST_F(Bench, PicksReceiversEvenly) {
  ASSERT_EQ(Run({"-o", folder_ / "r.html", "--receivers", "3"}).exit_status, 0);
  const std::string rows = ReadFile(folder_ / "r_receivers.csv");
  EXPECT_EQ(CountOf(rows, "\n"), 4U);
  for (const char* row : {"\n1,0.1,0,", "\n2,0.4,0,", "\n3,0.7,0,"})
    EXPECT_EQ(CountOf(rows, row), 1U) << rows;
}

TEST_F(Bench, WithoutTimeTriesAFewReceiversAndSaysSo) {
  folder_.Write("in.csv", Table(40));
  ASSERT_EQ(Run({"-o", folder_ / "r.html", "--seconds", "0"}).exit_status, 0);
  const std::string methods = ReadFile(folder_ / "r.csv");
  EXPECT_EQ(CountOf(methods, ",40,0,40,0,"), 1U)
      << methods;  // the truth is whole
  const std::string scanline = methods.substr(methods.find("\nscanline 8,"));
  EXPECT_EQ(CountOf(scanline.substr(0, scanline.find('\n', 1)), ",1,39,"), 1U)
      << methods;
  EXPECT_GE(CountOf(ReadFile(folder_ / "r.html"), "not tried on 39 receivers"),
            1U);
}

TEST_F(Bench, ReadsStandardInput) {
  const Outcome outcome =
      RunTruelux({"bench", scene_, "-", "-o", folder_ / "r.html", "--quick",
                  "--seconds", "0"},
                 {.input = Table(2)});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_EQ(CountOf(ReadFile(folder_ / "r_receivers.csv"), "\n"), 3U);
}

TEST_F(Bench, ShowsProgressOnATerminalAndClearsIt) {
  const Outcome outcome = Run({"-o", folder_ / "r.html"}, {.terminal = true});
  EXPECT_EQ(outcome.exit_status, 0);
  EXPECT_NE(outcome.err.find("certified: 0 of 9 receivers"), std::string::npos)
      << outcome.err;
  EXPECT_TRUE(outcome.err.ends_with("\r\033[K")) << outcome.err;
}

TEST_F(Bench, InterruptedLeavesNoFile) {
  folder_.Write("in.csv", Table(1000));
  Surroundings around;
  around.watch = [this](pid_t pid) {
    const std::vector<std::string> names = folder_.Names();
    const bool started = std::ranges::any_of(
        names, [](const std::string& name) { return name.ends_with(".tmp"); });
    if (started) kill(pid, SIGINT);
    return started;
  };
  const Outcome outcome =
      RunTruelux({"bench", scene_, table_, "-o", folder_ / "r.html"}, around);
  EXPECT_EQ(outcome.exit_status, 130);
  EXPECT_EQ(outcome.err, "interrupted\n");
  EXPECT_EQ(folder_.Names(),
            (std::vector<std::string>{"in.csv", "square.mtl", "square.obj"}));
}

TEST_F(Bench, DefectsAreReportedTogether) {
  folder_.Write("in.csv", std::string(kHeader) + "0,zero,0,0,0,1\n1,2\n");
  const Outcome outcome = Run({"-o", folder_ / "r.html"});
  ExpectRefused(outcome, "in.csv:2: error: y: 'zero' is not a number");
  EXPECT_NE(outcome.err.find("in.csv:3: error: 2 fields"), std::string::npos);
}

TEST_F(Bench, ATableWithoutReceiversIsRefused) {
  folder_.Write("in.csv", kHeader);
  ExpectRefused(Run({"-o", folder_ / "r.html"}),
                "in.csv: error: no receivers: the table has only a header");
}

TEST_F(Bench, ADefectiveSceneIsRefused) {
  folder_.Write("square.obj", "v 0 0 zero\nf 1 1 1\n");
  ExpectRefused(Run({"-o", folder_ / "r.html"}), "square.obj:1: error: ");
}

TEST_F(Bench, TablesDoNotReplaceInputs) {
  ExpectRefused(Run({"-o", folder_ / "in.html"}), "is also the input");
}

TEST_F(Bench, TheReportIsAFile) {
  ExpectRefused(Run({}), "--output is required");
  ExpectRefused(Run({"-o", "-"}),
                "--output: '-' cannot name a report and its tables");
  ExpectRefused(Run({"-o", ""}), "--output: the file name is empty");
}

TEST_F(Bench, NumbersAreChecked) {
  const std::string report = folder_ / "r.html";
  ExpectRefused(Run({"-o", report, "--receivers", "0"}),
                "--receivers: '0' is not a whole number from 1 to 1000000");
  ExpectRefused(Run({"-o", report, "--seed", "-1"}),
                "--seed: '-1' is not a whole number from 0 to ");
  const Outcome outcome =
      RunTruelux({"bench", scene_, table_, "-o", report, "--seconds", "soon"});
  ExpectRefused(outcome, "--seconds: 'soon' is not a number from 0 upwards");
}

TEST(BenchHelp, ExplainsItselfAndIsListed) {
  const Outcome help = RunTruelux({"bench", "--help"});
  EXPECT_EQ(help.exit_status, 0);
  for (const char* part :
       {"Examples:\n", "--receivers", "REPORT_receivers.csv"})
    EXPECT_NE(help.out.find(part), std::string::npos) << help.out;
  EXPECT_NE(RunTruelux({"--help"}).out.find("bench"), std::string::npos);
}

}  // namespace
}  // namespace truelux::test
