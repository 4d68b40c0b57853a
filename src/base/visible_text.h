// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of users on one line.

#ifndef TRUELUX_BASE_VISIBLE_TEXT_H_
#define TRUELUX_BASE_VISIBLE_TEXT_H_

#include <string>
#include <string_view>

namespace truelux {

/// Whether a byte is an ASCII control character.
inline bool IsControl(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte < 0x20 || byte == 0x7F;
}

/// The text with control characters as \xHH, so that it stays on one line and
/// does nothing to a terminal.
inline std::string Visible(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string visible;
  for (const char c : text) {
    if (!IsControl(c)) {
      visible += c;
      continue;
    }
    const auto byte = static_cast<unsigned char>(c);
    visible += "\\x";
    visible += kDigits[byte >> 4U];
    visible += kDigits[byte & 0xFU];
  }
  return visible;
}

}  // namespace truelux

#endif  // TRUELUX_BASE_VISIBLE_TEXT_H_
