// SPDX-License-Identifier: GPL-3.0-or-later
// truelux render --resume: stopped at any moment, the same command ends with
// the bytes of a run that nobody stopped.

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "cli/program.h"

namespace truelux::test {
namespace {

namespace fs = std::filesystem;

bool Contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

class RenderResume : public testing::Test {
 protected:
  /// Every kind of raster is kept: values, bounds, differences, arcs, classes.
  [[nodiscard]] std::vector<std::string> Words(const std::string& name) const {
    return {"render",   scene_,   "--eye",    "0,0,4",
            "--target", "0,0,0",  "--up",     "0,1,0",
            "--fov",    "60",     "--size",   "250x190",
            "--method", "double", "--values", folder_ / (name + ".csv"),
            "--also",   "error",  "--also",   "arcs",
            "--also",   "class",  "-o",       folder_ / (name + ".png")};
  }

  [[nodiscard]] Outcome Run(const std::vector<std::string>& more = {},
                            const Surroundings& around = {}) const {
    std::vector<std::string> words = Words("out");
    words.emplace_back("--resume");
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
    return Run({"--threads", "1"}, around);
  }

  void ExpectSameFiles() {
    ASSERT_EQ(RunTruelux(Words("whole")).exit_status, 0);
    for (const char* ending :
         {".png", ".csv", "_error.png", "_arcs.png", "_class.png"}) {
      const std::string whole =
          ReadFile(folder_ / (std::string("whole") + ending));
      EXPECT_GT(whole.size(), 100U) << ending;
      EXPECT_TRUE(ReadFile(folder_ / (std::string("out") + ending)) == whole)
          << ending;
    }
  }

  TemporaryFolder folder_;
  // The camera sees the back of the lamp, and the floor that it shines on.
  std::string scene_ = [this] {
    (void)folder_.Write("square.mtl",
                        std::string(kSquareMtl) + "newmtl dark\n");
    return folder_.Write("scene.obj",
                         std::string(kSquareObj) +
                             "v -9 -9 0\nv 9 -9 0\nv 9 9 0\nv -9 9 0\n"
                             "usemtl dark\nf 5 6 7 8\n");
  }();
  std::string part_ = folder_ / "out.png.part";
};

TEST_F(RenderResume, AWholeRunLeavesNoPart) {
  const Outcome outcome = Run();
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_FALSE(fs::exists(part_));
  ExpectSameFiles();
}

TEST_F(RenderResume, InterruptedAndKilledItEndsWithTheSameBytes) {
  std::uintmax_t size = 150000;
  int stopped = 0;
  for (const int signal : {SIGINT, SIGKILL, SIGTERM, SIGKILL}) {
    const Outcome outcome = StopAt(size, signal);
    if (outcome.exit_status == 0) break;
    ++stopped;
    EXPECT_FALSE(fs::exists(folder_ / "out.png"));
    ASSERT_TRUE(fs::exists(part_));
    if (signal != SIGKILL) {
      EXPECT_EQ(outcome.exit_status, 130);
      EXPECT_TRUE(Contains(outcome.err, "out.png.part keeps ")) << outcome.err;
      EXPECT_TRUE(Contains(outcome.err, "the same command goes on\n"));
    }
    size = fs::file_size(part_) + 150000;
  }
  EXPECT_GT(stopped, 1);
  const Outcome outcome = Run({"--threads", "3"});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_TRUE(Contains(outcome.err, " of 47500 pixels already\n"))
      << outcome.err;
  EXPECT_FALSE(fs::exists(part_));
  ExpectSameFiles();
}

TEST_F(RenderResume, ADamagedTailIsDoneAgain) {
  ASSERT_NE(StopAt(150000, SIGKILL).exit_status, 0);
  const std::string part = ReadFile(part_);
  (void)folder_.Write("out.png.part",
                      part.substr(0, part.size() - 1) + std::string(99, '\0'));
  EXPECT_EQ(Run().exit_status, 0);
  ExpectSameFiles();
}

TEST_F(RenderResume, OtherPixelsAreRefused) {
  ASSERT_NE(StopAt(100000, SIGKILL).exit_status, 0);
  const std::string part = ReadFile(part_);
  const std::vector<std::vector<std::string>> others = {
      {"--two-sided"}, {"--on-face", "1"}, {"--opaque-from", "0.5"}};
  for (const std::vector<std::string>& more : others) {
    const Outcome outcome = Run(more);
    EXPECT_EQ(outcome.exit_status, 2) << more[0];
    EXPECT_TRUE(Contains(outcome.err, "out.png.part: error: is of another"))
        << outcome.err;
    EXPECT_TRUE(ReadFile(part_) == part);
    EXPECT_FALSE(fs::exists(folder_ / "out.png"));
  }
  // How they are coloured is no matter.
  const Outcome outcome = Run({"--white", "0.5"});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_TRUE(Contains(outcome.err, " pixels already\n"));
}

TEST_F(RenderResume, WithoutItNothingIsKept) {
  int looks = 0;
  Surroundings around;
  around.watch = [&looks](pid_t pid) {
    if (++looks < 100) return false;
    kill(pid, SIGINT);
    return true;
  };
  std::vector<std::string> words = Words("out");
  *std::ranges::find(words, "250x190") = "1600x1200";
  const Outcome outcome = RunTruelux(words, around);
  EXPECT_EQ(outcome.exit_status, 130);
  // A run that is ended within a pixel, on a slow computer, has no time for it.
  EXPECT_TRUE(
      Contains(outcome.err,
               "note: nothing was kept; --resume keeps what is done\n") ||
      outcome.err == "interrupted\n")
      << outcome.err;
  EXPECT_EQ(folder_.Names(),
            (std::vector<std::string>{"scene.obj", "square.mtl"}));
}

}  // namespace
}  // namespace truelux::test
