#include "cli/option_values.h"

#include <cmath>
#include <fmt/format.h>

#include "truelux/io.h"

#include "cli/messages.h"

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

}  // namespace truelux
