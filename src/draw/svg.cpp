// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/svg.h"

#include <array>
#include <fmt/format.h>
#include <iterator>
#include <utf8.h>

namespace truelux {
namespace {

constexpr std::array<const char*, 7> kColours = {
    "#d55e00", "#0072b2", "#009e73", "#cc79a7",
    "#e69f00", "#56b4e9", "#555555"};

/// kHanging: a triangle that points down.
enum class Shape { kCircle, kSquare, kTriangle, kDiamond, kCross, kHanging };

/// Series with the same colour differ in shape, and the first seven, which
/// differ in colour, have the plainest shapes.
Shape ShapeOf(std::size_t series) {
  const std::size_t cycle = series / kColours.size();
  return static_cast<Shape>(series % 3 + (cycle % 2 == 1 ? 3 : 0));
}

/// The attributes that fill a marker; a hollow one covers what is below it.
std::string FillAttributes(std::size_t series, MarkerFill fill) {
  const char* colour = SeriesColour(series);
  if (fill == MarkerFill::kSolid) return fmt::format("fill=\"{}\"", colour);
  return fmt::format("fill=\"#ffffff\" stroke=\"{}\" stroke-width=\"1.5\"",
                     colour);
}

constexpr char32_t kReplacement = U'\xFFFD';

/// Controls may not stand in XML, those from 0x80 on not in HTML.
bool IsControl(char32_t c) {
  return c < 0x20 || (c >= 0x7F && c < 0xA0);
}

/// Numbers that Unicode keeps for no character, U+FFFE in every plane among
/// them.
bool IsNoCharacter(char32_t c) {
  return (c & 0xFFFEU) == 0xFFFEU || (c >= 0xFDD0 && c <= 0xFDEF);
}

}  // namespace

std::string EscapedXml(std::string_view text) {
  std::string escaped;
  const bool is_utf8 = utf8::is_valid(text.begin(), text.end());
  for (auto at = text.begin(); at != text.end();) {
    const bool is_ascii = static_cast<unsigned char>(*at) < 0x80U;
    const char32_t c = is_utf8    ? utf8::next(at, text.end())
                       : is_ascii ? static_cast<unsigned char>(*at++)
                                  : (++at, kReplacement);
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        utf8::append(IsControl(c)       ? U' '
                     : IsNoCharacter(c) ? kReplacement
                                        : c,
                     std::back_inserter(escaped));
    }
  }
  return escaped;
}

std::string SvgText(double x, double y, const char* anchor, int size,
                    std::string_view text, std::string_view more) {
  return fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"{}\""
      "{}>{}</text>\n",
      x, y, anchor, size, more, EscapedXml(text));
}

std::string SvgLine(double x1, double y1, double x2, double y2,
                    const char* colour) {
  return fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\""
      " stroke=\"{}\"/>\n",
      x1, y1, x2, y2, colour);
}

const char* SeriesColour(std::size_t series) {
  return kColours[series % kColours.size()];
}

std::string SvgMarker(double x, double y, std::size_t series, MarkerFill fill) {
  const std::string style = FillAttributes(series, fill);
  constexpr double kHalf = 4.5;
  switch (ShapeOf(series)) {
    case Shape::kCircle:
      return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" {}/>\n",
                         x, y, kHalf, style);
    case Shape::kSquare:
      return fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{}\" {}/>\n",
          x - kHalf, y - kHalf, 2 * kHalf, 2 * kHalf, style);
    case Shape::kTriangle:
      return fmt::format("<path d=\"M {:.1f} {:.1f} l {} {} h {} z\" {}/>\n", x,
                         y - kHalf, kHalf, 2 * kHalf, -2 * kHalf, style);
    case Shape::kDiamond:
      return fmt::format(
          "<path d=\"M {:.1f} {:.1f} l 5.5 5.5 l -5.5 5.5 l -5.5 -5.5 z\""
          " {}/>\n",
          x, y - 5.5, style);
    case Shape::kCross:
      return fmt::format(
          "<path d=\"M {:.1f} {:.1f} h 4 v 3.5 h 3.5 v 4 h -3.5 v 3.5 h -4"
          " v -3.5 h -3.5 v -4 h 3.5 z\" {}/>\n",
          x - 2, y - 5.5, style);
    case Shape::kHanging:
      break;
  }
  return fmt::format("<path d=\"M {:.1f} {:.1f} l {} {} h {} z\" {}/>\n", x,
                     y + kHalf, kHalf, -2 * kHalf, -2 * kHalf, style);
}

}  // namespace truelux
