// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/io/quoted.h"

#include <algorithm>
#include <cstddef>

#include "base/shortest_decimal.h"
#include "base/visible_text.h"

namespace truelux {
namespace {

constexpr std::size_t kLongest = 40;

bool IsInsideCharacter(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;  // UTF-8
}

}  // namespace

std::string Quoted(std::string_view word) {
  std::size_t size = std::min(word.size(), kLongest);
  while (size > 0 && size < word.size() && IsInsideCharacter(word[size])) {
    --size;
  }
  std::string quoted = "'" + Visible(word.substr(0, size));
  quoted.append(size < word.size() ? "...'" : "'");
  return quoted;
}

std::string Shown(std::string_view name) {
  const bool is_printable = std::ranges::none_of(name, IsControl);
  return is_printable && name.size() <= kLongest ? std::string(name)
                                                 : Quoted(name);
}

std::string NumberInText(double value) {
  std::string text;
  AppendShortestDecimal(text, value);
  return text;
}

}  // namespace truelux
