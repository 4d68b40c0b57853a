// The words of options as numbers and paths.

#ifndef TRUELUX_CLI_OPTION_VALUES_H_
#define TRUELUX_CLI_OPTION_VALUES_H_

#include <cstdint>
#include <optional>
#include <string>

namespace truelux {

/// The value of an option or argument that names a file, "" if not given.
/// Throws UsageError if it is given and empty.
std::string PathValue(const char* name, const std::optional<std::string>& word);

/// A whole number from low to high, at most 2^53. Throws UsageError for
/// anything else.
std::int64_t WholeNumberValue(const char* option, const std::string& text,
                              std::int64_t low, std::int64_t high);

/// A number >= 0. Throws UsageError for anything else.
double SizeValue(const char* option, const std::string& text);

}  // namespace truelux

#endif  // TRUELUX_CLI_OPTION_VALUES_H_
