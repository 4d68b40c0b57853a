// SPDX-License-Identifier: GPL-3.0-or-later
// truelux eval --resume: stopped at any moment, even in the middle of a write,
// the same command ends with the bytes of a run that nobody stopped.

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>
#include <sys/stat.h>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "cli/program.h"

namespace truelux::test {
namespace {

namespace fs = std::filesystem;

bool Contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

class Resume : public testing::Test {
 protected:
  [[nodiscard]] Outcome Run(const std::vector<std::string>& more = {},
                            const Surroundings& around = {}) const {
    std::vector<std::string> words = {"eval", scene_,  table_,
                                      "-o",   output_, "--resume"};
    words.insert(words.end(), more.begin(), more.end());
    return RunTruelux(words, around);
  }

  /// Stops a run by a signal when the part has grown to some size.
  Outcome StopAt(std::uintmax_t size, int signal) {
    Surroundings around;
    around.watch = [this, size, signal](pid_t pid) {
      std::error_code error;
      if (fs::file_size(part_, error) < size || error) return false;
      kill(pid, signal);
      return true;
    };
    return Run({}, around);
  }

  static constexpr int kRows = 100000;

  TemporaryFolder folder_;
  std::string scene_ = WriteSquare(folder_);
  std::string table_ = folder_.Write("in.csv", Table(kRows));
  std::string output_ = folder_ / "out.csv";
  std::string part_ = folder_ / "out.csv.part";
  std::string whole_ = RunTruelux({"eval", scene_, table_}).out;
};

TEST_F(Resume, AWholeRunLeavesNoPart) {
  const Outcome outcome = Run();
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(ReadFile(output_), whole_);
  EXPECT_FALSE(fs::exists(part_));
}

TEST_F(Resume, InterruptedAndKilledItEndsWithTheSameBytes) {
  std::uintmax_t size = 100000;
  int stopped = 0;
  for (const int signal : {SIGINT, SIGKILL, SIGTERM, SIGKILL}) {
    const Outcome outcome = StopAt(size, signal);
    if (outcome.exit_status == 0) break;
    ++stopped;
    EXPECT_FALSE(fs::exists(output_));
    ASSERT_TRUE(fs::exists(part_));
    if (signal != SIGKILL) {
      EXPECT_EQ(outcome.exit_status, 130);
      EXPECT_TRUE(Contains(outcome.err, "out.csv.part keeps "));
      EXPECT_TRUE(Contains(outcome.err, "the same command goes on\n"));
    }
    size = fs::file_size(part_) + 100000;
  }
  EXPECT_GT(stopped, 1);
  const Outcome outcome = Run({"--threads", "3"});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_TRUE(Contains(outcome.err, " of 100000 receivers already\n"));
  EXPECT_EQ(ReadFile(output_), whole_);
  EXPECT_FALSE(fs::exists(part_));
}

// What a power cut leaves: a part cut anywhere, or with rubbish at its end.
TEST_F(Resume, ADamagedTailIsDoneAgain) {
  ASSERT_NE(StopAt(200000, SIGKILL).exit_status, 0);
  const std::string part = ReadFile(part_);
  ASSERT_GT(part.size(), 100000U);
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{5}, std::size_t{40}, std::size_t{60},
        std::size_t{70000}, part.size() - 1}) {
    for (const bool has_rubbish : {false, true}) {
      std::string damaged = part.substr(0, size);
      if (has_rubbish) damaged += std::string(5000, '\0');
      if (has_rubbish && size < 40) continue;  // that is no part at all
      (void)folder_.Write("out.csv.part", damaged);
      const Outcome outcome = Run();
      EXPECT_EQ(outcome.exit_status, 0) << size << outcome.err;
      EXPECT_EQ(ReadFile(output_), whole_) << size;
      fs::remove(output_);
    }
  }
  // A bit in the middle: all before it is kept.
  std::string damaged = part;
  damaged[damaged.size() / 2] ^= 1;
  (void)folder_.Write("out.csv.part", damaged);
  EXPECT_EQ(Run().exit_status, 0);
  EXPECT_EQ(ReadFile(output_), whole_);
}

TEST_F(Resume, AnotherSceneOrOptionIsRefused) {
  ASSERT_NE(StopAt(100000, SIGKILL).exit_status, 0);
  const std::string part = ReadFile(part_);
  const auto expect_refused = [&](const Outcome& outcome) {
    EXPECT_EQ(outcome.exit_status, 2);
    EXPECT_TRUE(Contains(outcome.err, "out.csv.part: error: is of another"))
        << outcome.err;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
    EXPECT_EQ(ReadFile(part_), part);
    EXPECT_FALSE(fs::exists(output_));
  };
  expect_refused(Run({"--method", "double"}));
  expect_refused(Run({"--emission", "radiance"}));
  expect_refused(Run({"--two-sided"}));
  expect_refused(Run({"--on-face", "auto"}));
  std::ofstream(table_, std::ios::app) << "0,0,0,0,0,1\n";
  expect_refused(Run());
  (void)folder_.Write("in.csv", Table(kRows));
  (void)folder_.Write("square.mtl", "newmtl light\nKe 1 2 1\n");
  expect_refused(Run());
  (void)folder_.Write("square.mtl", kSquareMtl);
  EXPECT_EQ(Run().exit_status, 0);
  EXPECT_EQ(ReadFile(output_), whole_);
}

TEST_F(Resume, WhatIsNoPartIsNotTouched) {
  for (const std::string& notes :
       {std::string("my notes\n"), std::string("without an end"),
        std::string(5000, 'P'), std::string("true")}) {
    (void)folder_.Write("out.csv.part", notes);
    const Outcome outcome = Run();
    if (notes == "true") {  // what the head begins with
      EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
      continue;
    }
    EXPECT_EQ(outcome.exit_status, 2);
    EXPECT_TRUE(Contains(outcome.err, "is no part of an output"));
    EXPECT_EQ(ReadFile(part_), notes);
  }
}

// What cannot be read again cannot be gone on with.
TEST_F(Resume, PipesAreRefused) {
  const std::string pipe = folder_ / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const Outcome table =
      RunTruelux({"eval", scene_, pipe, "-o", output_, "--resume"});
  EXPECT_EQ(table.exit_status, 2);
  EXPECT_TRUE(Contains(table.err, "--resume needs a table")) << table.err;
  std::thread writer([&] { std::ofstream(pipe) << kSquareObj; });
  const Outcome scene = RunTruelux(
      {"eval", pipe, table_, "-o", output_, "--resume", "--lenient"});
  writer.join();
  EXPECT_EQ(scene.exit_status, 2);
  EXPECT_TRUE(Contains(scene.err, "--resume needs a scene")) << scene.err;
  EXPECT_FALSE(fs::exists(part_) || fs::exists(output_));
}

TEST_F(Resume, NeedsFiles) {
  const auto expect_usage = [](const std::vector<std::string>& words,
                               const char* what) {
    const Outcome outcome = RunTruelux(words);
    EXPECT_EQ(outcome.exit_status, 2);
    EXPECT_TRUE(Contains(outcome.err, what)) << outcome.err;
  };
  expect_usage({"eval", scene_, table_, "--resume"}, "--resume needs --output");
  expect_usage({"eval", scene_, "-", "-o", output_, "--resume"},
               "--resume needs a table");
  expect_usage({"eval", scene_, table_, "-o", output_, "--resume", "--stats",
                folder_ / "s.json"},
               "not with --resume");
  expect_usage({"eval", scene_, part_, "-o", output_, "--resume"}, "error: ");
}

// The notes at the end are about all rows, whichever run evaluated them.
TEST_F(Resume, NotesCountAllRows) {
  std::string table(kHeader);
  for (int i = 0; i < kRows; ++i)
    table += i == 5 ? "0,0,0,0,0,1\n" : "0,0,0,0,0,-1\n";
  (void)folder_.Write("in.csv", table);
  ASSERT_NE(StopAt(100000, SIGKILL).exit_status, 0);
  const Outcome outcome = Run();
  EXPECT_EQ(outcome.exit_status, 0);
  EXPECT_FALSE(Contains(outcome.err, "everything is 0")) << outcome.err;
}

TEST_F(Resume, WithoutItNothingIsKept) {
  Surroundings around;
  around.watch = [&](pid_t pid) {
    for (const std::string& name : folder_.Names()) {
      if (!name.ends_with(".tmp") || ReadFile(folder_ / name).empty()) continue;
      kill(pid, SIGINT);
      return true;
    }
    return false;
  };
  const std::string large = folder_.Write("large.csv", Table(1000000));
  const Outcome outcome =
      RunTruelux({"eval", scene_, large, "-o", output_}, around);
  EXPECT_EQ(outcome.exit_status, 130);
  EXPECT_EQ(outcome.err,
            "note: nothing was kept; --resume keeps what is done\n"
            "interrupted\n");
  EXPECT_FALSE(fs::exists(output_));
}

}  // namespace
}  // namespace truelux::test
