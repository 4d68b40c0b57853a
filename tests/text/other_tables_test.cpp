// SPDX-License-Identifier: GPL-3.0-or-later
// Tables as spreadsheets and other programs write them: the same two receivers
// in every dress.

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "support/scenes.h"
#include "text/byte_source.h"
#include "text/read_rows.h"
#include "text/receivers.h"

namespace truelux {
namespace {

struct Dress {
  const char* name;
  const char* text;
  const char* header;  ///< as it goes into the output; "": none
  char separator;
};

void PrintTo(const Dress& dress, std::ostream* out) {
  *out << dress.name;
}

class OtherTable : public ::testing::TestWithParam<Dress> {};

TEST_P(OtherTable, HoldsTheSameReceivers) {
  const Dress& dress = GetParam();
  TextSource source(dress.text);
  const Scene scene = testing::SceneOf(1);
  FaceWords faces(scene);
  ReceiverReader reader(source, "t", faces);
  std::vector<ReceiverRow> rows;
  const DiagnosticList defects = ReadRows<ReceiverRow>(
      reader, "t", [&](const ReceiverRow& row) { rows.push_back(row); });
  for (const Diagnostic& d : defects.Sorted())
    ADD_FAILURE() << d.Text();
  EXPECT_EQ(reader.header(), dress.header);
  EXPECT_EQ(reader.has_header(), *dress.header != '\0');
  EXPECT_EQ(reader.separator(), dress.separator);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].receiver.position, (Point3{1.5, 0, -2}));
  EXPECT_EQ(rows[0].receiver.normal, (Vector3{0, 0, 1}));
  EXPECT_EQ(rows[1].receiver.position, (Point3{3, 4, 5}));
  EXPECT_EQ(rows[1].receiver.normal, (Vector3{0, 1, 0}));
}

INSTANTIATE_TEST_SUITE_P(
    Dresses, OtherTable,
    ::testing::Values(
        Dress{"Commas", "x,y,z,nx,ny,nz\n1.5,0,-2,0,0,1\n3,4,5,0,1,0\n",
              "x,y,z,nx,ny,nz", ','},
        Dress{"Semicolons", "x;y;z;nx;ny;nz\n1.5;0;-2;0;0;1\n3;4;5;0;1;0\n",
              "x;y;z;nx;ny;nz", ';'},
        Dress{"Tabs",
              "x\ty\tz\tnx\tny\tnz\n1.5\t0\t-2\t0\t0\t1\n3\t4\t5\t0\t1\t0\n",
              "x\ty\tz\tnx\tny\tnz", '\t'},
        Dress{"Blanks", "x y z nx  ny nz \n  1.5 0 -2 0 0 1  \n3 4\t5 0 1 0\n",
              "x y z nx  ny nz ", ' '},
        Dress{"BlanksBehindCommas",
              "x, y, z, nx, ny, nz\n1.5, 0, -2, 0, 0, 1\n3, 4, 5, 0, 1, 0\n",
              "x, y, z, nx, ny, nz", ','},
        Dress{"UpperCase", "X,Y,Z,NX,Ny,nZ\n1.5,0,-2,0,0,1\n3,4,5,0,1,0\n",
              "X,Y,Z,NX,Ny,nZ", ','},
        Dress{"SeparatorLine",
              "sep=;\r\nx;y;z;nx;ny;nz\r\n1.5;0;-2;0;0;1\r\n3;4;5;0;1;0\r\n",
              "x;y;z;nx;ny;nz", ';'},
        Dress{
            "ByteOrderMarkAndSeparatorLine",
            "\xEF\xBB\xBFsep=|\nx|y|z|nx|ny|nz\n1.5|0|-2|0|0|1\n3|4|5|0|1|0\n",
            "x|y|z|nx|ny|nz", '|'},
        Dress{"Comments",
              "# made by hand\n#\n\nx,y,z,nx,ny,nz\n1.5,0,-2,0,0,1\n# \"half\n"
              "3,4,5,0,1,0\n",
              "x,y,z,nx,ny,nz", ','},
        Dress{"QuotedSemicolons",
              "\"x\";\"y\";\"z\";\"nx\";\"ny\";\"nz\";\"a,b\"\n"
              "1.5;0;-2;0;0;1;\"2,5\"\n3;4;5;0;1;0;x\n",
              "\"x\";\"y\";\"z\";\"nx\";\"ny\";\"nz\";\"a,b\"", ';'},
        Dress{"NoHeader", "1.5 0 -2 0 0 1\n3 4 5 0 1 0\n", "", ' '},
        Dress{"NoHeaderTabs", "1.5\t0\t-2\t0\t0\t1\n3\t4\t5\t0\t1\t0\n", "",
              '\t'},
        Dress{"NoHeaderCommas", "1.5,0,-2,0,0,1\n3,4,5,0,1,0\n", "", ','},
        Dress{"NoHeaderComment", "# a grid\n1.5 0 -2 0 0 1\n3 4 5 0 1 0", "",
              ' '}),
    [](const auto& row) { return row.param.name; });

std::vector<std::string> DefectsOf(std::string_view text) {
  TextSource source(text);
  const Scene scene = testing::SceneOf(1);
  FaceWords faces(scene);
  ReceiverReader reader(source, "t", faces);
  std::vector<std::string> texts;
  const DiagnosticList defects =
      ReadRows<ReceiverRow>(reader, "t", [](const ReceiverRow& /*row*/) {});
  for (const Diagnostic& d : defects.Sorted())
    texts.push_back(d.Text());
  return texts;
}

using Texts = std::vector<std::string>;

TEST(OtherTables, DecimalCommasAreToldOnceAndCounted) {
  std::string text = "x;y;z;nx;ny;nz\n";
  for (int i = 0; i < 500; ++i)
    text += "1,5;2;3;0;0;1\n";
  text += "a;2;3;0;0;1\n";
  EXPECT_EQ(DefectsOf(text),
            (Texts{"t:2: error: decimal commas, expected decimal points: write "
                   "1.5, not 1,5 (and no thousands separators) (and 499 more "
                   "such lines)",
                   "t:502: error: x: 'a' is not a number; expected a decimal "
                   "number in the range of binary64"}));
}

TEST(OtherTables, Utf16IsNamed) {
  const Texts says{
      "t:1: error: looks like UTF-16, expected UTF-8: save it as UTF-8"};
  const std::string narrow = "x,y,z,nx,ny,nz\n0,0,0,0,0,1\n";
  std::string wide;
  for (const char c : narrow)
    wide.append({c, '\0'});
  EXPECT_EQ(DefectsOf(wide), says);
  EXPECT_EQ(DefectsOf("\xFF\xFE" + wide), says);
}

}  // namespace
}  // namespace truelux
