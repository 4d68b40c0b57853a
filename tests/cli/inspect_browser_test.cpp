// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of truelux inspect in a browser: Chromium without a window.

#include <cstdio>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "cli/browser.h"
#include "cli/program.h"
#include "support/well_formed.h"

namespace truelux::test {
namespace {

using testing::CountOf;

class InspectInBrowser : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    browser_ = Browser();
    if (browser_.empty()) {
      std::puts("NOT TESTED: no Chromium found, the picture was not opened");
      GTEST_SKIP() << "no Chromium found, the picture was not opened";
    }
    const Outcome outcome = RunTruelux(
        {"inspect", std::string(TRUELUX_EXAMPLES) + "/scenes/cornell_box.obj",
         "--at", "231,0,288", "--normal", "0,1,0", "--on-face", "1",
         "--projection", GetParam(), "-o", folder_ / "v.svg"});
    ASSERT_EQ(outcome.exit_status, 0) << outcome.err;
  }

  TemporaryFolder folder_;
  std::string browser_;
};

TEST_P(InspectInBrowser, AStrictParserFindsAllParts) {
  const std::string dom =
      OpenInBrowser(browser_, folder_, "--dump-dom", "v.svg");
  EXPECT_EQ(CountOf(dom, "parsererror"), 0U) << dom;
  EXPECT_EQ(CountOf(dom, "<path fill="), 10U);  // regions
  EXPECT_EQ(CountOf(dom, "id=\"vertices\""), 1U);
  EXPECT_NE(dom.find("source face 2"), dom.npos);
}

TEST_P(InspectInBrowser, ThereIsSomethingToSee) {
  const std::string picture = folder_ / "v.png";
  const std::string ignored = OpenInBrowser(
      browser_, folder_,
      "--window-size=1200,830 --screenshot='" + picture + "'", "v.svg");
  const std::string png = ReadFile(picture);
  EXPECT_EQ(png.substr(0, 4), "\x89PNG");
  // A white page of this size takes some 5,000 bytes.
  EXPECT_GT(png.size(), 50000U);
}

INSTANTIATE_TEST_SUITE_P(Projections, InspectInBrowser,
                         ::testing::Values("nusselt", "gnomonic"),
                         [](const auto& projection) {
                           return std::string(projection.param);
                         });

}  // namespace
}  // namespace truelux::test
