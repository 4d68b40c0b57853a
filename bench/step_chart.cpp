// SPDX-License-Identifier: GPL-3.0-or-later
#include "step_chart.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>

#include "chart_parts.h"
#include "draw/svg.h"
#include "draw/svg_axis.h"

namespace truelux::bench {
namespace {

constexpr double kLegendWidth = 230;

/// The frame, the series and the axes of one receiver.
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
      if (e % 2 == 0) {
        svg += SvgText(x, kTop + kPanelHeight + 18, "middle", 12,
                       fmt::format("1e{}", e));
      }
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
                   13, "step h, side of the source = 1");
    return svg;
  }

  /// Markers stand at every second point, and in turns, so that one sees both
  /// of two series that lie on each other.
  [[nodiscard]] std::string Series(const std::vector<StepError>& points,
                                   std::size_t index) const {
    std::string corners;
    std::string markers;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto& [step, error] = points[i];
      if (!(error > 0)) continue;
      corners += fmt::format("{:.1f},{:.1f} ", X(step), Y(error));
      if (i % 2 == index % 2) markers += SvgMarker(X(step), Y(error), index);
    }
    return fmt::format(
               "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\""
               " stroke-width=\"1.5\"/>\n",
               corners, SeriesColour(index)) +
           markers;
  }

 private:
  [[nodiscard]] double X(double step) const {
    return left_ + kPanelWidth * x_axis_.At(step);
  }

  [[nodiscard]] double Y(double error) const {
    return kTop + kPanelHeight * (1 - y_axis_.At(error));
  }

  double left_;
  DecadeAxis x_axis_;
  DecadeAxis y_axis_;
};

}  // namespace

std::string StepChart(const std::vector<StepCurve>& curves) {
  DecadeAxis x;
  DecadeAxis y;
  for (const StepCurve& curve : curves) {
    for (const StepError& point : curve.points) {
      if (!(point.error > 0)) continue;
      x.Cover(point.step);
      y.Cover(point.error);
    }
  }
  const std::vector<std::string> receivers =
      Distinct(curves, &StepCurve::receiver);
  const std::vector<std::string> methods = Distinct(curves, &StepCurve::method);
  const double panels = static_cast<double>(receivers.size());
  const double legend = kLeft + panels * (kPanelWidth + kGap);
  const double width = legend + kLegendWidth;
  const double height = kTop + kPanelHeight + kBottom;
  std::string svg = ChartStart(width, height);
  svg += SvgText(kLeft, 26, "start", 16, "Gradients by central differences");
  svg += SvgText(kLeft, 45, "start", 12,
                 "error of the worst component, relative to the length of the"
                 " certified gradient");
  svg += SvgText(0, 0, "middle", 13, "relative error",
                 fmt::format(" transform=\"translate(24 {}) rotate(-90)\"",
                             kTop + kPanelHeight / 2));
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    const Panel panel(kLeft + static_cast<double>(i) * (kPanelWidth + kGap), x,
                      y);
    svg += panel.Frame(receivers[i], i == 0);
    for (const StepCurve& curve : curves) {
      if (curve.receiver != receivers[i]) continue;
      const auto index = std::ranges::find(methods, curve.method);
      svg += panel.Series(curve.points,
                          static_cast<std::size_t>(index - methods.begin()));
    }
  }
  return svg + ChartLegend(legend, methods) + "</svg>\n";
}

}  // namespace truelux::bench
