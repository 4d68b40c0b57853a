// SPDX-License-Identifier: GPL-3.0-or-later
// The report of truelux bench in a browser: Chromium without a window.

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "cli/browser.h"
#include "cli/program.h"
#include "support/well_formed.h"

namespace truelux::test {
namespace {

namespace fs = std::filesystem;

using testing::CountOf;

/// The part of a page from one text up to another.
std::string Between(const std::string& text, std::string_view from,
                    std::string_view to) {
  const std::size_t begin = text.find(from);
  if (begin == text.npos) return "";
  return text.substr(begin, text.find(to, begin) - begin);
}

class BenchInBrowser : public ::testing::Test {
 protected:
  void SetUp() override {
    browser_ = Browser();
    if (browser_.empty()) {
      std::puts("NOT TESTED: no Chromium found, the report was not opened");
      GTEST_SKIP() << "no Chromium found, the report was not opened";
    }
    const std::string scenes = std::string(TRUELUX_EXAMPLES) + "/scenes/";
    const Outcome outcome = RunTruelux(
        {"bench", scenes + "cornell_box.obj", scenes + "cornell_box_floor.csv",
         "-o", folder_ / "r.html", "--quick", "--receivers", "30"});
    ASSERT_EQ(outcome.exit_status, 0) << outcome.err;
  }

  /// Runs the browser on a file of the folder.
  [[nodiscard]] std::string Open(const std::string& options,
                                 const std::string& file) const {
    return OpenInBrowser(browser_, folder_, options, file);
  }

  TemporaryFolder folder_;
  std::string browser_;
};

TEST_F(BenchInBrowser, ChartAndTablesAreThere) {
  const std::string dom = Open("--dump-dom", "r.html");
  const std::size_t methods = CountOf(ReadFile(folder_ / "r.csv"), "\n") - 1;
  EXPECT_GT(methods, 5U);
  const std::string chart = Between(dom,
                                    "<svg xmlns=\"http://www.w3.org/2000/svg\" "
                                    "class=\"speed-chart\"",
                                    "</svg>");
  EXPECT_EQ(CountOf(chart, "<g class=\"mark\">"), methods) << dom;
  EXPECT_EQ(CountOf(dom, "class=\"histogram\""), methods);
  EXPECT_EQ(CountOf(Between(dom, "<table id=\"methods\">", "</table>"), "<tr"),
            methods + 1);
  EXPECT_GE(CountOf(dom, "<table class=\"worst\">"), 2U);
  EXPECT_NE(Between(dom, "<table id=\"choice\">", "</table>"), "");
}

TEST_F(BenchInBrowser, AStrictParserTakesIt) {
  fs::copy_file(folder_ / "r.html", folder_ / "r.xhtml");
  const std::string dom = Open("--dump-dom", "r.xhtml");
  EXPECT_EQ(CountOf(dom, "parsererror"), 0U) << dom;
  EXPECT_EQ(CountOf(dom, "class=\"speed-chart\""), 1U);
}

TEST_F(BenchInBrowser, ThereIsSomethingToSee) {
  const std::string picture = folder_ / "r.png";
  const std::string ignored =
      Open("--window-size=1100,900 --screenshot='" + picture + "'", "r.html");
  const std::string png = ReadFile(picture);
  EXPECT_EQ(png.substr(0, 4), "\x89PNG");
  // A white page of this size takes some 5,000 bytes.
  EXPECT_GT(png.size(), 30000U);
}

}  // namespace
}  // namespace truelux::test
