// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/html_report.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "study/comparison_csv.h"
#include "support/well_formed.h"

namespace truelux {
namespace {

using testing::CountOf;
using testing::MarkupDefect;

constexpr std::size_t kReceivers = 12;

/// Dark receivers first, then lit ones, then a large value.
Comparison Empty() {
  Comparison comparison;
  comparison.scene = "a<b & \"c\".obj";
  comparison.processor = "processor <1>";
  for (std::size_t i = 0; i < kReceivers; ++i) {
    comparison.receivers.push_back(
        {{0.1 * static_cast<double>(i), 0, 0}, {0, 0, 1}, 0});
    const double e = i < 2 ? 0 : i == 11 ? 1e30 : 0.125;
    comparison.truth.push_back({e, 2 * e, 0});
    comparison.reasons.push_back("penumbra, <3 arcs>");
  }
  return comparison;
}

/// A method whose error is about `error` at every lit receiver.
void AddMethod(Comparison& comparison, const std::string& name,
               const std::string& group, double microseconds, double error) {
  MethodResult method;
  method.name = name;
  method.group = group;
  method.microseconds = microseconds;
  for (const Rgb& e : comparison.truth)
    method.values.emplace_back(Rgb{e[0] * (1 + error), e[1], e[2]});
  comparison.methods.push_back(method);
}

/// About seventy methods, four arithmetics of each formula, as a long run has.
Comparison Crowded() {
  Comparison comparison = Empty();
  AddMethod(comparison, "certified", "truelux", 6, 0);
  const char* arithmetics[] = {"float", "double", "double-double", "MPFR"};
  for (int f = 0; f < 14; ++f) {
    for (int a = 0; a < 4; ++a) {
      const double error = std::pow(10.0, -6 - 8 * a) * (1 + f * f);
      AddMethod(comparison, fmt::format("formula-{} {}", f, arithmetics[a]),
                fmt::format("formula, {}", arithmetics[a]),
                (1 + 0.3 * f) * std::pow(4.0, a), a > 1 ? 0 : error);
    }
  }
  for (const int rays : {16, 64, 256, 1024, 4096}) {
    AddMethod(comparison, fmt::format("rays {}", rays), "rays", 0.1 * rays,
              0.5 / rays);
  }
  comparison.absent = {"other <method>: not there"};
  return comparison;
}

TEST(HtmlReport, IsWellFormed) {
  EXPECT_EQ(MarkupDefect(HtmlReport(Crowded())), "");
}

TEST(HtmlReport, NeedsNothingFromOutside) {
  const std::string html = HtmlReport(Crowded());
  for (const char* part : {"<script", "<link", "src=", "@import", "url("})
    EXPECT_EQ(CountOf(html, part), 0U) << part;
  // What looks like addresses are names of languages.
  EXPECT_EQ(CountOf(html, "http"), CountOf(html, "xmlns=\"http://www.w3.org/"));
}

TEST(HtmlReport, HasOneMarkRowAndHistogramPerMethod) {
  const Comparison comparison = Crowded();
  const std::size_t methods = comparison.methods.size();
  const std::string html = HtmlReport(comparison);
  EXPECT_EQ(CountOf(html, "class=\"mark\""), methods);
  EXPECT_EQ(CountOf(html, "class=\"histogram\""), methods);
  const std::size_t table = html.find("<table id=\"methods\">");
  const std::string rows =
      html.substr(table, html.find("</table>", table) - table);
  EXPECT_EQ(CountOf(rows, "<tr"), methods + 1);
  EXPECT_EQ(CountOf(html, "<li>other &lt;method&gt;: not there</li>"), 1U);
}

TEST(HtmlReport, ShowsWhatIsExactAndWhatIsNoNumber) {
  Comparison comparison = Empty();
  AddMethod(comparison, "right", "a", 3, 0);
  std::string html = HtmlReport(comparison);
  EXPECT_EQ(CountOf(html, "<title>right: 3.00 \u00b5s, exact</title>"), 1U);
  EXPECT_EQ(CountOf(html, ">no number</text>"), 0U);
  EXPECT_EQ(CountOf(html, "Exact wherever it has a value."), 1U);
  AddMethod(comparison, "broken", "b", 2, std::nan(""));
  html = HtmlReport(comparison);
  EXPECT_EQ(MarkupDefect(html), "");
  EXPECT_EQ(CountOf(html, ">no number</text>"), 1U);
}

TEST(HtmlReport, SaysWhatHasNoValueAnywhere) {
  Comparison comparison = Empty();
  AddMethod(comparison, "right", "a", 3, 0);
  AddMethod(comparison, "refusing", "b", 1, 0);
  std::ranges::fill(comparison.methods.back().values, std::nullopt);
  const std::string html = HtmlReport(comparison);
  EXPECT_EQ(MarkupDefect(html), "");
  EXPECT_EQ(CountOf(html, "class=\"mark\""), 1U);
  EXPECT_EQ(CountOf(html, "No value at any receiver: refusing."), 1U);
}

TEST(HtmlReport, OfADarkSceneIsAReportToo) {
  Comparison comparison = Empty();
  std::ranges::fill(comparison.truth, Rgb{});
  AddMethod(comparison, "right", "a", 3, 0);
  AddMethod(comparison, "bright", "b", 3, 0);
  std::ranges::fill(comparison.methods.back().values, Rgb{1, 1, 1});
  const std::string html = HtmlReport(comparison);
  EXPECT_EQ(MarkupDefect(html), "");
  EXPECT_EQ(CountOf(html, "class=\"mark\""), 2U);
  EXPECT_GE(CountOf(html, ">false light</td>"), 10U);
}

TEST(HtmlReport, SetsDifferingDigitsApart) {
  Comparison comparison = Empty();
  AddMethod(comparison, "near", "a", 3, 0x1p-52);
  const std::string html = HtmlReport(comparison);
  EXPECT_GE(CountOf(html, "0.125<span class=\"off\">00000000000003</span>"), 1U)
      << html;
}

TEST(HtmlReport, SetsAllDigitsOfAWrongZeroApart) {
  Comparison comparison = Empty();
  AddMethod(comparison, "dark", "a", 3, -1);
  EXPECT_GE(CountOf(HtmlReport(comparison), "<span class=\"off\">0</span>"),
            1U);
}

TEST(ComparisonCsv, HasARowPerMethodAndPerReceiver) {
  Comparison comparison = Crowded();
  comparison.methods[1].values[4].reset();
  const std::string methods = MethodsCsv(comparison);
  EXPECT_EQ(CountOf(methods, "\n"), comparison.methods.size() + 1);
  EXPECT_EQ(CountOf(methods, "\nformula-0 float,\"formula, float\",1,11,0,9,"),
            1U)
      << methods;
  const std::string receivers = ReceiversCsv(comparison);
  EXPECT_EQ(CountOf(receivers, "\n"), kReceivers + 1);
  EXPECT_EQ(receivers.find("receiver,x,y,z,nx,ny,nz,on_face,E_r,E_g,E_b,reason,"
                           "certified: mean E,certified: relative error,"),
            0U);
  EXPECT_EQ(CountOf(receivers,
                    "\n5,0.4,0,0,0,0,1,,0.125,0.25,0,\"penumbra, <3 arcs>\","
                    "0.125,0,,,"),
            1U)
      << receivers;
}

TEST(ComparisonCsv, QuotesWhatNeedsIt) {
  EXPECT_EQ(CsvField("plain text"), "plain text");
  EXPECT_EQ(CsvField("a,b"), "\"a,b\"");
  EXPECT_EQ(CsvField("say \"a\""), "\"say \"\"a\"\"\"");
}

}  // namespace
}  // namespace truelux
