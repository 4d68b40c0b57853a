// SPDX-License-Identifier: GPL-3.0-or-later
// The system fails once: one allocation, one write, one file, one thread. However
// a command ends, it says why, leaves no temporary file, and does not touch the
// output that was there, unless it has done its work.

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/program.h"

namespace truelux::test {
namespace {

/// A command in a folder that has "square.obj", "floor.obj", "in.csv" and
/// "values.csv".
struct FaultyCommand {
  std::string name;
  std::vector<std::string> words;  ///< @ stands for the folder
  /// Whether it starts some; nothing: if a library does.
  std::optional<bool> has_threads = false;
};

void PrintTo(const FaultyCommand& command, std::ostream* out) {
  *out << command.name;
}

constexpr const char* kOld = "what was there before\n";

/// How many lines are no notes.
int ErrorLines(const std::string& text) {
  int count = 0;
  for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1)
    count += text.compare(at, 6, "note: ") == 0 ? 0 : 1;
  return count;
}

/// One run with a fault.
struct FaultyRun {
  std::string fault;
  bool reached = false;  ///< whether there was such a call
  Outcome outcome;
};

class Faults : public testing::TestWithParam<FaultyCommand> {
 protected:
  Faults() {
    // The loader takes a blank in a path as the end of it.
    std::filesystem::copy_file(TRUELUX_FAIL_ONCE, library_);
    const std::string scene = WriteSquare(folder_);
    (void)folder_.Write("in.csv", Table(40));
    (void)folder_.Write("floor.obj",
                        std::string(kSquareObj) +
                            "v -2 -2 0\nv 2 -2 0\nv 2 2 0\nv -2 2 0\n"
                            "usemtl dark\no floor\nf 5 6 7 8\n");
    (void)folder_.Write("square.mtl",
                        std::string(kSquareMtl) + "newmtl dark\nKe 0 0 0\n");
    (void)folder_.Write("values.csv",
                        RunTruelux({"eval", scene, folder_ / "in.csv"}).out);
  }

  FaultyRun Run(const std::string& fault, int n) {
    (void)folder_.Write("out", kOld);
    (void)folder_.Write("out.csv", kOld);
    std::vector<std::string> words;
    for (std::string word : GetParam().words) {
      const std::size_t at = word.find('@');
      if (at != word.npos) word.replace(at, 1, folder_ / "");
      words.push_back(word);
    }
    const std::string mark = folder_ / "mark";
    std::remove(mark.c_str());
    setenv("TRUELUX_FAULT", (fault + ":" + std::to_string(n)).c_str(), 1);
    setenv("TRUELUX_FAULT_MARK", mark.c_str(), 1);
    setenv("LD_PRELOAD", library_.c_str(), 1);
    FaultyRun run;
    run.fault = fault;
    run.outcome = RunTruelux(words);
    for (const char* name :
         {"TRUELUX_FAULT", "TRUELUX_FAULT_MARK", "LD_PRELOAD"})
      unsetenv(name);
    const std::vector<std::string> names = folder_.Names();
    run.reached = std::ranges::find(names, "mark") != names.end();
    return run;
  }

  void ExpectCleanEnd(const FaultyRun& run) {
    const int status = run.outcome.exit_status;
    EXPECT_TRUE(status == 0 || status == 2 || status == 3) << run.outcome.err;
    for (const std::string& name : folder_.Names())
      EXPECT_EQ(name.find(".tmp"), std::string::npos) << name;
    // What --resume keeps would be gone on with.
    std::filesystem::remove(folder_ / "out.png.part");
    if (status == 0) return;
    EXPECT_NE(run.outcome.err, "");
    EXPECT_EQ(ErrorLines(run.outcome.err), 1) << run.outcome.err;
    // Of two outputs the first has its name when that of the second fails.
    if (run.fault == "rename") return;
    EXPECT_EQ(ReadFile(folder_ / "out"), kOld);
    EXPECT_EQ(ReadFile(folder_ / "out.csv"), kOld);
  }

  TemporaryFolder folder_;
  std::string library_ = folder_ / "fail_once.so";
};

/// How often a command met a fault, and how it ended.
struct Tally {
  int reached = 0;
  std::array<int, 4> by_status{};
};

TEST_P(Faults, EveryCallMayFailOnce) {
  for (const char* fault : {"write", "open", "rename", "close", "thread"}) {
    Tally tally;
    for (int n = 1; n < 1000; ++n) {
      SCOPED_TRACE(fault + std::string(" ") + std::to_string(n));
      const FaultyRun run = Run(fault, n);
      if (!run.reached) break;
      ++tally.reached;
      ExpectCleanEnd(run);
      if (HasFailure()) return;
    }
    const bool is_thread = fault == std::string("thread");
    const std::optional<bool> is_expected =
        is_thread ? GetParam().has_threads : true;
    if (is_expected) {
      EXPECT_EQ(tally.reached > 0, *is_expected) << fault;
    }
  }
}

// The first 40 allocations, then some of the others.
TEST_P(Faults, AnyAllocationMayFail) {
  Tally tally;
  for (int n = 1;; n += n < 40 ? 1 : 1 + n / 7) {
    SCOPED_TRACE(n);
    const FaultyRun run = Run("allocate", n);
    if (!run.reached) break;
    ++tally.reached;
    ExpectCleanEnd(run);
    if (HasFailure()) return;
    ++tally.by_status[static_cast<std::size_t>(run.outcome.exit_status)];
  }
  EXPECT_GT(tally.reached, 50);
  // Nearly all are needed.
  EXPECT_GT(tally.by_status[3], tally.reached / 2);
}

INSTANTIATE_TEST_SUITE_P(
    Commands, Faults,
    testing::Values(
        FaultyCommand{"Eval",
                      {"eval", "@square.obj", "@in.csv", "-o", "@out.csv",
                       "--stats", "@out", "--threads", "3"},
                      true},
        FaultyCommand{"EvalArrangement",
                      {"eval", "@square.obj", "@in.csv", "-o", "@out.csv",
                       "--engine", "arrangement", "--threads", "1"}},
        FaultyCommand{"Compare",
                      {"compare", "@square.obj", "@values.csv", "-o", "@out",
                       "--threads", "2"},
                      true},
        FaultyCommand{"Inspect",
                      {"inspect", "@square.obj", "--at", "0,0,0", "--normal",
                       "0,0,1", "-o", "@out"}},
        FaultyCommand{
            "Render",
            {"render", "@square.obj", "--eye", "0,0,-3", "--target", "0,0,1",
             "--up", "0,1,0", "--fov", "60", "--size", "8", "--values",
             "@out.csv", "-o", "@out.png", "--threads", "2"},
            true},
        FaultyCommand{
            "RenderResumed",
            {"render", "@square.obj", "--eye", "0,0,-3", "--target", "0,0,1",
             "--up", "0,1,0", "--fov", "60", "--size", "20", "--values",
             "@out.csv", "-o", "@out.png", "--threads", "2", "--resume"},
            true},
        FaultyCommand{"Gradient",
                      {"gradient", "@square.obj", "@in.csv", "-o", "@out.csv",
                       "--vertices", "@out", "--threads", "2"},
                      true},
        FaultyCommand{"Isolux",
                      {"isolux", "@floor.obj", "--surface", "floor", "--count",
                       "1", "--chord", "0.5", "--smallest", "0.5", "-o",
                       "@out.csv", "--lines", "@out", "--threads", "2"},
                      true},
        FaultyCommand{
            "IsoMesh",
            {"isolux", "@floor.obj", "--surface", "floor", "--count", "1",
             "--chord", "0.5", "--smallest", "0.5", "--mesh-smallest", "1",
             "-o", "@out.vtu", "--threads", "2"},
            true},
        FaultyCommand{"Bench",
                      {"bench", "@square.obj", "@in.csv", "-o", "@out.html",
                       "--quick", "--seconds", "1e-9", "--receivers", "1"},
                      std::nullopt},
        FaultyCommand{"Stability",
                      {"stability", "--cases", "1", "--only", "sliver", "--csv",
                       "@out.csv"}}),
    [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace truelux::test
