// SPDX-License-Identifier: GPL-3.0-or-later
// Chromium without a window, to see whether pages and pictures open.

#ifndef TRUELUX_TESTS_CLI_BROWSER_H_
#define TRUELUX_TESTS_CLI_BROWSER_H_

#include <string>

#include "cli/program.h"

namespace truelux::test {

/// The browser's command, or "".
std::string Browser();

/// Runs the browser on a file of a folder, at most 50 seconds; what it prints.
std::string OpenInBrowser(const std::string& browser,
                          const TemporaryFolder& folder,
                          const std::string& options, const std::string& file);

}  // namespace truelux::test

#endif  // TRUELUX_TESTS_CLI_BROWSER_H_
