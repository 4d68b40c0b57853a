// SPDX-License-Identifier: GPL-3.0-or-later
// The words of options as numbers and paths.

#ifndef TRUELUX_CLI_OPTION_VALUES_H_
#define TRUELUX_CLI_OPTION_VALUES_H_

#include <array>
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

/// The texts between the commas of "x,y,z". Throws UsageError if there are not
/// three.
std::array<std::string, 3> TripleTexts(const char* option,
                                       const std::string& text);

/// The same as numbers. Throws UsageError for anything else.
std::array<double, 3> TripleValue(const char* option, const std::string& text);

}  // namespace truelux

#endif  // TRUELUX_CLI_OPTION_VALUES_H_
