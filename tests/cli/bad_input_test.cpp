// SPDX-License-Identifier: GPL-3.0-or-later
// One test per way to call truelux eval wrongly: the exit status is 2, a line
// on standard error says what and where, and no output file comes to be.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/program.h"

namespace truelux::test {
namespace {

/// A file that a test puts into its folder.
struct NamedText {
  std::string name;
  std::string text;
};

/// Arguments that start with @ are names in the test's folder.
struct BadCall {
  std::string name;
  std::vector<std::string> arguments;
  std::vector<NamedText> files;
  std::string message;  ///< a part of standard error; @ is the folder
};

std::string Resolve(std::string text, const TemporaryFolder& folder) {
  for (std::size_t at = text.find('@'); at != text.npos; at = text.find('@')) {
    text.replace(at, 1, folder / "");
  }
  return text;
}

class BadInput : public testing::TestWithParam<BadCall> {};

TEST_P(BadInput, ExitsWith2AndLeavesNoOutput) {
  const TemporaryFolder folder;
  WriteSquare(folder);
  folder.Write("good.csv", Table(3));
  for (const NamedText& file : GetParam().files) {
    folder.Write(file.name, file.text);
  }
  const std::vector<std::string> before = folder.Names();
  std::vector<std::string> arguments;
  for (const std::string& argument : GetParam().arguments) {
    arguments.push_back(Resolve(argument, folder));
  }
  const Outcome outcome = RunTruelux(arguments);
  EXPECT_EQ(outcome.exit_status, 2) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find(Resolve(GetParam().message, folder)),
            std::string::npos)
      << outcome.err;
  EXPECT_EQ(folder.Names(), before);
}

std::string NameOf(const testing::TestParamInfo<BadCall>& info) {
  return info.param.name;
}

/// A defect of the receivers table.
BadCall BadTable(const std::string& name, const std::string& text,
                 const std::string& message) {
  return {name,
          {"eval", "@square.obj", "@bad.csv", "-o", "@out.csv"},
          {{"bad.csv", text}},
          "@bad.csv:" + message};
}

const std::string kGoodRow = "0,0,0,0,0,1\n";

INSTANTIATE_TEST_SUITE_P(
    Table, BadInput,
    testing::Values(
        BadTable("Empty", "", "1: error: no header"),
        BadTable("ColumnMissing", "x,y,z,nx,ny\n",
                 "1: error: the header lacks the column nz"),
        BadTable("OnFaceFoundInAnyCase",
                 "x,y,z,nx,ny,nz,On_Face_Found\n0,0,0,0,0,1,2\n",
                 "1: error: column 'On_Face_Found' has the name of a result"),
        BadTable("ColumnTwice", "x,y,z,nx,ny,nz,x\n",
                 "1: error: column 'x' stands twice"),
        BadTable("ResultColumn", "x,y,z,nx,ny,nz,E_r\n",
                 "1: error: column 'E_r' has the name of a result"),
        BadTable("BoundColumn", "x,y,z,nx,ny,nz,bound_x\n",
                 "1: error: column 'bound_x' has the name of a result"),
        BadTable("ShortRow", std::string(kHeader) + kGoodRow + "0,0,0\n",
                 "3: error: 3 fields, but the header has 6"),
        BadTable("LongRow", std::string(kHeader) + "0,0,0,0,0,1,9\n",
                 "2: error: 7 fields, but the header has 6"),
        BadTable("NoNumber", std::string(kHeader) + "0,zero,0,0,0,1\n",
                 "2: error: y: 'zero' is not a number"),
        BadTable("EmptyNumber", std::string(kHeader) + "0,,0,0,0,1\n",
                 "2: error: y: '' is not a number"),
        BadTable("Infinite", std::string(kHeader) + "inf,0,0,0,0,1\n",
                 "2: error: x: 'inf' is not a number"),
        BadTable("NotANumber", std::string(kHeader) + "0,0,0,0,0,nan\n",
                 "2: error: nz: 'nan' is not a number"),
        BadTable("Hexadecimal", std::string(kHeader) + "0x1,0,0,0,0,1\n",
                 "2: error: x: '0x1' is not a number"),
        BadTable("Overflow", std::string(kHeader) + "0,0,1e400,0,0,1\n",
                 "2: error: z: '1e400' is not a number"),
        BadTable("ZeroNormal", std::string(kHeader) + "0,0,0,0,0,-0\n",
                 "2: error: the normal is zero"),
        BadTable("OnFaceTooLarge", "x,y,z,nx,ny,nz,on_face\n0,0,0,0,0,1,2\n",
                 "2: error: on_face: '2' is out of range; the scene has 1 "
                 "face"),
        BadTable("OnFaceZero", "x,y,z,nx,ny,nz,on_face\n0,0,0,0,0,1,0\n",
                 "2: error: on_face: '0' is out of range"),
        BadTable("OnFaceFraction", "x,y,z,nx,ny,nz,on_face\n0,0,0,0,0,1,.5\n",
                 "2: error: on_face: '.5' is not the number of a face"),
        BadTable("QuoteNeverClosed",
                 std::string(kHeader) + kGoodRow + "0,0,\"0,0,0,1\n" + kGoodRow,
                 "3: error: this quote is never closed"),
        BadTable("QuoteInside", std::string(kHeader) + "0,0,0\",0,0,1\n",
                 "2: error: quote inside a field"),
        BadTable("NulByte",
                 std::string(kHeader) + std::string("0,0,\0,0,0,1\n", 12),
                 "2: error: NUL byte"),
        BadTable("LoneCarriageReturns", "x,y,z,nx,ny,nz\r0,0,0,0,0,1\r",
                 "1: error: carriage return without line feed")),
    NameOf);

/// A defect of the scene.
BadCall BadScene(const std::string& name, const std::string& obj,
                 const std::string& mtl, const std::string& message) {
  return {name,
          {"eval", "@bad.obj", "@good.csv", "-o", "@out.csv"},
          {{"bad.obj", obj}, {"bad.mtl", mtl}},
          message};
}

INSTANTIATE_TEST_SUITE_P(
    Scene, BadInput,
    testing::Values(
        BadScene("VertexUnknown", "v 0 0 1\nf 1 2 3\n", "",
                 "@bad.obj:2: error:"),
        BadScene("NoNumber", "v 0 0 one\nf 1 1 1\n", "", "@bad.obj:1: error:"),
        BadScene("SelfCrossing",
                 "v 0 0 1\nv 1 1 1\nv 1 0 1\nv 0 1 1\n\nf 1 2 3 4\n", "",
                 "@bad.obj:6: error:"),
        BadScene("MtlMissing", "mtllib none.mtl\nv 0 0 0\nusemtl m\nf 1 1 1\n",
                 "", "@bad.obj:3: error: unknown material"),
        BadScene("NegativeKe", "mtllib bad.mtl\nv 0 0 0\nusemtl m\nf 1 1 1\n",
                 "newmtl m\nKe 1 -1 1\n", "@bad.mtl:2: error:"),
        BadScene("ShortKe", "mtllib bad.mtl\nv 0 0 0\nusemtl m\nf 1 1 1\n",
                 "newmtl m\nKe 1 2\n", "@bad.mtl:2: error:")),
    NameOf);

INSTANTIATE_TEST_SUITE_P(
    Files, BadInput,
    testing::Values(
        BadCall{"SceneMissing",
                {"eval", "@none.obj", "@good.csv", "-o", "@out.csv"},
                {},
                "@none.obj: error:"},
        BadCall{"SceneIsFolder", {"eval", "@.", "@good.csv"}, {}, "@.: error:"},
        BadCall{"TableMissing",
                {"eval", "@square.obj", "@none.csv", "-o", "@out.csv"},
                {},
                "@none.csv: error: cannot open: No such file"},
        BadCall{"TableIsFolder",
                {"eval", "@square.obj", "@.", "-o", "@out.csv"},
                {},
                "@.: error: cannot read: Is a directory"},
        BadCall{"OutputFolderMissing",
                {"eval", "@square.obj", "@good.csv", "-o", "@none/out.csv"},
                {},
                "@none/out.csv: error: cannot write: No such file"},
        BadCall{"OutputFolderIsFile",
                {"eval", "@square.obj", "@good.csv", "-o", "@good.csv/out.csv"},
                {},
                "@good.csv/out.csv: error: cannot write: Not a directory"},
        BadCall{"OutputIsFolder",
                {"eval", "@square.obj", "@good.csv", "-o", "@."},
                {},
                "@.: error: cannot write: Is a directory"},
        BadCall{"OutputIsScene",
                {"eval", "@square.obj", "@good.csv", "-o", "@./square.obj"},
                {},
                "is also the input @square.obj"},
        BadCall{"OutputIsMtl",
                {"eval", "@square.obj", "@good.csv", "-o", "@square.mtl"},
                {},
                "is also the input @square.mtl"},
        BadCall{"OutputIsTable",
                {"eval", "@square.obj", "@good.csv", "-o", "@good.csv"},
                {},
                "is also the input @good.csv"},
        BadCall{"StatsIsTable",
                {"eval", "@square.obj", "@good.csv", "--stats", "@good.csv"},
                {},
                "is also the input @good.csv"},
        BadCall{"StatsIsOutput",
                {"eval", "@square.obj", "@good.csv", "-o", "@out", "--stats",
                 "@./out"},
                {},
                "--stats and --output are the same file"},
        BadCall{"StatsFolderMissing",
                {"eval", "@square.obj", "@good.csv", "-o", "@out.csv",
                 "--stats", "@none/s.json"},
                {},
                "@none/s.json: error: cannot write: No such file"},
        BadCall{"DiskFull",
                {"eval", "@square.obj", "@good.csv", "-o", "/dev/full"},
                {},
                "/dev/full: error: cannot write: No space left"},
        BadCall{"DiskFullForStats",
                {"eval", "@square.obj", "@good.csv", "-o", "@out.csv",
                 "--stats", "/dev/full"},
                {},
                "/dev/full: error: cannot write: No space left"}),
    NameOf);

/// Wrong usage, of which the message is the first line.
BadCall BadUsage(const std::string& name, std::vector<std::string> arguments,
                 const std::string& message) {
  return {name, std::move(arguments), {}, message};
}

INSTANTIATE_TEST_SUITE_P(
    Usage, BadInput,
    testing::Values(
        BadUsage("NoCommand", {}, "error: no command given\nUsage: truelux"),
        BadUsage("UnknownCommand", {"evil"},
                 "error: unknown command 'evil'\nUsage: truelux"),
        BadUsage("UnknownOption", {"--evil"},
                 "error: unknown option '--evil'\nUsage: truelux"),
        BadUsage("UnknownOptionOfCommand",
                 {"eval", "@square.obj", "@good.csv", "--evil"},
                 "--evil\nUsage: truelux eval"),
        BadUsage("NoScene", {"eval"}, "error: SCENE.obj is required"),
        BadUsage("NoReceivers", {"eval", "@square.obj"},
                 "error: no receivers: give a table, or --at and --normal"),
        BadUsage("TableAndAt",
                 {"eval", "@square.obj", "@good.csv", "--at", "0,0,0",
                  "--normal", "0,0,1"},
                 "error: --at stands for a table of receivers"),
        BadUsage("AtWithoutNormal", {"eval", "@square.obj", "--at", "0,0,0"},
                 "error: --at and --normal belong together"),
        BadUsage("AtTooShort",
                 {"eval", "@square.obj", "--at", "0,0", "--normal", "0,0,1"},
                 "error: --at: '0,0' is not three numbers"),
        BadUsage("NormalNoNumber",
                 {"eval", "@square.obj", "--at", "0,0,0", "--normal", "0,0,u"},
                 "error: --normal: nz: 'u' is not a number"),
        BadUsage("NormalZero",
                 {"eval", "@square.obj", "--at", "0,0,0", "--normal", "0,0,0"},
                 "error: --normal: the normal is zero"),
        BadUsage("OnFaceUnknown",
                 {"eval", "@square.obj", "@good.csv", "--on-face", "Floor"},
                 "error: --on-face: 'Floor' is not the number of a face, the "
                 "name of an object or group, or auto"),
        BadUsage("OnFaceEmpty",
                 {"eval", "@square.obj", "@good.csv", "--on-face", ""},
                 "error: --on-face: the text is empty"),
        BadUsage("OnFaceBlank",
                 {"eval", "@square.obj", "@good.csv", "--on-face", " "},
                 "error: --on-face: the text is empty"),
        BadUsage("OnFaceNoDistance",
                 {"eval", "@square.obj", "@good.csv", "--on-face", "auto:"},
                 "error: --on-face: 'auto:': expected auto, or auto:D"),
        BadUsage("OnFaceTooLarge",
                 {"eval", "@square.obj", "--at", "0,0,0", "--normal", "0,0,1",
                  "--on-face", "2"},
                 "error: --on-face: '2' is out of range; the scene has 1 face"),
        BadUsage("OnFaceZeroOption",
                 {"eval", "@square.obj", "--at", "0,0,0", "--normal", "0,0,1",
                  "--on-face", "0"},
                 "error: --on-face: '0' is out of range; the scene has 1 face"),
        BadUsage("FormulaWithoutMethodDouble",
                 {"eval", "@square.obj", "@good.csv", "--formula", "auto"},
                 "error: --formula belongs to --method double"),
        BadUsage("FormulaUnknown",
                 {"eval", "@square.obj", "@good.csv", "--method", "double",
                  "--formula", "lambert"},
                 "error: --formula: 'lambert' is none of auto, lambert-acos, "
                 "lambert-atan2, lambert-edge, vertex-lambert, image-plane, "
                 "directions, sphere, projective, homogeneous, unified, "
                 "difference, series, cubature\nUsage: truelux eval"),
        BadUsage("FormulaOfSpans",
                 {"eval", "@square.obj", "@good.csv", "--method", "double",
                  "--formula", "sphere", "--engine", "angular-spans"},
                 "error: --formula needs the contour of every source"),
        BadUsage("HalfSideOfAuto",
                 {"eval", "@square.obj", "@good.csv", "--method", "double",
                  "--half-side", "3"},
                 "error: --half-side belongs to --formula image-plane"),
        BadUsage("HalfSideWithoutMethodDouble",
                 {"eval", "@square.obj", "@good.csv", "--half-side", "3"},
                 "error: --half-side belongs to --formula image-plane"),
        BadUsage("HalfSideZero",
                 {"eval", "@square.obj", "@good.csv", "--method", "double",
                  "--formula", "directions", "--half-side", "0"},
                 "error: --half-side: '0' is not a positive number"),
        BadUsage("HalfSideInfinite",
                 {"eval", "@square.obj", "@good.csv", "--method", "double",
                  "--formula", "image-plane", "--half-side", "inf"},
                 "error: --half-side: 'inf' is not a positive number"),
        BadUsage("MethodUnknown",
                 {"eval", "@square.obj", "@good.csv", "--method", "fast"},
                 "error: --method: fast not in {certified,double}"),
        BadUsage("EngineUnknown",
                 {"eval", "@square.obj", "@good.csv", "--engine", "v8"},
                 "error: --engine: v8 not in "
                 "{contour,arrangement,angular-spans}"),
        BadUsage("EmissionUnknown",
                 {"eval", "@square.obj", "@good.csv", "--emission", "lumen"},
                 "error: --emission: lumen not in {exitance,radiance}"),
        BadUsage("ThreadsZero",
                 {"eval", "@square.obj", "@good.csv", "--threads", "0"},
                 "error: --threads: '0' is not a whole number from 1 to "
                 "1024"),
        BadUsage("ThreadsNoNumber",
                 {"eval", "@square.obj", "@good.csv", "--threads", "2x"},
                 "error: --threads: '2x' is not a whole number from 1 to "
                 "1024"),
        BadUsage("OptionWithoutValue",
                 {"eval", "@square.obj", "@good.csv", "--stats"},
                 "error: --stats"),
        BadUsage("OutputNameEmpty",
                 {"eval", "@square.obj", "@good.csv", "-o", ""},
                 "error: --output: the file name is empty")),
    NameOf);

TEST(BadInputTogether, AHundredDefectsAreListedAndTheRestCounted) {
  const TemporaryFolder folder;
  std::string table(kHeader);
  for (int i = 0; i < 150; ++i)
    table += "?,0,0,0,0,1\n";
  const Outcome outcome =
      RunTruelux({"eval", WriteSquare(folder), folder.Write("bad.csv", table)});
  EXPECT_EQ(outcome.exit_status, 2);
  EXPECT_NE(outcome.err.find("bad.csv:101: error: x: '?'"), std::string::npos);
  EXPECT_EQ(outcome.err.find("bad.csv:102:"), std::string::npos);
  EXPECT_NE(outcome.err.find("50 more errors not shown"), std::string::npos);
}

}  // namespace
}  // namespace truelux::test
