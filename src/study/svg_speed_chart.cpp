// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/svg_speed_chart.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <optional>
#include <vector>

#include "draw/label_layout.h"
#include "draw/svg.h"
#include "draw/svg_axis.h"
#include "study/speed_chart_layout.h"
#include "text/number_text.h"

namespace truelux {
namespace {

using Mark = SpeedChartLayout::Mark;
using Place = SpeedChartLayout::Place;

constexpr double kLeft = SpeedChartLayout::kLeft;
constexpr double kRight = SpeedChartLayout::kRight;
constexpr double kTop = SpeedChartLayout::kTop;
constexpr double kGap = SpeedChartLayout::kGap;
constexpr double kWidth = 1040;
constexpr double kBottom = 52;
constexpr const char* kGrid = "#e4e4e4";
constexpr const char* kFrame = "#8a8a8a";

/// The number behind the group's name in a method's: "64"; nothing if the
/// method differs in more than effort.
std::optional<std::string> EffortOf(const MethodResult& method) {
  if (method.name.size() < method.group.size() + 2 ||
      !method.name.starts_with(method.group + " "))
    return std::nullopt;
  const std::string effort = method.name.substr(method.group.size() + 1);
  if (effort.find_first_not_of("0123456789") != effort.npos)
    return std::nullopt;
  return effort;
}

class Chart {
 public:
  explicit Chart(const ReportView& view) : view_(view), layout_(view) {}

  [[nodiscard]] std::string Svg() const {
    const double legend_end =
        kTop + 120 + 22 * static_cast<double>(view_.groups.size());
    const double height =
        std::max(layout_.exact_bottom() + kBottom, legend_end);
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"speed-chart\""
        " viewBox=\"0 0 {} {:.0f}\" role=\"img\""
        " aria-label=\"Relative error against time per receiver\""
        " font-family=\"inherit\" fill=\"#222222\">\n",
        kWidth, height);
    svg += Frame();
    svg += Efforts();
    svg += Front();
    svg += Stems();
    for (const Mark& mark : layout_.marks())
      svg += MarkSvg(mark);
    svg += Labels();
    return svg + Legend() + "</svg>\n";
  }

 private:
  [[nodiscard]] std::string Frame() const {
    std::string svg;
    for (int e = layout_.x_axis().low; e <= layout_.x_axis().high; ++e) {
      const double x = layout_.X(std::pow(10.0, e));
      svg += SvgLine(x, layout_.top(), x, layout_.bottom(), kGrid);
      svg += SvgLine(x, layout_.exact_top(), x, layout_.exact_bottom(), kGrid);
      svg +=
          SvgText(x, layout_.exact_bottom() + 18, "middle", 12, TimeLabel(e));
    }
    const int labelled = LabelledDecades();
    for (int e = layout_.y_axis().low; e <= layout_.y_axis().high; ++e) {
      const double y = layout_.Y(std::pow(10.0, e));
      if (e % (labelled / 2) != 0) continue;
      svg += SvgLine(kLeft, y, kRight, y, kGrid);
      if (e % labelled == 0)
        svg += SvgText(kLeft - 8, y + 4, "end", 12,
                       ScientificText(std::pow(10.0, e), 0));
    }
    svg += Box(layout_.top(), layout_.bottom(), "none");
    svg += Box(layout_.exact_top(), layout_.exact_bottom(), "#f3f3f3", 0.6);
    svg += SvgText(kLeft - 8,
                   (layout_.exact_top() + layout_.exact_bottom()) / 2 + 4,
                   "end", 12, "exact", " font-weight=\"600\"");
    if (layout_.HasNoNumberBand()) {
      svg += Box(kTop, layout_.top() - kGap, "#f3f3f3", 0.6);
      svg += SvgText(kLeft - 8, (kTop + layout_.top() - kGap) / 2 + 4, "end",
                     12, "no number");
    }
    svg += SvgText((kLeft + kRight) / 2, layout_.exact_bottom() + 42, "middle",
                   13, "time per receiver, one thread");
    return svg + SvgText(0, 0, "middle", 13, "relative error, RMS",
                         fmt::format(" transform=\"translate(18 {:.1f})"
                                     " rotate(-90)\"",
                                     (layout_.top() + layout_.bottom()) / 2));
  }

  /// Every so many decades of the error have a label, twice as many a line.
  [[nodiscard]] int LabelledDecades() const {
    constexpr double kLeastDistance = 24;
    const double decade = (layout_.bottom() - layout_.top()) /
                          (layout_.y_axis().high - layout_.y_axis().low);
    int step = 2;
    while (step * decade < kLeastDistance)
      step *= 2;
    return step;
  }

  static std::string Box(double top, double bottom, const char* fill,
                         double opacity = 1) {
    return fmt::format(
        "<rect x=\"{}\" y=\"{:.1f}\" width=\"{}\" height=\"{:.1f}\""
        " fill=\"{}\" fill-opacity=\"{}\" stroke=\"{}\"/>\n",
        kLeft, top, (kRight - kLeft), bottom - top, fill, opacity, kFrame);
  }

  /// The marks of a group whose methods differ in effort only.
  [[nodiscard]] std::vector<const Mark*> EffortMarks(std::size_t group) const {
    std::vector<const Mark*> marks;
    for (const Mark& mark : layout_.marks()) {
      if (view_.series[mark.method] != group) continue;
      if (!EffortOf(view_.comparison.methods[mark.method])) return {};
      marks.push_back(&mark);
    }
    return marks;
  }

  [[nodiscard]] std::string Efforts() const {
    std::string svg;
    for (std::size_t group = 0; group < view_.groups.size(); ++group) {
      const std::vector<const Mark*> marks = EffortMarks(group);
      if (marks.size() < 2) continue;
      std::string corners;
      for (const Mark* mark : marks)
        corners += fmt::format("{:.1f},{:.1f} ", mark->x, mark->y);
      svg += fmt::format(
          "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\""
          " stroke-opacity=\"0.6\"/>\n",
          corners, SeriesColour(group));
    }
    return svg;
  }

  /// A stair: whoever accepts an error gets the time of the last step above.
  [[nodiscard]] std::string Front() const {
    std::string path;
    double x = 0;
    for (const std::size_t method : view_.front) {
      const Mark* mark = layout_.Find(method);
      if (mark == nullptr) continue;
      path += path.empty()
                  ? fmt::format("M {:.1f} {:.1f} V {:.1f}", mark->x,
                                layout_.top(), mark->y)
                  : fmt::format(" H {:.1f} V {:.1f}", mark->x, mark->y);
      x = mark->x;
    }
    if (path.empty()) return "";
    if (x < kRight) path += fmt::format(" H {:.1f}", kRight);
    return fmt::format(
        "<path class=\"front\" d=\"{}\" fill=\"none\" stroke=\"#9a9a9a\""
        " stroke-width=\"1.5\" stroke-dasharray=\"5 3\"/>\n",
        path);
  }

  [[nodiscard]] std::string Stems() const {
    std::string svg;
    for (const Mark& mark : layout_.marks()) {
      if (mark.place != Place::kPlot) continue;
      const double largest = view_.summaries[mark.method].relative->max;
      const double top =
          std::isfinite(largest) ? layout_.Y(largest) : layout_.top();
      svg += fmt::format(
          "<path d=\"M {:.1f} {:.1f} V {:.1f} m -2.5 0 h 5\" fill=\"none\""
          " stroke=\"{}\" stroke-opacity=\"0.4\"/>\n",
          mark.x, mark.y, top, SeriesColour(view_.series[mark.method]));
    }
    return svg;
  }

  [[nodiscard]] std::string MarkSvg(const Mark& mark) const {
    const MethodSummary& summary = view_.summaries[mark.method];
    const MethodResult& method = view_.comparison.methods[mark.method];
    std::string title =
        fmt::format("{}: {}", method.name, TimeText(method.microseconds));
    if (mark.place == Place::kExact) {
      title += ", exact";
    } else if (summary.relative) {
      title += fmt::format(", error: RMS {}, median {}, largest {}",
                           ScientificText(summary.relative->rms, 1),
                           ScientificText(summary.relative->median, 1),
                           ScientificText(summary.relative->max, 1));
    }
    const bool everywhere = summary.AnswersAll(view_.comparison);
    if (!everywhere) {
      title += fmt::format(", on {} of {} receivers", summary.answered,
                           view_.comparison.receivers.size());
    }
    return fmt::format(
        "<g class=\"mark\"><title>{}</title>{}</g>\n", EscapedXml(title),
        SvgMarker(mark.x, mark.y, view_.series[mark.method],
                  everywhere ? MarkerFill::kSolid : MarkerFill::kHollow));
  }

  [[nodiscard]] std::string Labels() const {
    LabelLayout layout({kLeft + 2, kTop, kRight - 2, layout_.exact_bottom()});
    // The border between the plot and the band below.
    layout.Avoid(
        {kLeft, layout_.bottom() - 2, kRight, layout_.exact_top() + 2});
    constexpr double kHalf = 6;
    for (const Mark& mark : layout_.marks()) {
      layout.Avoid(
          {mark.x - kHalf, mark.y - kHalf, mark.x + kHalf, mark.y + kHalf});
    }
    std::string svg;
    for (const std::size_t method : view_.front) {
      const Mark* mark = layout_.Find(method);
      if (mark == nullptr) continue;
      svg += Label(layout, *mark, view_.comparison.methods[method].name, 12,
                   " font-weight=\"600\"");
    }
    for (std::size_t group = 0; group < view_.groups.size(); ++group) {
      const std::vector<const Mark*> marks = EffortMarks(group);
      if (marks.size() < 2) continue;
      for (const Mark* mark : {marks.front(), marks.back()}) {
        if (view_.IsOnFront(mark->method)) continue;
        svg += Label(layout, *mark,
                     *EffortOf(view_.comparison.methods[mark->method]), 10,
                     " fill=\"#555555\"");
      }
    }
    return svg;
  }

  /// A label on a white outline, so that lines may pass behind it.
  static std::string Label(LabelLayout& layout, const Mark& mark,
                           const std::string& text, int size,
                           const char* style) {
    const auto place = layout.Place(mark.x, mark.y, text, size);
    if (!place) return "";
    return SvgText(place->x, place->y, place->anchor, size, text,
                   fmt::format(" stroke=\"#ffffff\" stroke-width=\"3\""
                               " stroke-linejoin=\"round\""
                               " paint-order=\"stroke\"{}",
                               style));
  }

  [[nodiscard]] std::string Legend() const {
    constexpr double kX = kRight + 24;
    std::string svg;
    double y = kTop + 14;
    for (std::size_t group = 0; group < view_.groups.size(); ++group) {
      svg += SvgMarker(kX, y, group);
      svg += SvgText(kX + 14, y + 4, "start", 13, view_.groups[group]);
      y += 22;
    }
    y += 10;
    constexpr const char* kGrey = "#777777";
    svg += fmt::format(
        "<circle cx=\"{0}\" cy=\"{1}\" r=\"4.5\" fill=\"#ffffff\""
        " stroke=\"{2}\" stroke-width=\"1.5\"/>\n"
        "<path d=\"M {0} {4} v -12 m -2.5 0 h 5\" fill=\"none\""
        " stroke=\"{2}\"/>\n"
        "<path d=\"M {5} {6} h 12\" stroke=\"#9a9a9a\" stroke-width=\"1.5\""
        " stroke-dasharray=\"5 3\"/>\n",
        kX, y, kGrey, 0, y + 28, kX - 6, y + 44);
    svg += SvgText(kX + 14, y + 4, "start", 12, "hollow: not on all receivers");
    svg += SvgText(kX + 14, y + 26, "start", 12, "up to the largest error");
    return svg + SvgText(kX + 14, y + 48, "start", 12, "beaten by no other");
  }

  const ReportView& view_;
  SpeedChartLayout layout_;
};

}  // namespace

std::string SpeedChart(const ReportView& view) {
  return Chart(view).Svg();
}

}  // namespace truelux
