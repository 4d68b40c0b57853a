// SPDX-License-Identifier: GPL-3.0-or-later
// truelux render from outside: which pixel is where, what files hold, and what
// is refused.

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "cli/program.h"

namespace truelux::test {
namespace {

/// The lines of a table, as texts between commas.
std::vector<std::vector<std::string>> RowsOf(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');)
      rows.back().push_back(field);
  }
  return rows;
}

/// E_r,E_g,E_b (and what follows) by pixel.
using PixelTexts = std::map<std::pair<int, int>, std::vector<std::string>>;

PixelTexts ReadValues(const std::string& path) {
  PixelTexts texts;
  auto rows = RowsOf(ReadFile(path));
  for (std::size_t i = 1; i < rows.size(); ++i) {
    texts[{std::atoi(rows[i][0].c_str()), std::atoi(rows[i][1].c_str())}] = {
        rows[i].begin() + 2, rows[i].end()};
  }
  return texts;
}

/// A floor that is an L, a lamp above one side of it, and a blocker.
constexpr const char* kRoomObj =
    "mtllib room.mtl\n"
    "o floor\nv 0 0 0\nv 4 0 0\nv 4 1 0\nv 1 1 0\nv 1 4 0\nv 0 4 0\n"
    "f 1 2 3 4 5 6\n"
    "o lamp\nusemtl lamp\nv 0 0 2\nv 0 1 2\nv 1 1 2\nv 1 0 2\nf 7 8 9 10\n"
    "o screen\nusemtl black\nv 0.5 0 1\nv 2 0 1\nv 2 2 1.5\nv 0.5 2 1.5\n"
    "f 11 12 13 14\n"
    "o bent\nv 9 9 9\nv 10 9 9\nv 10 10 9\nf 15 16 17\n"
    "v 9 9 8\nv 10 9 8.5\nv 10 10 8\nf 18 19 20\n";
constexpr const char* kRoomMtl =
    "newmtl lamp\nKe 3 2 1\nnewmtl black\nKd 0 0 0\n";

class Render : public testing::Test {
 protected:
  Render() { folder_.Write("room.mtl", kRoomMtl); }

  [[nodiscard]] Outcome Run(std::vector<std::string> more,
                            const Surroundings& around = {}) const {
    more.insert(more.begin(), {"render", scene_});
    return RunTruelux(more, around);
  }

  /// Exit status 2, the message in one line, and nothing written.
  void ExpectRefused(std::vector<std::string> more,
                     const std::string& message) const {
    const Outcome outcome = Run(std::move(more));
    EXPECT_EQ(outcome.exit_status, 2);
    EXPECT_EQ(std::ranges::count(outcome.err, '\n') -
                  (outcome.err.find("Usage:") == std::string::npos ? 0 : 2),
              1)
        << outcome.err;
    EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
    EXPECT_EQ(folder_.Names(),
              (std::vector<std::string>{"room.mtl", "room.obj"}));
  }

  [[nodiscard]] std::string Path(const char* name) const {
    return folder_ / name;
  }

  TemporaryFolder folder_;
  std::string scene_ = folder_.Write("room.obj", kRoomObj);
};

const std::vector<std::string> kCamera = {
    "--eye", "1.3,0.4,9", "--target", "2,2,0", "--up", "0,1,0", "--fov", "40"};

std::vector<std::string> With(std::vector<std::string> first,
                              const std::vector<std::string>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

TEST_F(Render, EveryPixelIsRepeatedByEvalBitForBit) {
  for (const std::vector<std::string>& view :
       {std::vector<std::string>{"--surface", "floor"}, kCamera}) {
    for (const char* method : {"certified", "double"}) {
      const Outcome outcome =
          Run(With(view, {"--size", "37x23", "-o", Path("a.exr"), "--values",
                          Path("v.csv"), "--receivers-out", Path("r.csv"),
                          "--method", method}));
      ASSERT_EQ(outcome.exit_status, 0) << outcome.err;
      const Outcome eval =
          RunTruelux({"eval", scene_, Path("r.csv"), "--method", method});
      ASSERT_EQ(eval.exit_status, 0) << eval.err;
      const auto repeated = RowsOf(eval.out);
      const auto rows = RowsOf(ReadFile(Path("v.csv")));
      ASSERT_EQ(rows.size(), repeated.size());
      ASSERT_GT(rows.size(), 100U);
      for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::vector<std::string> end(repeated[i].begin() + 7,
                                           repeated[i].end());
        ASSERT_EQ(rows[i], end) << i;
      }
      EXPECT_EQ(rows[0].size(), method == std::string("double") ? 8U : 5U);
    }
  }
}

TEST_F(Render, PixelsAreWhereTheHelpSays) {
  ASSERT_EQ(Run({"--surface", "floor", "--size", "4x4", "-o", Path("a.png"),
                 "--white", "1", "--values", Path("v.csv")})
                .exit_status,
            0);
  const PixelTexts values = ReadValues(Path("v.csv"));
  EXPECT_EQ(values.size(), 7U);  // an L of seven squares
  const auto eval = [this](const std::string& at) {
    const auto rows = RowsOf(RunTruelux({"eval", scene_, "--at", at, "--normal",
                                         "0,0,1", "--on-face", "1"})
                                 .out);
    return std::vector<std::string>(rows[1].begin() + 7, rows[1].end());
  };
  EXPECT_EQ(values.at({0, 0}), eval("0.5,3.5,0"));
  EXPECT_EQ(values.at({0, 3}), eval("0.5,0.5,0"));
  EXPECT_EQ(values.at({3, 3}), eval("3.5,0.5,0"));
  EXPECT_NE(values.at({0, 0}), values.at({3, 3}));
  EXPECT_FALSE(values.contains({3, 0}));
}

TEST_F(Render, ThreadsChangeNoByte) {
  std::vector<std::string> first;
  for (const char* threads : {"1", "2", "7"}) {
    ASSERT_EQ(Run(With(kCamera, {"--size", "61x43", "-o", Path("a.png"),
                                 "--false-colour", "--also", "error", "--also",
                                 "arcs", "--also", "class", "--values",
                                 Path("v.csv"), "--threads", threads}))
                  .exit_status,
              0);
    std::vector<std::string> bytes;
    for (const char* name :
         {"a.png", "a_error.png", "a_arcs.png", "a_class.png", "v.csv"})
      bytes.push_back(ReadFile(Path(name)));
    if (first.empty()) first = bytes;
    EXPECT_EQ(bytes, first) << threads;
  }
}

TEST_F(Render, ThreadsChangeNoByteOfKinkLines) {
  std::vector<std::string> pictures;
  for (const char* threads : {"1", "5"}) {
    ASSERT_EQ(Run({"--surface", "floor", "--size", "40", "-o", Path("a.png"),
                   "--also", "gradient", "--threads", threads})
                  .exit_status,
              0);
    pictures.push_back(ReadFile(Path("a_gradient.png")));
  }
  EXPECT_FALSE(pictures[0].empty());
  EXPECT_EQ(pictures[0], pictures[1]);
}

TEST_F(Render, AUniformSkyGivesTheSameEverywhere) {
  // A closed box of side 20 that shines inwards: E = M at any receiver.
  folder_.Write("room.mtl", "newmtl sky\nKe 1 0.25 0.1\nnewmtl b\nKd 1 1 1\n");
  std::string obj =
      "mtllib room.mtl\no floor\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\n"
      "v -1 1 0\nf 1 2 3 4\no sky\nusemtl sky\n";
  obj +=
      "v -10 -10 -10\nv 10 -10 -10\nv 10 10 -10\nv -10 10 -10\n"
      "v -10 -10 10\nv 10 -10 10\nv 10 10 10\nv -10 10 10\n"
      "f 5 6 7 8\nf 12 11 10 9\nf 5 9 10 6\nf 6 10 11 7\nf 7 11 12 8\n"
      "f 8 12 9 5\n";
  folder_.Write("room.obj", obj);
  ASSERT_EQ(Run({"--surface", "floor", "--size", "9", "-o", Path("a.exr"),
                 "--values", Path("v.csv")})
                .exit_status,
            0);
  const PixelTexts values = ReadValues(Path("v.csv"));
  EXPECT_EQ(values.size(), 81U);
  for (const auto& [pixel, texts] : values)
    EXPECT_EQ(texts, (std::vector<std::string>{"1", "0.25", "0.1"}));
}

TEST_F(Render, NotesWhatIsShownAndAnEmptyPictureIsTransparent) {
  Outcome outcome =
      Run({"--surface", "floor", "--size", "8", "-o", Path("a.png")});
  EXPECT_EQ(outcome.exit_status, 0);
  EXPECT_EQ(outcome.err.find("note: white is "), 0U) << outcome.err;
  outcome = Run({"--eye", "0,0,50", "--target", "0,0,60", "--up", "0,1,0",
                 "--fov", "40", "-o", Path("a.exr"), "--values", Path("v.csv"),
                 "--size", "16"});
  EXPECT_EQ(outcome.exit_status, 0);
  EXPECT_EQ(ReadFile(Path("v.csv")), "px,py,E_r,E_g,E_b\n");
}

TEST_F(Render, ViewsThatDoNotExist) {
  const std::vector<std::string> out = {"-o", Path("a.png")};
  ExpectRefused(With(out, {"--surface", "roof"}),
                "--surface: no object or group 'roof'; there are 'floor', "
                "'lamp', 'screen', 'bent'");
  ExpectRefused(With(out, {"--surface", "bent"}),
                "--surface: 'bent' is no flat surface: face 5 (line 32, bent) "
                "is not exactly in the plane of face 4 (line 28, bent)");
  ExpectRefused(out, "either --surface, or a camera");
  ExpectRefused(With(With(out, kCamera), {"--surface", "floor"}),
                "either --surface, or a camera");
  ExpectRefused(With(out, {"--eye", "0,0,1", "--up", "0,1,0", "--fov", "40"}),
                "--target is missing");
  const auto camera = [&](const char* eye, const char* up, const char* fov) {
    return With(out,
                {"--eye", eye, "--target", "0,0,1", "--up", up, "--fov", fov});
  };
  ExpectRefused(camera("0,0,1", "0,1,0", "40"), "are the same point");
  ExpectRefused(camera("0,0,0", "0,0,-2", "40"), "parallel");
  ExpectRefused(camera("0,0,0", "0,0,0", "40"), "the up vector is zero");
  ExpectRefused(camera("0,0,0", "0,1,0", "180"), "between 0 and 180 degrees");
  ExpectRefused(camera("0,0,0", "0,1,0", "wide"),
                "--fov: 'wide' is not a number");
  ExpectRefused(camera("0,0", "0,1,0", "40"), "--eye: ");
}

TEST_F(Render, OptionsThatDoNotFit) {
  const std::vector<std::string> floor = {"--surface", "floor"};
  const auto with = [&](const std::vector<std::string>& more) {
    return With(floor, more);
  };
  ExpectRefused(with({"-o", Path("a.jpg")}), "ends with neither .exr nor .png");
  ExpectRefused(with({"-o", "-"}), "ends with neither .exr nor .png");
  ExpectRefused(floor, "--output is required");
  const std::string png = Path("a.png");
  for (const char* size : {"0", "12x", "x5", "1.5x3", "3x4x5", "-3", "99999"})
    ExpectRefused(with({"-o", png, "--size", size}), "--size: '");
  ExpectRefused(with({"-o", png, "--size", "16384x16384"}),
                "--size: 16384 x 16384 are more than 67108864 pixels");
  ExpectRefused(with({"-o", png, "--white", "0"}),
                "--white: '0' is not a positive number");
  ExpectRefused(with({"-o", png, "--white", "1", "--exposure", "0"}),
                "--exposure and --white say the same");
  ExpectRefused(with({"-o", png, "--exposure", "bright"}),
                "--exposure: 'bright' is not a number");
  ExpectRefused(with({"-o", Path("a.exr"), "--false-colour"}),
                "belong to a PNG");
  ExpectRefused(with({"-o", png, "--channel", "r"}), "--channel belongs to");
  ExpectRefused(with({"-o", png, "--no-isolux"}), "--no-isolux belongs to");
  ExpectRefused(with({"-o", png, "--also", "depth"}), "--also");
  ExpectRefused(with({"-o", png, "--threads", "0"}), "--threads: '0'");
}

TEST_F(Render, OutputsDoNotCollideOrReplaceInputs) {
  const std::string clash = Path("a_class.png");
  ExpectRefused({"--surface", "floor", "-o", Path("a.png"), "--values", clash,
                 "--also", "class"},
                "--also class and --values are the same file");
  ExpectRefused(
      {"--surface", "floor", "-o", Path("a.png"), "--values", Path("room.mtl")},
      "is also the input");
  ExpectRefused({"--surface", "floor", "-o", Path("none/a.png")},
                "cannot write");
}

TEST_F(Render, AnInterruptionLeavesNothing) {
  Surroundings around;
  const auto start = std::chrono::steady_clock::now();
  around.watch = [start](pid_t pid) {
    if (std::chrono::steady_clock::now() - start <
        std::chrono::milliseconds(500))
      return false;
    kill(pid, SIGINT);
    return true;
  };
  // An hour of work.
  const Outcome outcome = Run(
      {"--surface", "floor", "--size", "2000x2000", "-o", Path("a.exr"),
       "--also", "arcs", "--engine", "arrangement", "--values", Path("v.csv")},
      around);
  EXPECT_EQ(outcome.exit_status, 130);
  // A slow receiver may not hear in time: then the end comes without the note.
  const std::string note =
      "note: nothing was kept; --resume keeps what is done\n";
  EXPECT_TRUE(outcome.err == note + "interrupted\n" ||
              outcome.err == "interrupted\n")
      << outcome.err;
  EXPECT_EQ(folder_.Names(),
            (std::vector<std::string>{"room.mtl", "room.obj"}));
}

TEST(RenderHelp, SaysWhatFilesHold) {
  const Outcome help = RunTruelux({"render", "--help"});
  EXPECT_EQ(help.exit_status, 0);
  for (const char* part :
       {"Examples:\n", "rounded\nonce more", "--receivers-out", "--also",
        "lines where the gradient jumps"})
    EXPECT_NE(help.out.find(part), std::string::npos) << help.out;
}

}  // namespace
}  // namespace truelux::test
