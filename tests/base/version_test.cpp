// SPDX-License-Identifier: GPL-3.0-or-later
// One version: of the headers, of the linked library, of the project.

#include "truelux/version.h"

#include <string>

#include <gtest/gtest.h>

namespace truelux {
namespace {

TEST(Version, TheLibraryHasThatOfTheHeaders) {
  EXPECT_EQ(VersionNumber(), TRUELUX_VERSION);
  EXPECT_STREQ(VersionText(), TRUELUX_VERSION_STRING);
}

TEST(Version, TheProjectHasThatOfTheHeaders) {
  EXPECT_STREQ(VersionText(), TRUELUX_PROJECT_VERSION);
}

TEST(Version, TheTextIsMadeOfTheNumbers) {
  EXPECT_EQ(std::to_string(TRUELUX_VERSION_MAJOR) + "." +
                std::to_string(TRUELUX_VERSION_MINOR) + "." +
                std::to_string(TRUELUX_VERSION_PATCH),
            TRUELUX_VERSION_STRING);
  EXPECT_EQ(VersionNumber(), TRUELUX_VERSION_MAJOR * 10000 +
                                 TRUELUX_VERSION_MINOR * 100 +
                                 TRUELUX_VERSION_PATCH);
}

}  // namespace
}  // namespace truelux
