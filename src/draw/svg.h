// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of SVG pictures, as text. Coordinates are in pixels, y downwards.

#ifndef TRUELUX_DRAW_SVG_H_
#define TRUELUX_DRAW_SVG_H_

#include <cstddef>
#include <string>
#include <string_view>

namespace truelux {

/// The text with &, <, > and quotes written so that XML and HTML read it back.
/// Controls, which XML or HTML do not allow, become blanks, and what is no
/// character of Unicode U+FFFD; if the text is no UTF-8, every byte of it that
/// is not ASCII becomes U+FFFD.
std::string EscapedXml(std::string_view text);

/// A text at a point. anchor: "start", "middle" or "end"; more: further
/// attributes, with a blank before each.
std::string SvgText(double x, double y, const char* anchor, int size,
                    std::string_view text, std::string_view more = "");

std::string SvgLine(double x1, double y1, double x2, double y2,
                    const char* colour);

/// The colour of a series; most colour-blind readers can tell them apart
/// (Okabe and Ito). More than seven series repeat colours with other markers.
const char* SeriesColour(std::size_t series);

enum class MarkerFill { kSolid, kHollow };

/// A marker whose shape and colour belong to the series.
std::string SvgMarker(double x, double y, std::size_t series,
                      MarkerFill fill = MarkerFill::kSolid);

}  // namespace truelux

#endif  // TRUELUX_DRAW_SVG_H_
