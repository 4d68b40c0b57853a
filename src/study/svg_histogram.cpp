// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/svg_histogram.h"

#include <algorithm>
#include <fmt/format.h>

#include "draw/svg.h"

namespace truelux {
namespace {

constexpr double kWidth = 244;
constexpr double kHeight = 96;
constexpr double kTop = 14;
constexpr double kBase = 78;
constexpr double kBar = 8;       ///< width of a decade
constexpr double kSpecial = 12;  ///< width of a bar outside the decades
constexpr double kExactX = 9;
constexpr double kDecadesX = 38;
constexpr double kFalseLightX = 194;
constexpr double kNoValueX = 222;

class Histogram {
 public:
  Histogram(const ErrorHistogram& histogram, std::size_t scale,
            std::size_t series)
      : histogram_(histogram),
        scale_(std::max<std::size_t>(scale, 1)),
        colour_(SeriesColour(series)) {}

  [[nodiscard]] std::string Svg() const {
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"histogram\""
        " viewBox=\"0 0 {} {}\" role=\"img\""
        " aria-label=\"Receivers by relative error\""
        " font-family=\"inherit\" fill=\"#444444\">\n",
        kWidth, kHeight);
    svg += Axis();
    for (std::size_t i = 0; i < ErrorHistogram::kDecades; ++i) {
      const double x = kDecadesX + kBar * static_cast<double>(i);
      svg += Bar(x + 0.5, kBar - 1, histogram_.decades[i], colour_,
                 DecadeTitle(i));
    }
    svg += Special(kExactX, histogram_.exact, "exact", colour_);
    svg += Special(kFalseLightX, histogram_.false_light,
                   "light where there is none", "#000000");
    svg += Special(kNoValueX, histogram_.no_value, "no value", "#b8b8b8");
    return svg + "</svg>\n";
  }

 private:
  static std::string DecadeTitle(std::size_t i) {
    const int low = ErrorHistogram::kLowest + static_cast<int>(i);
    if (low >= 0) return "error 1 or more";
    return i == 0 ? fmt::format("error below 1e{}", low + 1)
                  : fmt::format("error 1e{} to 1e{}", low, low + 1);
  }

  static std::string Axis() {
    constexpr double kDecadesEnd =
        kDecadesX + kBar * static_cast<double>(ErrorHistogram::kDecades);
    std::string svg;
    svg += SvgLine(kExactX, kBase, kExactX + kSpecial, kBase, "#8a8a8a");
    svg += SvgLine(kDecadesX, kBase, kDecadesEnd, kBase, "#8a8a8a");
    svg +=
        SvgLine(kFalseLightX, kBase, kFalseLightX + kSpecial, kBase, "#8a8a8a");
    svg += SvgLine(kNoValueX, kBase, kNoValueX + kSpecial, kBase, "#8a8a8a");
    for (int e = -16; e <= 0; e += 4) {
      const double x = kDecadesX + kBar * (e - ErrorHistogram::kLowest);
      svg += SvgLine(x, kBase, x, kBase + 3, "#8a8a8a");
      svg += SvgText(x, kBase + 13, "middle", 9,
                     e == 0 ? "1" : fmt::format("1e{}", e));
    }
    svg += SvgText(kExactX + kSpecial / 2, kBase + 13, "middle", 9, "exact");
    svg +=
        SvgText(kFalseLightX + kSpecial / 2, kBase + 13, "middle", 9, "false");
    return svg +
           SvgText(kNoValueX + kSpecial / 2, kBase + 13, "middle", 9, "none");
  }

  /// A bar with its count on top.
  [[nodiscard]] std::string Special(double x, std::size_t count,
                                    const char* title,
                                    const char* colour) const {
    if (count == 0) return "";
    return Bar(x, kSpecial, count, colour, title) +
           SvgText(x + kSpecial / 2, kBase - Height(count) - 3, "middle", 9,
                   fmt::format("{}", count));
  }

  [[nodiscard]] double Height(std::size_t count) const {
    constexpr double kLeast = 1.5;  // a single receiver must be seen
    const double share = static_cast<double>(std::min(count, scale_)) /
                         static_cast<double>(scale_);
    return std::max(kLeast, (kBase - kTop) * share);
  }

  [[nodiscard]] std::string Bar(double x, double width, std::size_t count,
                                const char* colour,
                                const std::string& title) const {
    if (count == 0) return "";
    const double height = Height(count);
    std::string svg = fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\""
        " fill=\"{}\"><title>{}: {} receiver{}</title></rect>\n",
        x, kBase - height, width, height, colour, EscapedXml(title), count,
        count == 1 ? "" : "s");
    if (count > scale_) {
      // A slanted gap says that the bar goes on.
      svg += fmt::format(
          "<path d=\"M {:.1f} {:.1f} l {:.1f} -5\" stroke=\"#ffffff\""
          " stroke-width=\"2.5\"/>\n",
          x - 1, kTop + 14, width + 2);
    }
    return svg;
  }

  const ErrorHistogram& histogram_;
  std::size_t scale_;
  const char* colour_;
};

}  // namespace

std::string HistogramSvg(const ErrorHistogram& histogram, std::size_t scale,
                         std::size_t series) {
  return Histogram(histogram, scale, series).Svg();
}

}  // namespace truelux
