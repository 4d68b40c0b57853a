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

void AppendVisibly(char c, std::string& text) {
  const auto byte = static_cast<unsigned char>(c);
  if (byte >= 0x20 && byte != 0x7F) {
    text += c;
    return;
  }
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

std::string NumberInText(double value) {
  std::string text;
  AppendShortestDecimal(text, value);
  return text;
}

}  // namespace truelux
