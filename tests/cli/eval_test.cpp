// SPDX-License-Identifier: GPL-3.0-or-later
// truelux eval from outside: what it prints and what it writes.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <sys/stat.h>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/irradiance.h"

#include "cli/program.h"

namespace truelux::test {
namespace {

namespace fs = std::filesystem;

/// The square, and the arguments that evaluate a table under it.
class Eval : public testing::Test {
 protected:
  [[nodiscard]] Outcome Run(std::vector<std::string> more,
                            const Surroundings& around = {}) const {
    more.insert(more.begin(), {"eval", scene_});
    return RunTruelux(more, around);
  }

  TemporaryFolder folder_;
  std::string scene_ = WriteSquare(folder_);
};

/// The last of the comma-separated numbers of a text, from the back.
double NumberFromBack(std::string text, int index) {
  while (text.back() == '\n')
    text.pop_back();
  for (; index > 0; --index)
    text.resize(text.rfind(','));
  return std::strtod(text.c_str() + text.rfind(',') + 1, nullptr);
}

TEST_F(Eval, OneReceiverIsPrintedWithTheUsersTexts) {
  const Outcome outcome = Run({"--at", "-0,+0.0,0", "--normal", "-.0,0,2e-3"});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const std::string start =
      "x,y,z,nx,ny,nz,E_r,E_g,E_b\n-0,+0.0,0,-.0,0,2e-3,0.55";
  EXPECT_EQ(outcome.out.substr(0, start.size()), start);
  // The closed form for a parallel square, seen from below its centre.
  const double form_factor =
      2 * std::sqrt(2.0) / M_PI * std::atan(1 / std::sqrt(2.0));
  EXPECT_NEAR(NumberFromBack(outcome.out, 2), form_factor, 1e-15);
  EXPECT_EQ(NumberFromBack(outcome.out, 1), 2 * NumberFromBack(outcome.out, 2));
  EXPECT_EQ(NumberFromBack(outcome.out, 0), 0);
}

TEST_F(Eval, OnFaceIsAColumnAndIgnoresTheFace) {
  const Outcome outcome =
      Run({"--at", "0,0,0.5", "--normal", "0,0,1", "--on-face", "1"});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "x,y,z,nx,ny,nz,on_face,E_r,E_g,E_b\n0,0,0.5,0,0,1,1,0,0,0\n");
}

// The library's names are the words of the command line.
TEST_F(Eval, TakesTheNamesOfTheLibrary) {
  const std::vector<std::string> one = {"--at", "0,0,0", "--normal", "0,0,1"};
  const auto expect_taken = [&](const char* option, std::string_view name) {
    std::vector<std::string> words = one;
    words.insert(words.end(), {option, std::string(name)});
    EXPECT_EQ(Run(words).exit_status, 0) << option << " " << name;
  };
  for (const Engine engine :
       {Engine::kContour, Engine::kArrangement, Engine::kAngularSpans}) {
    expect_taken("--engine", Name(engine));
  }
  for (const Method method : {Method::kCertified, Method::kDouble})
    expect_taken("--method", Name(method));
  for (const Emission emission : {Emission::kExitance, Emission::kRadiance})
    expect_taken("--emission", Name(emission));
}

TEST_F(Eval, ASceneInWhichNothingEmitsIsNoted) {
  folder_.Write("square.mtl", "newmtl light\nKd 1 1 1\n");
  const Outcome outcome = Run({"--at", "0,0,0", "--normal", "0,0,1"});
  EXPECT_EQ(outcome.exit_status, 0);
  EXPECT_NE(outcome.err.find("square.obj: note: no face emits"),
            std::string::npos)
      << outcome.err;
  folder_.Write("square.mtl", "newmtl light\nKe 0 0 1\n");
  EXPECT_EQ(Run({"--at", "0,0,0", "--normal", "0,0,1"}).err, "");
}

TEST_F(Eval, RadianceIsPiTimesAsMuch) {
  const std::vector<std::string> one = {"--at", "0,0,0", "--normal", "0,0,1"};
  std::vector<std::string> radiance = one;
  radiance.insert(radiance.end(), {"--emission", "radiance"});
  EXPECT_NEAR(NumberFromBack(Run(radiance).out, 2),
              M_PI * NumberFromBack(Run(one).out, 2), 1e-14);
}

TEST_F(Eval, ColumnsPassThroughByteForByte) {
  const std::string table =
      folder_.Write("in.csv",
                    "\xEF\xBB\xBFname, x ,y,z,nx,ny,nz\r\n"
                    "\r\n"
                    "\"a,\"\"b\"\"\r\n\", 5 ,0,2,0,0,+1\r\n"
                    "\xC3\xA9,5,0,2e0,0,0,1");
  const Outcome outcome = Run({table});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  // Above the square, so that it is black.
  EXPECT_EQ(outcome.out,
            "name, x ,y,z,nx,ny,nz,E_r,E_g,E_b\n"
            "\"a,\"\"b\"\"\r\n\", 5 ,0,2,0,0,+1,0,0,0\n"
            "\xC3\xA9,5,0,2e0,0,0,1,0,0,0\n");
}

TEST_F(Eval, HeaderAloneGivesHeaderAlone) {
  const Outcome outcome = Run({"-"}, {.input = std::string(kHeader)});
  EXPECT_EQ(outcome.exit_status, 0);
  EXPECT_EQ(outcome.out, "x,y,z,nx,ny,nz,E_r,E_g,E_b\n");
}

TEST_F(Eval, MethodDoubleAddsBoundsThatHold) {
  const std::string table = folder_.Write("in.csv", Table(1));
  const Outcome certified = Run({table});
  const Outcome in_double = Run({table, "--method", "double"});
  EXPECT_EQ(in_double.exit_status, 0) << in_double.err;
  EXPECT_EQ(in_double.out.substr(0, in_double.out.find('\n')),
            "x,y,z,nx,ny,nz,E_r,E_g,E_b,bound_r,bound_g,bound_b");
  const double bound = NumberFromBack(in_double.out, 2);
  EXPECT_GT(bound, 0);
  EXPECT_LT(bound, 1e-12);
  EXPECT_LE(std::abs(NumberFromBack(in_double.out, 5) -
                     NumberFromBack(certified.out, 2)),
            bound);
}

TEST_F(Eval, EveryFormulaHasABoundThatHolds) {
  const std::string table = folder_.Write("in.csv", Table(1));
  const std::string report = folder_ / "report.json";
  const double truth = NumberFromBack(Run({table}).out, 2);
  for (const std::string formula :
       {"auto", "lambert-acos", "lambert-atan2", "lambert-edge",
        "vertex-lambert", "image-plane", "directions", "sphere", "projective",
        "homogeneous", "unified", "difference", "cubature"}) {
    const Outcome outcome = Run(
        {table, "--method", "double", "--formula", formula, "--stats", report});
    EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const double bound = NumberFromBack(outcome.out, 2);
    EXPECT_GT(bound, 0);
    EXPECT_LT(bound, 1e-12);
    EXPECT_LE(std::abs(NumberFromBack(outcome.out, 5) - truth), bound)
        << formula;
    EXPECT_NE(ReadFile(report).find("\"formula\": \"" + formula + "\",\n"),
              std::string::npos);
  }
}

TEST_F(Eval, HalfSideCutsAndItsBoundHoldsWhatIsCutOff) {
  const std::string table = folder_.Write("in.csv", Table(1));
  const double truth = NumberFromBack(Run({table}).out, 2);
  for (const std::string formula : {"image-plane", "directions"}) {
    const Outcome outcome = Run({table, "--method", "double", "--formula",
                                 formula, "--half-side", "0.5"});
    EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
    const double missing = truth - NumberFromBack(outcome.out, 5);
    EXPECT_GT(missing, 0.1);
    EXPECT_LE(missing, NumberFromBack(outcome.out, 2));
  }
}

TEST_F(Eval, FormulaThatDoesNotApplyIsNanWithOneNote) {
  const std::string table =
      folder_.Write("in.csv", std::string(kHeader) +
                                  "0,0,0,0,0,1\n0,0,-999,0,0,1\n0,0,2,0,0,1\n"
                                  "0,0,0.5,0,0,1\n");
  const Outcome outcome =
      Run({table, "--method", "double", "--formula", "series"});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\n0,0,0,0,0,1,nan,nan,0,inf,inf,0\n"),
            std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("\n0,0,-999,0,0,1,1."), std::string::npos);
  EXPECT_NE(outcome.out.find("\n0,0,2,0,0,1,0,0,0,0,0,0\n"), std::string::npos);
  EXPECT_EQ(outcome.err,
            "note: 2 of 4 receivers have a source to which the formula series "
            "does not apply, written as nan\n");
}

TEST_F(Eval, TooLargeForBinary64IsInfByAnyFormula) {
  folder_.Write("square.mtl", "newmtl light\nKe 1.7e308 1 0\n");
  const Outcome outcome =
      Run({"--at", "0,0,0.99", "--normal", "0,0,1", "--emission", "radiance",
           "--method", "double", "--formula", "lambert-edge"});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("0,0,0.99,0,0,1,inf,3."), std::string::npos)
      << outcome.out;
  EXPECT_EQ(outcome.err,
            "note: 1 of 1 receivers has an irradiance too large for "
            "binary64, written as inf\n");
}

TEST_F(Eval, FileStandardInputAndThreadsGiveTheSameBytes) {
  const std::string table = folder_.Write("in.csv", Table(3000));
  const std::string reference = Run({table, "--threads", "1"}).out;
  EXPECT_EQ(std::count(reference.begin(), reference.end(), '\n'), 3001);
  for (const char* threads : {"2", "3", "16"}) {
    EXPECT_EQ(Run({table, "--threads", threads}).out, reference);
  }
  EXPECT_EQ(Run({"-"}, {.input = Table(3000)}).out, reference);
  EXPECT_EQ(Run({table, "-o", "-"}).out, reference);
  EXPECT_EQ(Run({table, "-o", folder_ / "out.csv"}).out, "");
  EXPECT_EQ(ReadFile(folder_ / "out.csv"), reference);
}

TEST_F(Eval, RowsBeforeADefectOnStandardInputArePrinted) {
  const Outcome outcome =
      Run({"-"}, {.input = Table(300) + "?,0,0,0,0,1\n" + Table(5)});
  EXPECT_EQ(outcome.exit_status, 2);
  EXPECT_EQ(outcome.err.rfind("<stdin>:302: error: x: '?'", 0), 0U);
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 301);
}

TEST_F(Eval, NotesAreOnStandardErrorAndDoNotStopIt) {
  const std::string scene = folder_.Write(
      "bent.obj", "v 0 0 1\nv 1 0 1\nv 1 1 2\nv 0 1 1\nf 1 2 3 4\n");
  const Outcome outcome =
      RunTruelux({"eval", scene, "--at", "0,0,0", "--normal", "0,0,1"});
  EXPECT_EQ(outcome.exit_status, 0);
  EXPECT_NE(outcome.err.find("bent.obj:5: note: "), std::string::npos);
}

TEST_F(Eval, TooLargeForBinary64IsInfWithOneNote) {
  folder_.Write("square.mtl", "newmtl light\nKe 1.7e308 1 0\n");
  const std::string table = folder_.Write(
      "in.csv", std::string(kHeader) + "0,0,0.9,0,0,1\n0,0,0.99,0,0,1\n" +
                    "0,0,2,0,0,1\n");
  const Outcome outcome = Run({table, "--emission", "radiance"});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("0,0,0.99,0,0,1,inf,3."), std::string::npos)
      << outcome.out;
  EXPECT_EQ(outcome.err,
            "note: 2 of 3 receivers have an irradiance too large for "
            "binary64, written as inf\n");
}

/// The lines of a report that a run's times and threads do not change.
std::string Counts(const std::string& json) {
  return json.substr(json.find("  \"receivers\""));
}

TEST_F(Eval, StatisticsDoNotDependOnThreads) {
  const std::string table = folder_.Write("in.csv", Table(1000));
  const std::string one = folder_ / "1.json";
  const std::string four = folder_ / "4.json";
  EXPECT_EQ(Run({table, "--threads", "1", "--stats", one}).exit_status, 0);
  EXPECT_EQ(Run({table, "--threads", "4", "--stats", four}).exit_status, 0);
  EXPECT_NE(ReadFile(four).find("\"threads\": 4,\n"), std::string::npos);
  EXPECT_NE(ReadFile(one).find("\"receivers\": 1000,\n"), std::string::npos);
  EXPECT_NE(ReadFile(one).find("\"sources\": 1000,\n"), std::string::npos);
  EXPECT_EQ(Counts(ReadFile(one)), Counts(ReadFile(four)));
}

TEST_F(Eval, EveryEnginePrintsTheSameAndIsNamedInTheReport) {
  const std::string table = folder_.Write("in.csv", Table(5));
  const std::string report = folder_ / "report.json";
  const std::string expected = Run({table}).out;
  for (const std::string engine : {"contour", "arrangement", "angular-spans"}) {
    EXPECT_EQ(Run({table, "--engine", engine, "--stats", report}).out,
              expected);
    EXPECT_NE(ReadFile(report).find("\"engine\": \"" + engine + "\",\n"),
              std::string::npos);
  }
}

TEST_F(Eval, ExistingFileIsReplacedWithItsModeKept) {
  const std::string table = folder_.Write("in.csv", Table(1));
  const std::string out = folder_.Write("out.csv", "old");
  chmod(out.c_str(), 0640);
  EXPECT_EQ(Run({table, "-o", out}).exit_status, 0);
  EXPECT_NE(ReadFile(out).find("E_r"), std::string::npos);
  EXPECT_EQ(fs::status(out).permissions(), fs::perms(0640));
}

TEST_F(Eval, ExistingFileSurvivesAnError) {
  const std::string out = folder_.Write("out.csv", "old");
  EXPECT_EQ(Run({"-", "-o", out}, {.input = Table(2) + "bad\n"}).exit_status,
            2);
  EXPECT_EQ(ReadFile(out), "old");
  EXPECT_EQ(folder_.Names(),
            (std::vector<std::string>{"out.csv", "square.mtl", "square.obj"}));
}

TEST_F(Eval, LinksStayLinks) {
  const std::string table = folder_.Write("in.csv", Table(1));
  const std::string target = folder_.Write("target.csv", "old");
  fs::create_symlink("target.csv", folder_ / "link.csv");
  fs::create_symlink("new.csv", folder_ / "dangling.csv");
  EXPECT_EQ(Run({table, "-o", folder_ / "link.csv"}).exit_status, 0);
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.csv"));
  EXPECT_NE(ReadFile(target), "old");
  EXPECT_EQ(Run({table, "-o", folder_ / "dangling.csv"}).exit_status, 0);
  EXPECT_TRUE(fs::is_symlink(folder_ / "dangling.csv"));
  EXPECT_EQ(ReadFile(folder_ / "new.csv"), ReadFile(target));
}

TEST_F(Eval, OutputThatIsAnInputByALinkIsRefused) {
  const std::string table = folder_.Write("in.csv", Table(1));
  fs::create_symlink("in.csv", folder_ / "soft.csv");
  fs::create_hard_link(table, folder_ / "hard.csv");
  for (const char* name : {"soft.csv", "hard.csv"}) {
    EXPECT_EQ(Run({table, "-o", folder_ / name}).exit_status, 2) << name;
  }
  // A redirection is an output as well.
  EXPECT_EQ(Run({table}, {.output_path = table}).exit_status, 2);
  EXPECT_EQ(ReadFile(table), Table(1));
}

TEST_F(Eval, DevicesAndPipesAreWrittenDirectly) {
  const std::string table = folder_.Write("in.csv", Table(1));
  EXPECT_EQ(Run({table, "-o", "/dev/null", "--stats", "/dev/null"}).exit_status,
            0);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_EQ(Run({table, "-o", "/dev/stdout"}).out, Run({table}).out);
  EXPECT_EQ(Run({table, "-o", "/dev/stderr"}).err, Run({table}).out);
}

TEST_F(Eval, WriteErrorsOnStandardOutputAreErrors) {
  const std::string table = folder_.Write("in.csv", Table(1));
  const Outcome full = Run({table}, {.output_path = "/dev/full"});
  EXPECT_EQ(full.exit_status, 2);
  EXPECT_EQ(full.err,
            "<stdout>: error: cannot write: No space left on device\n");
  // A reader that has gone has all that it wanted.
  const Outcome closed = Run({table}, {.close_output = true});
  EXPECT_EQ(closed.exit_status, 0);
  EXPECT_EQ(closed.err, "");
}

TEST(Program, HelpAndVersionGoToStandardOutput) {
  const Outcome version = RunTruelux({"--version"});
  EXPECT_EQ(version.exit_status, 0);
  EXPECT_EQ(version.out.rfind("truelux ", 0), 0U);
  for (const std::vector<std::string>& call :
       {std::vector<std::string>{"--help"},
        {"eval", "--help"},
        {"eval", "-h"}}) {
    const Outcome help = RunTruelux(call);
    EXPECT_EQ(help.exit_status, 0);
    EXPECT_EQ(help.err, "");
    EXPECT_NE(help.out.find("130  interrupted"), std::string::npos);
  }
  EXPECT_EQ(RunTruelux({"--help"}, {.output_path = "/dev/full"}).exit_status,
            2);
}

TEST(Program, CornellBoxFloorIsEvaluated) {
  const std::string scenes = TRUELUX_EXAMPLES "/scenes/";
  const Outcome outcome = RunTruelux(
      {"eval", scenes + "cornell_box.obj", scenes + "cornell_box_floor.csv"});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 145);
  // Under the short block it is dark, in the middle of the room it is not.
  EXPECT_NE(outcome.out.find("\n205,0,163,0,1,0,1,0,0,0\n"), std::string::npos)
      << outcome.out;
  EXPECT_EQ(outcome.out.find("\n295,0,209,0,1,0,1,0,0,0\n"), std::string::npos);
}

}  // namespace
}  // namespace truelux::test
