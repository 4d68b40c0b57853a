// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/svg.h"

#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "draw/label_layout.h"
#include "draw/svg_axis.h"
#include "support/well_formed.h"
#include "text/number_text.h"

namespace truelux {
namespace {

using testing::MarkupDefect;

TEST(Svg, TextsAreEscaped) {
  EXPECT_EQ(EscapedXml("a<b & \"c\">\n"), "a&lt;b &amp; &quot;c&quot;&gt; ");
  EXPECT_EQ(MarkupDefect(SvgText(1, 2, "end", 12, "<&>\"\x01")), "");
  EXPECT_EQ(EscapedXml("caf\u00e9"), "caf\u00e9");
  for (const char* latin : {"caf\xE9", "\xE9t\xE9", "\xC3", "\xC0\x80"}) {
    EXPECT_EQ(EscapedXml(latin).find_first_of("\xE9\xC3\xC0"),
              std::string::npos);
  }
  EXPECT_EQ(SvgText(1, 2, "end", 12, "a"),
            "<text x=\"1.0\" y=\"2.0\" text-anchor=\"end\" font-size=\"12\">a"
            "</text>\n");
}

TEST(Svg, TextsThatAreUtf8StayAsTheyAre) {
  for (const char* text :
       {"\xC2\xA0", "\xDF\xBF", "\xE0\xA0\x80", "\xED\x9F\xBF",  // U+D7FF
        "\xEE\x80\x80", "\xEF\xBF\xBD", "\xF0\x90\x80\x80",
        "\xF4\x8F\xBF\xBD"}) {  // U+10FFFD
    EXPECT_EQ(EscapedXml(text), text);
  }
}

TEST(Svg, WhatIsNoCharacterIsReplaced) {
  for (const char* text : {"\xEF\xBF\xBE", "\xEF\xBF\xBF", "\xEF\xB7\x90",
                           "\xF0\x9F\xBF\xBE", "\xF4\x8F\xBF\xBF"})
    EXPECT_EQ(EscapedXml(text), "\uFFFD");
  for (const char* text : {"\x01", "\x1F", "\x7F", "\xC2\x80", "\xC2\x9F"})
    EXPECT_EQ(EscapedXml(text), " ");
}

TEST(Svg, BytesThatAreNotAsciiAreReplacedIfAnyIsNotUtf8) {
  struct Case {
    const char* text;
    std::size_t replaced;
  };

  const std::vector<Case> cases = {
      {"\xC0\x80", 2},          // overlong, two to four bytes
      {"\xC1\xBF", 2},          //
      {"\xE0\x9F\xBF", 3},      //
      {"\xF0\x8F\xBF\xBF", 4},  //
      {"\xED\xA0\x80", 3},      // surrogates U+D800 and U+DFFF
      {"\xED\xBF\xBF", 3},      //
      {"\xC3", 1},              // truncated
      {"\xE2\x82", 2},          //
      {"\xF0\x9F\x98", 3},      //
      {"\x80", 1},              // a continuation alone
      {"\xF4\x90\x80\x80", 4},  // U+110000
      {"\xF8\x90\x80\x80", 4},  // no byte of UTF-8 is above F4
      {"\xFF", 1},              //
  };
  std::string replacement;
  for (const Case& c : cases) {
    replacement.clear();
    for (std::size_t i = 0; i < c.replaced; ++i)
      replacement += "\uFFFD";
    const std::string bad = c.text;
    EXPECT_EQ(EscapedXml("<" + bad + "a"), "&lt;" + replacement + "a");
    EXPECT_EQ(EscapedXml(bad), replacement);
    // Good characters beside bad ones go, too.
    EXPECT_EQ(EscapedXml("\u00e9" + bad), "\uFFFD\uFFFD" + replacement);
  }
}

TEST(Svg, SeriesHaveTheirOwnMarkers) {
  std::set<std::string> markers;
  for (std::size_t series = 0; series < 21; ++series) {
    for (const MarkerFill fill : {MarkerFill::kSolid, MarkerFill::kHollow}) {
      const std::string marker = SvgMarker(10, 10, series, fill);
      EXPECT_EQ(MarkupDefect(marker), "");
      markers.insert(marker);
    }
  }
  EXPECT_EQ(markers.size(), 42U);
}

TEST(Axis, CoversWholeDecadesWithRoom) {
  DecadeAxis axis;
  axis.Cover(3);
  EXPECT_EQ(axis.low, 0);
  EXPECT_EQ(axis.high, 1);
  axis.Cover(1e-3);  // room below makes another decade
  EXPECT_EQ(axis.low, -4);
  EXPECT_DOUBLE_EQ(axis.At(1e-4), 0);
  EXPECT_DOUBLE_EQ(axis.At(10), 1);
  EXPECT_DOUBLE_EQ(axis.At(0.1), 0.6);
}

TEST(Axis, TimesHaveHandyUnits) {
  EXPECT_EQ(TimeLabel(-1), "100 ns");
  EXPECT_EQ(TimeLabel(0), "1 \u00b5s");
  EXPECT_EQ(TimeLabel(4), "10 ms");
  EXPECT_EQ(TimeLabel(6), "1 s");
  EXPECT_EQ(TimeLabel(9), "1000 s");
}

TEST(Numbers, AreShortForPeople) {
  EXPECT_EQ(ScientificText(3.2e-5, 0), "3e-5");
  EXPECT_EQ(ScientificText(1.234e-16, 1), "1.2e-16");
  EXPECT_EQ(ScientificText(1, 0), "1");
  EXPECT_EQ(ScientificText(3.46, 1), "3.5");
  EXPECT_EQ(ScientificText(6e20, 1), "6.0e20");
  EXPECT_EQ(ScientificText(0, 1), "0");
  EXPECT_EQ(ScientificText(HUGE_VAL, 1), "inf");
  EXPECT_EQ(TimeText(0.0004), "0.40 ns");
  EXPECT_EQ(TimeText(0.76), "760 ns");
  EXPECT_EQ(TimeText(14.84), "14.8 \u00b5s");
  EXPECT_EQ(TimeText(0.9996), "1.00 \u00b5s");
  EXPECT_EQ(TimeText(2.5e9), "2500 s");
}

TEST(Labels, KeepOffEachOtherAndInTheFrame) {
  LabelLayout layout({0, 0, 200, 100});
  const auto first = layout.Place(100, 50, "label", 10);
  const auto second = layout.Place(100, 50, "label", 10);
  ASSERT_TRUE(first && second);
  EXPECT_TRUE(first->x != second->x || first->y != second->y);
  EXPECT_STREQ(first->anchor, "start");
  const auto at_edge = layout.Place(195, 20, "label", 10);
  ASSERT_TRUE(at_edge);
  EXPECT_STREQ(at_edge->anchor, "end");
}

TEST(Labels, AreDroppedWhereThereIsNoRoom) {
  LabelLayout layout({0, 0, 200, 100});
  layout.Avoid({0, 0, 200, 100});
  EXPECT_FALSE(layout.Place(100, 50, "label", 10).has_value());
}

TEST(Markup, DefectsAreFound) {
  EXPECT_EQ(MarkupDefect("<a><b x=\"1\"/></a>"), "");
  for (const char* text :
       {"<a>", "<a></b>", "<a x=1/>", "<a>&nbsp;</a>", "<a>&</a>", "<a/><b/>",
        "<a x=\"1\" x=\"2\"/>", "x<a/>", "<a><</a>"}) {
    EXPECT_NE(MarkupDefect(text), "") << text;
  }
}

}  // namespace
}  // namespace truelux
