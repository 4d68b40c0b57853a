// SPDX-License-Identifier: GPL-3.0-or-later
// Letters without regard to their case, in any locale.

#ifndef TRUELUX_BASE_ASCII_CASE_H_
#define TRUELUX_BASE_ASCII_CASE_H_

#include <string>
#include <string_view>

namespace truelux {

/// A text in small letters. Letters outside ASCII stay as they are.
inline std::string LowerAscii(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

}  // namespace truelux

#endif  // TRUELUX_BASE_ASCII_CASE_H_
