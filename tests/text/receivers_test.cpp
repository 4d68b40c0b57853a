// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/receivers.h"

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "support/scenes.h"
#include "text/byte_source.h"

namespace truelux {
namespace {

constexpr int kFaceCount = 7;

/// What a reader says about a table.
struct Table {
  bool header_ok = false;
  std::string header;
  std::vector<ReceiverRow> rows;
  std::vector<std::string> defects;
};

Table Read(std::string_view text) {
  TextSource source(text);
  const Scene scene = testing::SceneOf(kFaceCount);
  FaceWords faces(scene);
  ReceiverReader reader(source, "t.csv", faces);
  Table table;
  std::vector<Diagnostic> defects;
  table.header_ok = reader.ReadHeader(defects);
  table.header = reader.header();
  auto status = table.header_ok ? ReceiverReader::Status::kRow
                                : ReceiverReader::Status::kEnd;
  while (status != ReceiverReader::Status::kEnd) {
    ReceiverRow row;
    status = reader.Next(row, defects);
    if (status == ReceiverReader::Status::kRow) table.rows.push_back(row);
  }
  for (const Diagnostic& defect : defects) {
    table.defects.push_back(defect.Text());
  }
  return table;
}

using Texts = std::vector<std::string>;

TEST(Receivers, ColumnsMayStandInAnyOrder) {
  const Table table = Read("nz,ny,nx,z,y,x\n6,5,4,3,2,1\n");
  EXPECT_EQ(table.defects, Texts{});
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(table.rows[0].receiver.position, (Point3{1, 2, 3}));
  EXPECT_EQ(table.rows[0].receiver.normal, (Vector3{4, 5, 6}));
  EXPECT_EQ(table.rows[0].receiver.on_face, 0);
}

TEST(Receivers, FurtherColumnsAndTextsAreKept) {
  const Table table = Read(
      "\"name\", x ,y,z,nx,ny,nz,name\r\n"
      "\"a, \"\"b\"\"\", +1.50 ,\"2\",3,0,0,1e0,\"two\nlines\"\r\n");
  EXPECT_EQ(table.defects, Texts{});
  EXPECT_EQ(table.header, "\"name\", x ,y,z,nx,ny,nz,name");
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(table.rows[0].text,
            "\"a, \"\"b\"\"\", +1.50 ,\"2\",3,0,0,1e0,\"two\nlines\"");
  EXPECT_EQ(table.rows[0].receiver.position, (Point3{1.5, 2, 3}));
}

TEST(Receivers, OnFaceIsANumberOfAFaceOrEmpty) {
  const Table table = Read(
      "x,y,z,nx,ny,nz,on_face\n"
      "0,0,0,0,0,1,1\n"
      "0,0,0,0,0,1, 7 \n"
      "0,0,0,0,0,1,\n"
      "0,0,0,0,0,1,3.0\n");
  EXPECT_EQ(table.defects, Texts{});
  ASSERT_EQ(table.rows.size(), 4U);
  EXPECT_EQ(table.rows[0].receiver.on_face, 1);
  EXPECT_EQ(table.rows[1].receiver.on_face, 7);
  EXPECT_EQ(table.rows[2].receiver.on_face, 0);
  EXPECT_EQ(table.rows[3].receiver.on_face, 3);
}

TEST(Receivers, HeaderAloneIsATableWithoutRows) {
  const Table table = Read("x,y,z,nx,ny,nz");
  EXPECT_TRUE(table.header_ok);
  EXPECT_TRUE(table.rows.empty());
}

struct BadHeader {
  const char* text;
  Texts defects;
};

class ReceiversHeader : public ::testing::TestWithParam<BadHeader> {};

TEST_P(ReceiversHeader, IsRefused) {
  const Table table = Read(GetParam().text);
  EXPECT_FALSE(table.header_ok);
  EXPECT_EQ(table.defects, GetParam().defects);
}

INSTANTIATE_TEST_SUITE_P(
    Receivers, ReceiversHeader,
    ::testing::Values(
        BadHeader{"",
                  {"t.csv:1: error: no header; expected the columns "
                   "x,y,z,nx,ny,nz"}},
        BadHeader{"x,y,z,nx,ny\n",
                  {"t.csv:1: error: the header lacks the column nz; expected "
                   "names like x,y,z,nx,ny,nz with commas between (or "
                   "semicolons, tabs, blanks), found "
                   "'x,y,z,nx,ny'"}},
        BadHeader{"\nX,y,z\n",
                  {"t.csv:2: error: the header lacks the columns nx, ny, nz; "
                   "expected names like x,y,z,nx,ny,nz with commas between (or "
                   "semicolons, tabs, blanks), found 'X,y,z'"}},
        BadHeader{"0,0,0,0,0,1,2\n",
                  {"t.csv:1: error: the header lacks the columns x, y, z, nx, "
                   "ny, nz; expected names like x,y,z,nx,ny,nz with commas "
                   "between (or semicolons, tabs, blanks), found "
                   "'0,0,0,0,0,1,2'"}},
        BadHeader{"x,y,z,nx,ny,nz, x\n",
                  {"t.csv:1: error: column 'x' stands twice"}},
        BadHeader{"x,y,z,nx,ny,nz,on_face,on_face\n",
                  {"t.csv:1: error: column 'on_face' stands twice"}},
        BadHeader{"x,y,z,nx,ny,nz,E_r,\"bound_g\"\n",
                  {"t.csv:1: error: column 'E_r' has the name of a result; "
                   "rename it",
                   "t.csv:1: error: column 'bound_g' has the name of a "
                   "result; rename it"}},
        BadHeader{"\"x,y,z,nx,ny,nz\n",
                  {"t.csv:1: error: this quote is never closed"}}));

TEST(Receivers, EveryDefectOfARowIsReportedAndTheNextRowIsRead) {
  const std::string header = "x,y,z,nx,ny,nz,on_face\n";
  const std::string good = "0,0,0,0,0,1,\n";
  const Table table = Read(header +
                           "a,inf,0x1,1e999,,nan,0\n"
                           "0,0,0,0,-0,1e-400,8\n"
                           "0,0,0,0,0,1\n"
                           "0,0,0,0,0,1,,\n"
                           "0,0,0,0,0,1,1.5\n"
                           "0,0,0,0,0,1,-1\n" +
                           good);
  const auto bad_number = [](const char* what) {
    return std::string("t.csv:2: error: ") + what +
           " is not a number; expected a decimal number in the range of "
           "binary64";
  };
  // NOLINTBEGIN(bugprone-suspicious-missing-comma): long lines
  EXPECT_EQ(
      table.defects,
      (Texts{bad_number("x: 'a'"), bad_number("y: 'inf'"),
             bad_number("z: '0x1'"), bad_number("nx: '1e999'"),
             bad_number("ny: ''"), bad_number("nz: 'nan'"),
             "t.csv:2: error: on_face: '0' is out of range; the scene has 7 "
             "faces",
             "t.csv:3: error: the normal is zero",
             "t.csv:3: error: on_face: '8' is out of range; the scene has 7 "
             "faces",
             "t.csv:4: error: 6 fields, but the header has 7",
             "t.csv:5: error: 8 fields, but the header has 7",
             "t.csv:6: error: on_face: '1.5' is not the number of a face, the "
             "name of an object or group, or auto",
             "t.csv:7: error: on_face: '-1' is out of range; the scene has 7 "
             "faces"}));
  // NOLINTEND(bugprone-suspicious-missing-comma)
  EXPECT_EQ(table.rows.size(), 1U);
}

TEST(Receivers, MessagesStayOnOneLine) {
  const Table table = Read("x,y,z,nx,ny,nz\n\"1\n2\",0,0,0,0,1\n");
  ASSERT_EQ(table.defects.size(), 1U);
  EXPECT_EQ(table.defects[0].find('\n'), std::string::npos);
  EXPECT_NE(table.defects[0].find("'1\\x0a2'"), std::string::npos);
}

}  // namespace
}  // namespace truelux
