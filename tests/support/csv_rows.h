// SPDX-License-Identifier: GPL-3.0-or-later
// Tables without quotes, field by field.

#ifndef TRUELUX_TESTS_SUPPORT_CSV_ROWS_H_
#define TRUELUX_TESTS_SUPPORT_CSV_ROWS_H_

#include <sstream>
#include <string>
#include <vector>

namespace truelux::testing {

/// The fields of each line.
inline std::vector<std::vector<std::string>> RowsOf(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    std::vector<std::string>& fields = rows.emplace_back(1);
    for (const char c : line) {
      if (c == ',') {
        fields.emplace_back();
      } else {
        fields.back() += c;
      }
    }
  }
  return rows;
}

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_SUPPORT_CSV_ROWS_H_
