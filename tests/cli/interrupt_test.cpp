// SPDX-License-Identifier: GPL-3.0-or-later
// Stopping truelux eval: by signals, whatever it waits for.

#include <algorithm>
#include <chrono>
#include <csignal>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/program.h"

namespace truelux::test {
namespace {

/// Sends a signal once, as soon as `ready`.
std::function<bool(pid_t)> SignalWhen(int signal, std::function<bool()> ready) {
  return [signal, ready = std::move(ready)](pid_t pid) {
    if (!ready()) return false;
    kill(pid, signal);
    return true;
  };
}

std::function<bool()> After(std::chrono::milliseconds time) {
  const auto end = std::chrono::steady_clock::now() + time;
  return [end] { return std::chrono::steady_clock::now() > end; };
}

/// Whether rows are being written: the output's temporary file has content.
std::function<bool()> Writing(const TemporaryFolder& folder) {
  return [&folder] {
    const std::vector<std::string> names = folder.Names();
    return std::any_of(
        names.begin(), names.end(), [&folder](const std::string& name) {
          return name.ends_with(".tmp") && !ReadFile(folder / name).empty();
        });
  };
}

class Interrupt : public testing::TestWithParam<int> {};

TEST_P(Interrupt, WhileWaitingForInputLeavesNoFile) {
  const TemporaryFolder folder;
  const std::string scene = WriteSquare(folder);
  Surroundings around;
  around.input = Table(10);
  around.keep_input_open = true;
  around.watch = SignalWhen(GetParam(), Writing(folder));
  const Outcome outcome =
      RunTruelux({"eval", scene, "-", "-o", folder / "out.csv", "--stats",
                  folder / "stats.json"},
                 around);
  EXPECT_EQ(outcome.exit_status, 130);
  EXPECT_EQ(outcome.err,
            "note: nothing was kept; --resume keeps what is done\n"
            "interrupted\n");
  EXPECT_EQ(folder.Names(),
            (std::vector<std::string>{"square.mtl", "square.obj"}));
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupt,
                         testing::Values(SIGINT, SIGTERM, SIGHUP));

TEST(Interruption, WhileEvaluatingLeavesNoFile) {
  const TemporaryFolder folder;
  const std::string scene = WriteSquare(folder);
  const std::string table = folder.Write("in.csv", Table(300000));
  Surroundings around;
  around.watch = SignalWhen(SIGINT, Writing(folder));
  const Outcome outcome =
      RunTruelux({"eval", scene, table, "-o", folder / "out.csv"}, around);
  EXPECT_EQ(outcome.exit_status, 130);
  EXPECT_EQ(outcome.err,
            "note: nothing was kept; --resume keeps what is done\n"
            "interrupted\n");
  EXPECT_EQ(folder.Names(),
            (std::vector<std::string>{"in.csv", "square.mtl", "square.obj"}));
}

TEST(Interruption, WhileNobodyReadsTheOutput) {
  const TemporaryFolder folder;
  const std::string scene = WriteSquare(folder);
  const std::string table = folder.Write("in.csv", Table(20000));
  Surroundings around;
  around.ignore_output = true;  // far more than a pipe holds
  around.watch = SignalWhen(SIGINT, After(std::chrono::milliseconds(700)));
  const Outcome outcome = RunTruelux({"eval", scene, table}, around);
  EXPECT_EQ(outcome.exit_status, 130);
}

TEST(Conversation, RowsAreAnsweredWhileStandardInputStaysOpen) {
  const TemporaryFolder folder;
  const std::string scene = WriteSquare(folder);
  Surroundings around;
  around.input = Table(2);
  around.keep_input_open = true;
  around.watch = SignalWhen(SIGINT, After(std::chrono::milliseconds(700)));
  const Outcome outcome =
      RunTruelux({"eval", scene, "-", "--threads", "1"}, around);
  EXPECT_EQ(outcome.exit_status, 130);
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 3);
}

TEST(Progress, IsShownOnATerminalAfterTwoSecondsAndCleared) {
  const TemporaryFolder folder;
  const std::string scene = WriteSquare(folder);
  Surroundings around;
  around.input = Table(4);
  around.keep_input_open = true;
  around.terminal = true;
  around.watch = SignalWhen(SIGINT, After(std::chrono::milliseconds(3000)));
  const Outcome outcome = RunTruelux({"eval", scene, "-"}, around);
  EXPECT_EQ(outcome.exit_status, 130);
  EXPECT_NE(outcome.err.find("\r4 receivers, "), std::string::npos)
      << outcome.err;
  // A terminal turns a line feed into both.
  EXPECT_TRUE(outcome.err.ends_with(" \rinterrupted\r\n")) << outcome.err;
}

}  // namespace
}  // namespace truelux::test
