// SPDX-License-Identifier: GPL-3.0-or-later
// The hard cases in tests/data/cases.

#ifndef TRUELUX_TESTS_SUPPORT_CASE_FILES_H_
#define TRUELUX_TESTS_SUPPORT_CASE_FILES_H_

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "truelux/io.h"

namespace truelux::testing {

inline std::filesystem::path CaseFolder(const std::string& name) {
  return std::filesystem::path(TRUELUX_TEST_DATA "/cases") / name;
}

inline std::vector<std::string> CaseNames() {
  std::vector<std::string> names;
  for (const auto& entry :
       std::filesystem::directory_iterator(TRUELUX_TEST_DATA "/cases")) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// The numbers of a CSV without quotes, below its header.
inline std::vector<std::vector<double>> ReadNumbers(
    const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  std::vector<std::vector<double>> rows;
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    std::string field;
    rows.emplace_back();
    while (std::getline(fields, field, ',')) {
      rows.back().push_back(ParseNumber(field).value());
    }
  }
  return rows;
}

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_SUPPORT_CASE_FILES_H_
