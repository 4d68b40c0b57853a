// SPDX-License-Identifier: GPL-3.0-or-later
// Text in the encoding that some editors call "Unicode".

#ifndef TRUELUX_BASE_UTF16_H_
#define TRUELUX_BASE_UTF16_H_

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace truelux {

/// Whether bytes are probably text in UTF-16: they begin with its byte order
/// mark, or every second one of the first is 0 and the others are not.
inline bool LooksLikeUtf16(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
    return true;
  }
  constexpr std::size_t kMost = 64;
  const std::size_t size = std::min(bytes.size(), kMost) / 2 * 2;
  if (size < 4) return false;
  const auto alternates = [&](std::size_t zero) {
    for (std::size_t i = 0; i < size; ++i) {
      if ((bytes[i] == 0) != (i % 2 == zero)) return false;
    }
    return true;
  };
  return alternates(0) || alternates(1);
}

}  // namespace truelux

#endif  // TRUELUX_BASE_UTF16_H_
