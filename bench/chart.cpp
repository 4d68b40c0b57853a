// SPDX-License-Identifier: GPL-3.0-or-later
#include "chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>

#include "chart_parts.h"
#include "draw/svg.h"
#include "draw/svg_axis.h"

namespace truelux::bench {
namespace {

constexpr double kLegendWidth = 200;

bool IsShown(const Measurement& m) {
  return m.error && *m.error > 0 && m.Microseconds() > 0;
}

std::vector<Measurement> Shown(const std::vector<Measurement>& measurements,
                               const std::vector<std::string>& scenes) {
  std::vector<Measurement> shown;
  for (const Measurement& m : measurements) {
    if (IsShown(m) && std::ranges::find(scenes, m.scene) != scenes.end())
      shown.push_back(m);
  }
  return shown;
}

/// What distinguishes a method within its family: "1024".
std::string EffortOf(const Measurement& m) {
  return m.method.size() > m.family.size()
             ? m.method.substr(m.family.size() + 1)
             : "";
}

/// Where a label stands beside its marker.
enum class Side { kAbove, kBelow, kBefore };

std::string Label(double x, double y, Side side, const std::string& text) {
  constexpr int kSize = 11;
  if (text.empty()) return "";
  if (side == Side::kAbove) return SvgText(x, y - 9, "middle", kSize, text);
  if (side == Side::kBelow) return SvgText(x, y + 17, "middle", kSize, text);
  return SvgText(x - 9, y + 4, "end", kSize, text);
}

/// The families with labels take turns, since lines that are near each other
/// follow each other in the list.
Side SideOf(std::size_t line) {
  constexpr std::array kSides = {Side::kAbove, Side::kBelow, Side::kBefore};
  return kSides[line % kSides.size()];
}

/// The frame, the series and the axes of one scene.
class Panel {
 public:
  Panel(double left, const DecadeAxis& x, const DecadeAxis& y)
      : left_(left), x_axis_(x), y_axis_(y) {}

  [[nodiscard]] std::string Frame(const std::string& title,
                                  bool with_error_labels) const {
    std::string svg;
    for (int e = x_axis_.low; e <= x_axis_.high; ++e) {
      const double x = X(std::pow(10.0, e));
      svg += SvgLine(x, kTop, x, kTop + kPanelHeight, "#dddddd");
      // The last label would run into the next panel's first.
      if (e < x_axis_.high)
        svg += SvgText(x, kTop + kPanelHeight + 18, "middle", 12, TimeLabel(e));
    }
    for (int e = y_axis_.low; e <= y_axis_.high; ++e) {
      const double y = Y(std::pow(10.0, e));
      svg += SvgLine(left_, y, left_ + kPanelWidth, y, "#dddddd");
      if (with_error_labels && e % 2 == 0)
        svg += SvgText(left_ - 8, y + 4, "end", 12, fmt::format("1e{}", e));
    }
    svg += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\""
        " stroke=\"#444444\"/>\n",
        left_, kTop, kPanelWidth, kPanelHeight);
    svg += SvgText(left_ + kPanelWidth / 2, kTop - 12, "middle", 14, title);
    svg += SvgText(left_ + kPanelWidth / 2, kTop + kPanelHeight + 42, "middle",
                   13, "time per receiver, one thread");
    return svg;
  }

  /// The points of one family and, where its methods differ in effort, the
  /// least and the greatest effort beside them.
  [[nodiscard]] std::string Series(const std::vector<Measurement>& points,
                                   std::size_t index, Side labels) const {
    std::string corners;
    for (const Measurement& m : points) {
      corners +=
          fmt::format("{:.1f},{:.1f} ", X(m.Microseconds()), Y(*m.error));
    }
    std::string svg = fmt::format(
        "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\""
        " stroke-width=\"1.5\"/>\n",
        corners, SeriesColour(index));
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double x = X(points[i].Microseconds());
      const double y = Y(*points[i].error);
      svg += SvgMarker(x, y, index);
      if (i == 0 || i + 1 == points.size())
        svg += Label(x, y, labels, EffortOf(points[i]));
    }
    return svg;
  }

 private:
  [[nodiscard]] double X(double microseconds) const {
    return left_ + kPanelWidth * x_axis_.At(microseconds);
  }

  [[nodiscard]] double Y(double error) const {
    return kTop + kPanelHeight * (1 - y_axis_.At(error));
  }

  double left_;
  DecadeAxis x_axis_;
  DecadeAxis y_axis_;
};

}  // namespace

std::string ErrorChart(const std::vector<Measurement>& measurements,
                       const std::vector<std::string>& scenes) {
  const std::vector<Measurement> shown = Shown(measurements, scenes);
  DecadeAxis x;
  DecadeAxis y;
  for (const Measurement& m : shown) {
    x.Cover(m.Microseconds());
    y.Cover(*m.error);
  }
  const std::vector<std::string> names = Distinct(shown, &Measurement::scene);
  const std::vector<std::string> families =
      Distinct(shown, &Measurement::family);
  const double panels = static_cast<double>(names.size());
  const double legend = kLeft + panels * (kPanelWidth + kGap);
  const double width = legend + kLegendWidth;
  const double height = kTop + kPanelHeight + kBottom;
  std::string svg = ChartStart(width, height);
  svg += SvgText(kLeft, 26, "start", 16, "Irradiance behind random triangles");
  svg += SvgText(kLeft, 45, "start", 12,
                 "numbers beside lines: shadow rays, or rows of the scanline");
  svg += SvgText(0, 0, "middle", 13, "relative RMS error",
                 fmt::format(" transform=\"translate(24 {}) rotate(-90)\"",
                             kTop + kPanelHeight / 2));
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Panel panel(kLeft + static_cast<double>(i) * (kPanelWidth + kGap), x,
                      y);
    svg += panel.Frame(names[i], i == 0);
    std::size_t lines = 0;
    for (std::size_t k = 0; k < families.size(); ++k) {
      std::vector<Measurement> points;
      for (const Measurement& m : shown) {
        if (m.scene == names[i] && m.family == families[k]) points.push_back(m);
      }
      if (points.empty()) continue;
      svg += panel.Series(points, k, SideOf(lines));
      if (points.size() > 1) ++lines;
    }
  }
  return svg + ChartLegend(legend, families) + "</svg>\n";
}

}  // namespace truelux::bench
