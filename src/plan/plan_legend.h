// SPDX-License-Identifier: GPL-3.0-or-later
// What stands beside a plan: levels, kinds of lines, a scale bar, what is proven.

#ifndef TRUELUX_PLAN_PLAN_LEGEND_H_
#define TRUELUX_PLAN_PLAN_LEGEND_H_

#include <string>
#include <string_view>

#include "truelux/isolux.h"

#include "plan/object_drawing.h"
#include "plan/plan_subject.h"

namespace truelux {

/// Elements of SVG, and how much room they take.
struct LegendDrawing {
  std::string elements;
  double bottom = 0;  ///< [px]
};

// How marks look, in the plan and beside it.
inline constexpr const char* kKinkStyle =
    "fill=\"none\" stroke=\"#8a8a8a\" stroke-width=\"0.6\" "
    "stroke-dasharray=\"4 3\"";
inline constexpr const char* kJumpStyle =
    "fill=\"none\" stroke=\"#7d7d7d\" stroke-width=\"4\" "
    "stroke-linecap=\"round\"";
inline constexpr const char* kOpenStyle =
    "fill=\"#e00000\" fill-opacity=\"0.35\" stroke=\"#e00000\" "
    "stroke-opacity=\"0.35\" stroke-width=\"1\" stroke-linejoin=\"round\"";
inline constexpr const char* kRingStyle =
    "fill=\"none\" stroke=\"#e00000\" stroke-width=\"1\"";
inline constexpr const char* kOutlineStyle =
    "fill=\"none\" stroke=\"#000000\" stroke-width=\"1.2\" "
    "stroke-linecap=\"round\"";

/// The width of a legend [px].
inline constexpr double kLegendWidth = 250;

/// Of a text [px], generously.
[[nodiscard]] double PrintedWidth(std::string_view text, int font);

/// The text, which is UTF-8, or as much of its start as fits, with "…" for the rest.
[[nodiscard]] std::string Fitted(const std::string& text, int font,
                                 double width);

/// objects: as they are drawn; left, top: of the legend [px]; scale: pixels a
/// unit of length.
[[nodiscard]] LegendDrawing PlanLegend(const Isolux& isolux,
                                       const PlanSubject& subject,
                                       const ObjectDrawing& objects,
                                       double left, double top, double scale);

}  // namespace truelux

#endif  // TRUELUX_PLAN_PLAN_LEGEND_H_
