// SPDX-License-Identifier: GPL-3.0-or-later
// The command truelux stability.

#include <algorithm>
#include <chrono>
#include <csignal>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/program.h"

namespace truelux::test {
namespace {

std::vector<std::string> LinesOf(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

std::ptrdiff_t CountOf(const std::vector<std::string>& lines,
                       const std::string& start) {
  return std::count_if(
      lines.begin(), lines.end(),
      [&start](const std::string& line) { return line.starts_with(start); });
}

TEST(StabilityCommand, WritesOneTableForEachArithmetic) {
  const TemporaryFolder folder;
  const Outcome outcome = RunTruelux({"stability", "--cases", "2", "--only",
                                      "sliver", "--csv", folder / "all.csv"});
  EXPECT_EQ(outcome.exit_status, 0);
  EXPECT_EQ(outcome.err, "");
  const std::vector<std::string> lines = LinesOf(outcome.out);
  for (const char* title :
       {"# Stability", "## float", "## double", "## bounded double",
        "## double-double", "## MPFR 128", "## Time", "## Bounds"}) {
    EXPECT_EQ(std::count(lines.begin(), lines.end(), title), 1) << title;
  }
  EXPECT_EQ(CountOf(lines, "| sliver 0.5 x 5e-7 | 1, "), 5);
  EXPECT_EQ(CountOf(lines, "| sliver 2e-3 x 2e-9 | 1, "), 5);
  EXPECT_EQ(CountOf(lines, "| size"), 0);
  // Every row of a table has as many fields as its header.
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (!lines[i].starts_with("|") || !lines[i - 1].starts_with("|")) continue;
    const auto bars = [](const std::string& line) {
      return std::count(line.begin(), line.end(), '|');
    };
    EXPECT_EQ(bars(lines[i]), bars(lines[i - 1])) << lines[i];
  }
  // auto, and all 13 formulas but the series on the wide sliver, on 2 cases.
  EXPECT_EQ(CountOf(lines, "Bounds checked: 54, violations: 0"), 1);

  const std::vector<std::string> table = LinesOf(ReadFile(folder / "all.csv"));
  EXPECT_EQ(table.front(),
            "regime,occluded,arithmetic,formula,cases,not_applicable,median,"
            "max,median_ns,median_sources,median_arcs");
  // Five arithmetics, 12 and 13 formulas, and auto where it is measured.
  EXPECT_EQ(table.size(), 1U + 5U * 25U + 2U * 2U);
  EXPECT_EQ(CountOf(table, "sliver 2e-3 x 2e-9,0,MPFR 128,series,1,0,"), 1);
}

TEST(StabilityCommand, ASeedGivesTheSameErrors) {
  const auto errors = [](const std::string& seed) {
    const Outcome outcome = RunTruelux(
        {"stability", "--cases", "3", "--only", "pinhole", "--seed", seed});
    EXPECT_EQ(outcome.exit_status, 0);
    return outcome.out.substr(
        outcome.out.find("\n## "),
        outcome.out.find("\n## Time") - outcome.out.find("\n## "));
  };
  const std::string first = errors("5");
  EXPECT_EQ(first, errors("5"));
  EXPECT_NE(first, errors("6"));
}

TEST(StabilityCommand, HelpHasExamples) {
  const Outcome outcome = RunTruelux({"stability", "--help"});
  EXPECT_EQ(outcome.exit_status, 0);
  EXPECT_NE(outcome.out.find("Examples:\n  truelux stability"),
            std::string::npos);
  const Outcome all = RunTruelux({"--help"});
  EXPECT_NE(all.out.find("\n  stability "), std::string::npos);
}

TEST(StabilityCommand, BadOptionsExitWith2) {
  const TemporaryFolder folder;

  struct Case {
    std::vector<std::string> arguments;
    std::string message;
  };

  const std::vector<Case> cases = {
      {{"--cases", "0"}, "--cases: '0' is not a whole number from 1 to"},
      {{"--cases", "1.5"}, "--cases: '1.5' is not a whole number"},
      {{"--cases", "-3"}, "--cases: '-3' is not a whole number"},
      {{"--cases", "many"}, "--cases: 'many' is not a whole number"},
      {{"--cases", "99999999999999999999"}, "is not a whole number"},
      {{"--seed", "x"}, "--seed: 'x' is not a whole number"},
      {{"--only", "no such regime"}, "--only: no regime has 'no such regime'"},
      {{"--csv", ""}, "--csv: the file name is empty"},
      {{"--csv", "-"}, "--csv: the tables are written to standard output"},
      {{"--csv", folder / "none/all.csv"}, "cannot write"},
      {{"--polygons", "3"}, "--polygons"},
      {{"extra"}, "extra"}};
  for (const Case& c : cases) {
    std::vector<std::string> arguments = {"stability"};
    arguments.insert(arguments.end(), c.arguments.begin(), c.arguments.end());
    const Outcome outcome = RunTruelux(arguments);
    EXPECT_EQ(outcome.exit_status, 2) << c.message;
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find(c.message), std::string::npos) << outcome.err;
    EXPECT_TRUE(folder.Names().empty());
  }
}

TEST(StabilityCommand, AnInterruptionLeavesNoFile) {
  const TemporaryFolder folder;
  Surroundings around;
  around.terminal = true;
  const auto end =
      std::chrono::steady_clock::now() + std::chrono::milliseconds(3000);
  around.watch = [end](pid_t pid) {
    if (std::chrono::steady_clock::now() < end) return false;
    kill(pid, SIGINT);
    return true;
  };
  const Outcome outcome = RunTruelux(
      {"stability", "--cases", "100000", "--csv", folder / "all.csv"}, around);
  EXPECT_EQ(outcome.exit_status, 130);
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find(" of 6900000 cases, "), std::string::npos)
      << outcome.err;
  EXPECT_TRUE(folder.Names().empty());
}

}  // namespace
}  // namespace truelux::test
