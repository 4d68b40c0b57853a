// SPDX-License-Identifier: GPL-3.0-or-later
// Receivers that rounding has moved off their faces, in every command: a ramp
// with a lamp above it, and 4096 texels on the ramp, all in binary32.

#include <array>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "cli/program.h"

namespace truelux::test {
namespace {

constexpr int kSide = 64;

double Single(double x) {
  return static_cast<double>(static_cast<float>(x));
}

/// A point of the ramp, u and v from 0 to 1.
std::array<double, 3> OnRamp(double u, double v) {
  return {Single(6 * u * 0.9156 - 3), Single(6 * v - 3),
          Single(6 * u * 0.4021 - 1)};
}

std::string RampObj() {
  std::string text = "mtllib ramp.mtl\n";
  const std::array<std::array<int, 2>, 4> ends = {
      {{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  for (const auto& [u, v] : ends) {
    const auto [x, y, z] = OnRamp(u, v);
    text += fmt::format("v {} {} {}\n", x, y, z);
  }
  return text +
         "v -1 -1 4\nv -1 1 4\nv 1 1 4\nv 1 -1 4\n"
         "o ramp\nf 1 2 3 4\no lamp\nusemtl lamp\nf 5 6 7 8\n";
}

/// The texels; cells: what their column on_face says, if they have one.
std::string Texels(const std::string& cells = "", char separator = ',') {
  std::string text = "x,y,z,nx,ny,nz";
  if (!cells.empty()) text += ",on_face";
  text += '\n';
  for (int i = 0; i < kSide * kSide; ++i) {
    const int row = i / kSide;
    const auto [x, y, z] =
        OnRamp((i % kSide + 0.5) / kSide, (row + 0.5) / kSide);
    text += fmt::format("{},{},{},{},0,{}", x, y, z, Single(-0.4021),
                        Single(0.9156));
    if (!cells.empty()) text += "," + cells;
    text += '\n';
  }
  for (char& c : text)
    c = c == ',' ? separator : c;
  return text;
}

class OnFace : public testing::Test {
 protected:
  OnFace() { (void)folder_.Write("ramp.mtl", "newmtl lamp\nKe 1 2 3\n"); }

  [[nodiscard]] Outcome Run(const std::string& command,
                            const std::string& table,
                            const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {command, scene_, table};
    words.insert(words.end(), more.begin(), more.end());
    return RunTruelux(words);
  }

  TemporaryFolder folder_;
  std::string scene_ = folder_.Write("ramp.obj", RampObj());
  std::string texels_ = folder_.Write("texels.csv", Texels());
  std::string numbered_ = folder_.Write("numbered.csv", Texels("1"));
};

bool Contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

std::vector<std::string> LinesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

/// What stands behind the n-th separator of a line.
std::string Behind(const std::string& line, int n, char separator = ',') {
  std::size_t at = 0;
  for (; n > 0; --n)
    at = line.find(separator, at) + 1;
  return line.substr(at);
}

std::size_t CountZeros(const std::vector<std::string>& lines) {
  std::size_t zeros = 0;
  for (const std::string& line : lines)
    zeros += line.ends_with(",0,0,0") ? 1U : 0U;
  return zeros;
}

TEST_F(OnFace, WithoutItANoteCountsTheDark) {
  const Outcome outcome = Run("eval", texels_);
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  const std::size_t zeros = CountZeros(LinesOf(outcome.out));
  EXPECT_GT(zeros, 1000U);
  EXPECT_LT(zeros, 4000U);
  EXPECT_EQ(outcome.err,
            fmt::format("note: {} of 4096 receivers get 0 and lie behind a "
                        "face, no farther than rounding moves a point; "
                        "--on-face auto takes them as lying on it\n",
                        zeros));
}

TEST_F(OnFace, AutoGivesWhatTheNumberGives) {
  const Outcome numbered = Run("eval", numbered_);
  const std::vector<std::string> wanted = LinesOf(numbered.out);
  ASSERT_EQ(wanted.size(), 4097U);
  EXPECT_EQ(CountZeros(wanted), 0U);
  EXPECT_EQ(numbered.err, "");
  for (const char* choice : {"auto", "auto:0.001", "ramp", "1"}) {
    const Outcome outcome = Run("eval", texels_, {"--on-face", choice});
    EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
    const std::vector<std::string> lines = LinesOf(outcome.out);
    ASSERT_EQ(lines.size(), wanted.size());
    EXPECT_EQ(Behind(lines[0], 6), "on_face_found,E_r,E_g,E_b");
    for (std::size_t i = 1; i < lines.size(); ++i)
      ASSERT_EQ(Behind(lines[i], 6), Behind(wanted[i], 6)) << choice;
    const bool is_search = choice != std::string("1");
    EXPECT_EQ(Contains(outcome.err,
                       "note: --on-face: 4096 of 4096 receivers lie on a face, "
                       "at most "),
              is_search)
        << outcome.err;
    EXPECT_FALSE(Contains(outcome.err, "second"));
  }
}

TEST_F(OnFace, TheColumnTakesTheSameAndGoesFirst) {
  const std::string by_column = folder_.Write("auto.csv", Texels("auto"));
  const std::vector<std::string> wanted = LinesOf(Run("eval", numbered_).out);
  const Outcome column = Run("eval", by_column);
  const std::vector<std::string> lines = LinesOf(column.out);
  EXPECT_EQ(lines[0], "x,y,z,nx,ny,nz,on_face,E_r,E_g,E_b");
  for (std::size_t i = 1; i < lines.size(); ++i)
    ASSERT_EQ(Behind(lines[i], 7), Behind(wanted[i], 7));
  // The option would take the lamp.
  const Outcome both = Run("eval", by_column, {"--on-face", "lamp"});
  EXPECT_EQ(LinesOf(both.out)[0],
            "x,y,z,nx,ny,nz,on_face,on_face_found,E_r,E_g,E_b");
  for (std::size_t i = 1; i < lines.size(); ++i)
    ASSERT_EQ(Behind(LinesOf(both.out)[i], 7), "1," + Behind(wanted[i], 7));
}

TEST_F(OnFace, ThreadsChangeNothing) {
  const Outcome one =
      Run("eval", texels_, {"--on-face", "auto", "--threads", "1"});
  const Outcome many =
      Run("eval", texels_, {"--on-face", "auto", "--threads", "5"});
  EXPECT_EQ(one.out, many.out);
  EXPECT_EQ(one.err, many.err);
}

// Away from all faces there is none; between blanks that needs quotes.
TEST_F(OnFace, ReceiversOnNoFaceHaveAnEmptyField) {
  const std::string table =
      folder_.Write("far.csv", "x y z nx ny nz\n0 0 2 0 0 1\n");
  const Outcome outcome = Run("eval", table, {"--on-face", "auto"});
  EXPECT_TRUE(outcome.out.starts_with(
      "x y z nx ny nz on_face_found E_r E_g E_b\n0 0 2 0 0 1 \"\" "))
      << outcome.out;
  EXPECT_TRUE(Contains(outcome.err, "0 of 1 receivers lie on a face\n"));
}

TEST_F(OnFace, OneReceiverShowsWhatWasFound) {
  const Outcome found = RunTruelux({"eval", scene_, "--at", "0,0,3.9999999",
                                    "--normal", "0,0,-1", "--on-face", "auto"});
  EXPECT_TRUE(
      found.out.starts_with("x,y,z,nx,ny,nz,on_face,on_face_found,E_r,E_g,E_b\n"
                            "0,0,3.9999999,0,0,-1,auto,2,0,0,0\n"))
      << found.out << found.err;
  const Outcome none = RunTruelux({"eval", scene_, "--at", "0,0,2", "--normal",
                                   "0,0,1", "--on-face", "auto"});
  EXPECT_TRUE(Contains(none.out, "\n0,0,2,0,0,1,auto,,")) << none.out;
}

TEST_F(OnFace, CompareDoesNotAccuse) {
  const std::vector<std::string> truth = LinesOf(Run("eval", numbered_).out);
  std::string text = "x,y,z,nx,ny,nz,E_r,E_g,E_b\n";
  const std::vector<std::string> plain = LinesOf(Texels());
  for (std::size_t i = 1; i < truth.size(); ++i)
    text += plain[i] + "," + Behind(truth[i], 7) + "\n";
  const std::string candidate = folder_.Write("candidate.csv", text);
  const Outcome without = Run("compare", candidate);
  EXPECT_EQ(without.exit_status, 1);
  EXPECT_TRUE(Contains(without.out,
                       "receivers off their faces: the candidate agrees when "
                       "the receivers lie on their faces, as --on-face auto "
                       "takes them"))
      << without.out;
  EXPECT_FALSE(Contains(without.out, "equally well")) << without.out;
  EXPECT_TRUE(Contains(without.err, "--on-face auto")) << without.err;
  const Outcome with = Run("compare", candidate, {"--on-face", "auto"});
  EXPECT_EQ(with.exit_status, 0) << with.out;
  EXPECT_TRUE(Contains(with.err, "4096 of 4096 receivers lie on a face"));
}

TEST_F(OnFace, BenchAndInspectTakeIt) {
  const std::vector<std::string> lines = LinesOf(Texels());
  const std::string report = folder_ / "report.html";
  const std::vector<std::string> bench = {
      "-o", report, "--quick", "--receivers", "33", "--seconds", "0.01"};
  std::vector<std::string> with = bench;
  with.insert(with.end(), {"--on-face", "auto"});
  EXPECT_TRUE(Contains(Run("bench", texels_, bench).err, "--on-face auto"));
  EXPECT_TRUE(Contains(Run("bench", texels_, with).err,
                       "4096 of 4096 receivers lie on a face"));
  const std::string json = folder_ / "view.json";
  const auto [x, y, z] = OnRamp(0.25, 0.25);
  const Outcome inspect = RunTruelux(
      {"inspect", scene_, "--at", fmt::format("{},{},{}", x, y, z), "--normal",
       "-0.4021,0,0.9156", "--on-face", "auto", "--json", json});
  EXPECT_EQ(inspect.exit_status, 0) << inspect.err;
  EXPECT_TRUE(Contains(ReadFile(json), "\"on_face\":1")) << ReadFile(json);
}

// The pixels lie on the ramp anyway; on the lamp they see the ramp itself.
TEST_F(OnFace, RenderTakesIt) {
  const auto values = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {
        "render", scene_, "--surface",       "ramp",     "--size",
        "8",      "-o",   folder_ / "a.png", "--values", folder_ / "v.csv"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = RunTruelux(words);
    EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
    return ReadFile(folder_ / "v.csv");
  };
  const std::string own = values({});
  EXPECT_EQ(values({"--on-face", "auto"}), own);
  EXPECT_EQ(values({"--on-face", "1"}), own);
  EXPECT_NE(values({"--on-face", "lamp"}), own);
}

}  // namespace
}  // namespace truelux::test
