// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/label_layout.h"

#include <algorithm>

namespace truelux {
namespace {

/// The mean width of a character by the font's size, generously.
constexpr double kCharacterWidth = 0.56;

/// Characters, not bytes.
double CountCharacters(std::string_view text) {
  return static_cast<double>(std::ranges::count_if(text, [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

/// From the point to the label's anchor; direction: of the text from there.
struct Offset {
  double x = 0;
  double y = 0;  ///< of the middle of the text
  const char* anchor = "start";
  double first = 0;  ///< share of the text's width that is left of the anchor
};

constexpr Offset kOffsets[] = {
    {9, 0, "start", 0},     {8, -10, "start", 0},    {8, 10, "start", 0},
    {-9, 0, "end", 1},      {-8, 10, "end", 1},      {-8, -10, "end", 1},
    {0, 15, "middle", 0.5}, {0, -15, "middle", 0.5}, {9, 19, "start", 0},
    {9, -19, "start", 0},   {-9, 19, "end", 1},      {-9, -19, "end", 1}};

}  // namespace

std::optional<LabelPlace> LabelLayout::Place(double x, double y,
                                             std::string_view text,
                                             int font_size) {
  const double width = kCharacterWidth * font_size * CountCharacters(text);
  const double half_height = 0.5 * font_size;
  for (const Offset& offset : kOffsets) {
    const double left = x + offset.x - offset.first * width;
    const double middle = y + offset.y;
    const LabelBox box{left, middle - half_height, left + width,
                       middle + half_height};
    const auto overlaps = [&box](const LabelBox& b) { return b.Overlaps(box); };
    if (!frame_.Contains(box) || std::ranges::any_of(taken_, overlaps))
      continue;
    taken_.push_back(box);
    return LabelPlace{x + offset.x, middle + 0.36 * font_size, offset.anchor};
  }
  return std::nullopt;
}

}  // namespace truelux
