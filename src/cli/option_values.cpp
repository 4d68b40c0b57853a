// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/option_values.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>

#include "truelux/io.h"

#include "run/user_error.h"
#include "text/csv.h"

namespace truelux {

std::string PathValue(const char* name,
                      const std::optional<std::string>& word) {
  if (word && word->empty()) {
    throw UsageError(fmt::format("{}: the file name is empty", name));
  }
  return word.value_or("");
}

std::int64_t WholeNumberValue(const char* option, const std::string& text,
                              std::int64_t low, std::int64_t high) {
  const std::optional<double> number = ParseNumber(text);
  if (!number || *number < static_cast<double>(low) ||
      *number > static_cast<double>(high) || *number != std::floor(*number)) {
    throw UsageError(fmt::format("{}: '{}' is not a whole number from {} to {}",
                                 option, text, low, high));
  }
  return static_cast<std::int64_t>(*number);
}

double SizeValue(const char* option, const std::string& text) {
  const std::optional<double> number = ParseNumber(text);
  if (!number || *number < 0) {
    throw UsageError(
        fmt::format("{}: '{}' is not a number from 0 upwards", option, text));
  }
  return *number;
}

std::array<std::string, 3> TripleTexts(const char* option,
                                       const std::string& text) {
  if (std::ranges::count(text, ',') != 2) {
    throw UsageError(fmt::format(
        "{}: '{}' is not three numbers with commas in between", option, text));
  }
  const std::size_t first = text.find(',');
  const std::size_t second = text.rfind(',');
  return {text.substr(0, first), text.substr(first + 1, second - first - 1),
          text.substr(second + 1)};
}

std::array<double, 3> TripleValue(const char* option, const std::string& text) {
  std::array<double, 3> values{};
  const std::array<std::string, 3> texts = TripleTexts(option, text);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::optional<double> number = ParseNumber(TrimBlanks(texts[i]));
    if (!number) {
      throw UsageError(
          fmt::format("{}: '{}' is not a number", option, texts[i]));
    }
    values[i] = *number;
  }
  return values;
}

}  // namespace truelux
