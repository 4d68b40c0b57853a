#include "chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <limits>

namespace truelux::bench {
namespace {

constexpr double kPanelWidth = 400;
constexpr double kPanelHeight = 420;
constexpr double kLeft = 80;
constexpr double kTop = 90;
constexpr double kGap = 30;
constexpr double kBottom = 60;
constexpr double kLegendWidth = 200;

/// Colours that most colour-blind readers can tell apart (Okabe and Ito).
constexpr std::array<const char*, 7> kColours = {
    "#d55e00", "#0072b2", "#009e73", "#cc79a7",
    "#e69f00", "#56b4e9", "#555555"};

/// A logarithmic axis over whole decades.
struct Axis {
  int low = std::numeric_limits<int>::max();  ///< decimal exponents
  int high = std::numeric_limits<int>::min();

  /// Leaves room for a label on either side of the value.
  void Cover(double value) {
    constexpr double kRoom = 0.3;
    const double decade = std::log10(value);
    low = std::min(low, static_cast<int>(std::floor(decade - kRoom)));
    high = std::max(high, static_cast<int>(std::ceil(decade + kRoom)));
  }

  /// 0 at the low end, 1 at the high end.
  [[nodiscard]] double At(double value) const {
    return (std::log10(value) - low) / (high - low);
  }
};

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

/// Each name once, in the order of appearance.
std::vector<std::string> Distinct(const std::vector<Measurement>& shown,
                                  std::string Measurement::*name) {
  std::vector<std::string> names;
  for (const Measurement& m : shown) {
    if (std::ranges::find(names, m.*name) == names.end())
      names.push_back(m.*name);
  }
  return names;
}

std::string Text(double x, double y, const char* anchor, int size,
                 const std::string& text, const std::string& more = "") {
  return fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"{}\""
      "{}>{}</text>\n",
      x, y, anchor, size, more, text);
}

std::string Line(double x1, double y1, double x2, double y2,
                 const char* colour) {
  return fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\""
      " stroke=\"{}\"/>\n",
      x1, y1, x2, y2, colour);
}

/// A marker whose shape and colour belong to the series.
std::string Marker(double x, double y, std::size_t series) {
  const char* colour = kColours[series % kColours.size()];
  constexpr double kHalf = 4.5;
  if (series % 3 == 0) {
    return fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\"/>\n", x, y,
        kHalf, colour);
  }
  if (series % 3 == 1) {
    return fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{}\""
        " fill=\"{}\"/>\n",
        x - kHalf, y - kHalf, 2 * kHalf, 2 * kHalf, colour);
  }
  return fmt::format(
      "<path d=\"M {:.1f} {:.1f} l {} {} h {} z\" fill=\"{}\"/>\n", x,
      y - kHalf, kHalf, 2 * kHalf, -2 * kHalf, colour);
}

/// 10^exponent microseconds in a handy unit.
std::string TimeLabel(int exponent) {
  constexpr std::array<const char*, 4> kUnits = {"ns", "\u00b5s", "ms", "s"};
  const std::ptrdiff_t thousands =
      std::clamp(static_cast<int>(std::floor(exponent / 3.0)), -1, 2);
  return fmt::format(
      "{:g} {}", std::pow(10.0, static_cast<double>(exponent - 3 * thousands)),
      kUnits[static_cast<std::size_t>(thousands + 1)]);
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
  if (side == Side::kAbove) return Text(x, y - 9, "middle", kSize, text);
  if (side == Side::kBelow) return Text(x, y + 17, "middle", kSize, text);
  return Text(x - 9, y + 4, "end", kSize, text);
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
  Panel(double left, const Axis& x, const Axis& y)
      : left_(left), x_axis_(x), y_axis_(y) {}

  [[nodiscard]] std::string Frame(const std::string& title,
                                  bool with_error_labels) const {
    std::string svg;
    for (int e = x_axis_.low; e <= x_axis_.high; ++e) {
      const double x = X(std::pow(10.0, e));
      svg += Line(x, kTop, x, kTop + kPanelHeight, "#dddddd");
      // The last label would run into the next panel's first.
      if (e < x_axis_.high)
        svg += Text(x, kTop + kPanelHeight + 18, "middle", 12, TimeLabel(e));
    }
    for (int e = y_axis_.low; e <= y_axis_.high; ++e) {
      const double y = Y(std::pow(10.0, e));
      svg += Line(left_, y, left_ + kPanelWidth, y, "#dddddd");
      if (with_error_labels && e % 2 == 0)
        svg += Text(left_ - 8, y + 4, "end", 12, fmt::format("1e{}", e));
    }
    svg += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\""
        " stroke=\"#444444\"/>\n",
        left_, kTop, kPanelWidth, kPanelHeight);
    svg += Text(left_ + kPanelWidth / 2, kTop - 12, "middle", 14, title);
    svg += Text(left_ + kPanelWidth / 2, kTop + kPanelHeight + 42, "middle", 13,
                "time per receiver, one thread");
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
        corners, kColours[index % kColours.size()]);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double x = X(points[i].Microseconds());
      const double y = Y(*points[i].error);
      svg += Marker(x, y, index);
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
  Axis x_axis_;
  Axis y_axis_;
};

std::string Legend(double left, const std::vector<std::string>& families) {
  std::string svg;
  for (std::size_t i = 0; i < families.size(); ++i) {
    const double y = kTop + 14 + 24 * static_cast<double>(i);
    svg += Marker(left + 8, y, i);
    svg += Text(left + 22, y + 4, "start", 13, families[i]);
  }
  return svg;
}

}  // namespace

std::string ErrorChart(const std::vector<Measurement>& measurements,
                       const std::vector<std::string>& scenes) {
  const std::vector<Measurement> shown = Shown(measurements, scenes);
  Axis x;
  Axis y;
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
  std::string svg = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\""
      " viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
      width, height);
  svg += Text(kLeft, 26, "start", 16, "Irradiance behind random triangles");
  svg += Text(kLeft, 45, "start", 12,
              "numbers beside lines: shadow rays, or rows of the scanline");
  svg += Text(0, 0, "middle", 13, "relative RMS error",
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
  return svg + Legend(legend, families) + "</svg>\n";
}

}  // namespace truelux::bench
