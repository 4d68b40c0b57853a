// SPDX-License-Identifier: GPL-3.0-or-later
// How the parts of a view look: the same in the picture and in its legend.

#ifndef TRUELUX_INSPECT_VIEW_STYLE_H_
#define TRUELUX_INSPECT_VIEW_STYLE_H_

#include <array>
#include <string>
#include <string_view>

#include "draw/svg.h"
#include "inspect/inspected_view.h"

namespace truelux {

/// The marks of vertices; conjunctive ones of any kind have their own.
enum class ViewMark { kIntrinsic, kApparent, kHorizon, kConjunctive };

inline constexpr std::array kViewMarks = {
    ViewMark::kIntrinsic, ViewMark::kApparent, ViewMark::kHorizon,
    ViewMark::kConjunctive};

[[nodiscard]] ViewMark MarkOf(const ContourVertex& vertex);

/// "intrinsic vertex: a corner of a face" and the like.
[[nodiscard]] const char* LegendOf(ViewMark mark);

/// The colour of the conjunctive mark and its label.
inline constexpr const char* kConjunctionColour = "#c23b00";

/// The definitions of all marks in their full size and smaller by `scale`; of
/// the conjunctive mark, which must be found, only the former.
[[nodiscard]] std::string MarkDefinitions(double scale);

/// A mark in the picture (scaled) or, with full_size, in the legend; title: ""
/// for none.
[[nodiscard]] std::string SvgViewMark(ViewMark mark, const PicturePoint& at,
                                      bool full_size, std::string_view title);

/// The kinds of arcs, in the order in which they are drawn.
inline constexpr std::array kViewArcKinds = {
    ViewArcKind::kInner, ViewArcKind::kHorizon, ViewArcKind::kContact,
    ViewArcKind::kMeeting, ViewArcKind::kSilhouette};

/// "silhouette edge: what is beyond is farther" and the like.
[[nodiscard]] const char* LegendOf(ViewArcKind kind);

/// The attributes of a group of arcs of one kind. dense: there are so many that
/// lines must be thin.
[[nodiscard]] std::string StrokeOf(ViewArcKind kind, bool dense);

/// "<title>text</title>", or "" for "". Line ends are kept.
[[nodiscard]] std::string SvgTitle(std::string_view text);

}  // namespace truelux

#endif  // TRUELUX_INSPECT_VIEW_STYLE_H_
