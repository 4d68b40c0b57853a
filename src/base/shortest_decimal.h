// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as the shortest text that means them.

#ifndef TRUELUX_BASE_SHORTEST_DECIMAL_H_
#define TRUELUX_BASE_SHORTEST_DECIMAL_H_

#include <array>
#include <charconv>
#include <cstddef>
#include <string>

namespace truelux {

/// Appends the shortest decimal that reads back to the same binary64; "inf",
/// "-inf", "nan" or "-nan" where there is none.
inline void AppendShortestDecimal(std::string& text, double value) {
  // Enough for the longest, such as -2.2250738585072014e-308.
  constexpr std::size_t kMostChars = 32;
  std::array<char, kMostChars> buffer{};
  const std::to_chars_result end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  text.append(buffer.data(), end.ptr);
}

}  // namespace truelux

#endif  // TRUELUX_BASE_SHORTEST_DECIMAL_H_
