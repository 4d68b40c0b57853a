// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspect/view_style.h"

#include <cstddef>
#include <fmt/format.h>

namespace truelux {
namespace {

/// The shape around the origin; size: by which its lengths are multiplied.
std::string ShapeOf(ViewMark mark, double size) {
  switch (mark) {
    case ViewMark::kIntrinsic:
      return fmt::format(
          "<circle r=\"{:.2f}\" fill=\"#1a1a1a\" stroke=\"#ffffff\""
          " stroke-width=\"{:.2f}\"/>",
          3.2 * size, 0.8 * size);
    case ViewMark::kApparent:
      return fmt::format(
          "<path d=\"M0 {0:.2f}L{1:.2f} 0L0 {1:.2f}L{0:.2f} 0Z\""
          " fill=\"#ffffff\" stroke=\"#0060a8\" stroke-width=\"{2:.2f}\"/>",
          -4.6 * size, 4.6 * size, 1.6 * size);
    case ViewMark::kHorizon:
      return fmt::format(
          "<path d=\"M{0:.2f} {0:.2f}H{1:.2f}V{1:.2f}H{0:.2f}Z\""
          " fill=\"#00a878\" stroke=\"#004d38\" stroke-width=\"{2:.2f}\"/>",
          -3.2 * size, 3.2 * size, 1.2 * size);
    case ViewMark::kConjunctive:
      break;
  }
  return fmt::format(
      "<g stroke=\"{0}\"><circle r=\"{1:.2f}\" fill=\"#ffffff\""
      " stroke-width=\"{2:.2f}\"/><path d=\"M{3:.2f} {3:.2f}L{4:.2f} {4:.2f}"
      "M{3:.2f} {4:.2f}L{4:.2f} {3:.2f}\" stroke-width=\"{5:.2f}\"/></g>",
      kConjunctionColour, 5.6 * size, 2 * size, -2.4 * size, 2.4 * size,
      1.5 * size);
}

/// The identifier of a mark's definition.
std::string IdOf(ViewMark mark, bool full_size) {
  const std::size_t index = static_cast<std::size_t>(mark);
  return fmt::format(
      "{}{}", full_size || mark == ViewMark::kConjunctive ? "m" : "s", index);
}

}  // namespace

ViewMark MarkOf(const ContourVertex& vertex) {
  if (vertex.conjunctive) return ViewMark::kConjunctive;
  if (vertex.kind == VertexKind::kIntrinsic) return ViewMark::kIntrinsic;
  if (vertex.kind == VertexKind::kHorizon) return ViewMark::kHorizon;
  return ViewMark::kApparent;
}

const char* LegendOf(ViewMark mark) {
  switch (mark) {
    case ViewMark::kIntrinsic:
      return "intrinsic vertex: a corner of a face";
    case ViewMark::kApparent:
      return "apparent vertex: two edges cross";
    case ViewMark::kHorizon:
      return "horizon vertex: an edge sets";
    case ViewMark::kConjunctive:
      break;
  }
  return "conjunctive vertex, and its edges";
}

std::string MarkDefinitions(double scale) {
  std::string text;
  for (const ViewMark mark : kViewMarks) {
    text += fmt::format("<g id=\"{}\">{}</g>\n", IdOf(mark, true),
                        ShapeOf(mark, 1));
    if (mark != ViewMark::kConjunctive) {
      text += fmt::format("<g id=\"{}\">{}</g>\n", IdOf(mark, false),
                          ShapeOf(mark, scale));
    }
  }
  return text;
}

std::string SvgViewMark(ViewMark mark, const PicturePoint& at, bool full_size,
                        std::string_view title) {
  return fmt::format("<use href=\"#{}\" x=\"{:.2f}\" y=\"{:.2f}\">{}</use>\n",
                     IdOf(mark, full_size), at.x, at.y, SvgTitle(title));
}

const char* LegendOf(ViewArcKind kind) {
  switch (kind) {
    case ViewArcKind::kHorizon:
      return "horizon";
    case ViewArcKind::kSilhouette:
      return "silhouette edge: farther beyond";
    case ViewArcKind::kInner:
      return "inner edge, shared by two faces";
    case ViewArcKind::kContact:
      return "contact: an edge on another face";
    case ViewArcKind::kMeeting:
      break;
  }
  return "meeting: faces pass through each other";
}

std::string StrokeOf(ViewArcKind kind, bool dense) {
  const double factor = dense ? 0.6 : 1;
  const char* colour = "#1a1a1a";
  double width = 1.5;
  std::string more;
  switch (kind) {
    case ViewArcKind::kInner:
      width = dense ? 0.6 : 1;
      more = " stroke-opacity=\"0.5\"";
      break;
    case ViewArcKind::kHorizon:
      width = 2.2 / factor;
      break;
    case ViewArcKind::kContact:
      width = 1;
      colour = "#3d3d3d";
      break;
    case ViewArcKind::kMeeting:
      colour = "#7b2d9b";
      width = 1.6;
      more = " stroke-dasharray=\"5 3\"";
      break;
    case ViewArcKind::kSilhouette:
      break;
  }
  return fmt::format("stroke=\"{}\" stroke-width=\"{:.2f}\"{}", colour,
                     factor * width, more);
}

std::string SvgTitle(std::string_view text) {
  if (text.empty()) return "";
  std::string escaped = "<title>";
  std::size_t begin = 0;
  for (;;) {
    const std::size_t end = text.find('\n', begin);
    escaped += EscapedXml(text.substr(begin, end - begin));
    if (end == text.npos) break;
    escaped += '\n';
    begin = end + 1;
  }
  return escaped + "</title>";
}

}  // namespace truelux
