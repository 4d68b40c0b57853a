// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/browser.h"

#include <cstdio>
#include <stdexcept>

namespace truelux::test {
namespace {

/// What a shell command prints.
std::string OutputOf(const std::string& command) {
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("popen");
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
    text += static_cast<char>(c);
  pclose(pipe);
  return text;
}

}  // namespace

std::string Browser() {
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
    const std::string found =
        OutputOf(std::string("command -v ") + name + " 2>/dev/null");
    if (!found.empty()) return name;
  }
  return "";
}

std::string OpenInBrowser(const std::string& browser,
                          const TemporaryFolder& folder,
                          const std::string& options, const std::string& file) {
  return OutputOf("timeout 50 " + browser +
                  " --headless --no-sandbox --disable-gpu"
                  " --disable-dev-shm-usage --user-data-dir='" +
                  folder / "profile" + "' " + options + " 'file://" +
                  folder / file + "' 2>/dev/null");
}

}  // namespace truelux::test
