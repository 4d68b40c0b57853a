// SPDX-License-Identifier: GPL-3.0-or-later
// What charts of several panels beside each other have in common.

#ifndef TRUELUX_BENCH_CHART_PARTS_H_
#define TRUELUX_BENCH_CHART_PARTS_H_

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <string>
#include <vector>

#include "draw/svg.h"

namespace truelux::bench {

/// Sizes of panels, and of what is around them [px].
inline constexpr double kPanelWidth = 400;
inline constexpr double kPanelHeight = 420;
inline constexpr double kLeft = 80;
inline constexpr double kTop = 90;
inline constexpr double kGap = 30;
inline constexpr double kBottom = 60;

/// Each name once, in the order of appearance.
template <class T>
std::vector<std::string> Distinct(const std::vector<T>& items,
                                  std::string T::*name) {
  std::vector<std::string> names;
  for (const T& item : items) {
    if (std::ranges::find(names, item.*name) == names.end())
      names.push_back(item.*name);
  }
  return names;
}

/// The markers of all series with their names. left: where it begins.
inline std::string ChartLegend(double left,
                               const std::vector<std::string>& series) {
  std::string svg;
  for (std::size_t i = 0; i < series.size(); ++i) {
    const double y = kTop + 14 + 24 * static_cast<double>(i);
    svg += SvgMarker(left + 8, y, i);
    svg += SvgText(left + 22, y + 4, "start", 13, series[i]);
  }
  return svg;
}

/// The beginning of a file, and a white page.
inline std::string ChartStart(double width, double height) {
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\""
      " viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
      width, height);
}

}  // namespace truelux::bench

#endif  // TRUELUX_BENCH_CHART_PARTS_H_
