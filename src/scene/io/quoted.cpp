// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/io/quoted.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "base/shortest_decimal.h"

namespace truelux {
namespace {

constexpr std::size_t kLongest = 40;

bool IsInsideCharacter(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;  // UTF-8
}

bool IsControl(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte < 0x20 || byte == 0x7F;
}

void AppendVisibly(char c, std::string& text) {
  if (!IsControl(c)) {
    text += c;
    return;
  }
  const auto byte = static_cast<unsigned char>(c);
  constexpr std::array kDigits = {'0', '1', '2', '3', '4', '5', '6', '7',
                                  '8', '9', 'a', 'b', 'c', 'd', 'e', 'f'};
  text.append("\\x");
  text += kDigits[byte >> 4U];
  text += kDigits[byte & 0xFU];
}

}  // namespace

std::string Quoted(std::string_view word) {
  std::size_t size = std::min(word.size(), kLongest);
  while (size > 0 && size < word.size() && IsInsideCharacter(word[size])) {
    --size;
  }
  std::string quoted("'");
  for (const char c : word.substr(0, size))
    AppendVisibly(c, quoted);
  quoted.append(size < word.size() ? "...'" : "'");
  return quoted;
}

std::string Shown(std::string_view name) {
  const bool is_printable = std::ranges::none_of(name, IsControl);
  return is_printable && name.size() <= kLongest ? std::string(name)
                                                 : Quoted(name);
}

std::string VisiblePath(std::string_view path) {
  std::string text;
  for (const char c : path)
    AppendVisibly(c, text);
  return text;
}

std::string NumberInText(double value) {
  std::string text;
  AppendShortestDecimal(text, value);
  return text;
}

}  // namespace truelux
