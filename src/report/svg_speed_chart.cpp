#include "report/svg_speed_chart.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <optional>
#include <vector>

#include "report/label_layout.h"
#include "report/number_text.h"
#include "report/svg.h"
#include "report/svg_axis.h"

namespace truelux {
namespace {

constexpr double kWidth = 1040;
constexpr double kLeft = 84;
constexpr double kPlotWidth = 730;
constexpr double kTop = 14;
constexpr double kDecadeHeight = 25;
constexpr double kLeastHeight = 300;
constexpr double kGap = 10;  ///< between the plot and its bands
constexpr double kRowHeight = 15;
constexpr double kBottom = 52;
constexpr const char* kGrid = "#e4e4e4";
constexpr const char* kFrame = "#8a8a8a";

/// Where a method's error belongs.
enum class Place { kPlot, kExact, kNoNumber };

/// A method in the chart.
struct Mark {
  std::size_t method = 0;
  double microseconds = 0;
  double error = 0;
  Place place = Place::kPlot;
  std::size_t row = 0;  ///< in its band
  double x = 0;
  double y = 0;
};

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
  explicit Chart(const ReportView& view) : view_(view) {
    CollectMarks();
    CoverAxes();
    PlaceMarks();
  }

  [[nodiscard]] std::string Svg() const {
    const double legend_end =
        kTop + 120 + 22 * static_cast<double>(view_.groups.size());
    const double height = std::max(exact_bottom_ + kBottom, legend_end);
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
    for (const Mark& mark : marks_)
      svg += MarkSvg(mark);
    svg += Labels();
    return svg + Legend() + "</svg>\n";
  }

 private:
  void CollectMarks() {
    constexpr double kLeastMicroseconds = 1e-4;  // no clock shows less
    for (std::size_t m = 0; m < view_.summaries.size(); ++m) {
      const MethodSummary& summary = view_.summaries[m];
      if (summary.answered == 0) continue;
      Mark mark;
      mark.method = m;
      mark.microseconds = std::max(view_.comparison.methods[m].microseconds,
                                   kLeastMicroseconds);
      mark.error = ErrorInChart(summary);
      if (mark.error == 0) mark.place = Place::kExact;
      if (std::isinf(mark.error)) mark.place = Place::kNoNumber;
      marks_.push_back(mark);
    }
  }

  void CoverAxes() {
    for (const Mark& mark : marks_) {
      x_axis_.Cover(mark.microseconds);
      if (mark.place == Place::kPlot) y_axis_.Cover(mark.error);
      const double largest = LargestError(mark);
      if (largest > 0 && std::isfinite(largest)) y_axis_.Cover(largest);
    }
    if (marks_.empty()) x_axis_.Cover(1);
    if (y_axis_.high < y_axis_.low) {
      // Nothing is wrong: an axis from rounding to one.
      y_axis_.Cover(1e-16);
      y_axis_.Cover(1);
    }
  }

  void PlaceMarks() {
    for (Mark& mark : marks_)
      mark.x = kLeft + kPlotWidth * x_axis_.At(mark.microseconds);
    const double above = FillBand(Place::kNoNumber);
    const double below = std::max(FillBand(Place::kExact), 1.0);
    top_ = kTop + (above > 0 ? BandHeight(above) + kGap : 0);
    bottom_ = top_ + std::max(kLeastHeight,
                              kDecadeHeight * (y_axis_.high - y_axis_.low));
    exact_top_ = bottom_ + kGap;
    exact_bottom_ = exact_top_ + BandHeight(below);
    for (Mark& mark : marks_) {
      const double row = (static_cast<double>(mark.row) + 0.75) * kRowHeight;
      if (mark.place == Place::kPlot) {
        mark.y = Y(mark.error);
      } else {
        mark.y = (mark.place == Place::kExact ? exact_top_ : kTop) + row;
      }
    }
  }

  /// Puts the marks of a band into rows in which none covers another; returns
  /// the number of rows.
  double FillBand(Place place) {
    std::vector<Mark*> in_band;
    for (Mark& mark : marks_) {
      if (mark.place == place) in_band.push_back(&mark);
    }
    std::ranges::stable_sort(
        in_band, [](const Mark* a, const Mark* b) { return a->x < b->x; });
    constexpr double kLeastDistance = 12;
    std::vector<double> last_x;
    for (Mark* mark : in_band) {
      const auto is_free = [mark](double x) {
        return x + kLeastDistance <= mark->x;
      };
      const auto row = std::ranges::find_if(last_x, is_free);
      mark->row = static_cast<std::size_t>(row - last_x.begin());
      if (row == last_x.end()) {
        last_x.push_back(mark->x);
      } else {
        *row = mark->x;
      }
    }
    return static_cast<double>(last_x.size());
  }

  static double BandHeight(double rows) { return (rows + 0.5) * kRowHeight; }

  [[nodiscard]] double Y(double error) const {
    return bottom_ - (bottom_ - top_) * y_axis_.At(error);
  }

  [[nodiscard]] double LargestError(const Mark& mark) const {
    const auto& relative = view_.summaries[mark.method].relative;
    return relative ? relative->max : 0;
  }

  [[nodiscard]] std::string Frame() const {
    std::string svg;
    for (int e = x_axis_.low; e <= x_axis_.high; ++e) {
      const double x = kLeft + kPlotWidth * x_axis_.At(std::pow(10.0, e));
      svg += SvgLine(x, top_, x, bottom_, kGrid);
      svg += SvgLine(x, exact_top_, x, exact_bottom_, kGrid);
      svg += SvgText(x, exact_bottom_ + 18, "middle", 12, TimeLabel(e));
    }
    for (int e = y_axis_.low; e <= y_axis_.high; ++e) {
      const double y = Y(std::pow(10.0, e));
      svg += SvgLine(kLeft, y, kLeft + kPlotWidth, y, kGrid);
      if (e % 2 == 0)
        svg += SvgText(kLeft - 8, y + 4, "end", 12,
                       ScientificText(std::pow(10.0, e), 0));
    }
    svg += Box(top_, bottom_, "none");
    svg += Box(exact_top_, exact_bottom_, "#f3f3f3", 0.6);
    svg += SvgText(kLeft - 8, (exact_top_ + exact_bottom_) / 2 + 4, "end", 12,
                   "exact", " font-weight=\"600\"");
    if (top_ > kTop) {
      svg += Box(kTop, top_ - kGap, "#f3f3f3", 0.6);
      svg += SvgText(kLeft - 8, (kTop + top_ - kGap) / 2 + 4, "end", 12,
                     "no number");
    }
    svg += SvgText(kLeft + kPlotWidth / 2, exact_bottom_ + 42, "middle", 13,
                   "time per receiver, one thread");
    return svg + SvgText(0, 0, "middle", 13, "relative error, RMS",
                         fmt::format(" transform=\"translate(18 {:.1f})"
                                     " rotate(-90)\"",
                                     (top_ + bottom_) / 2));
  }

  static std::string Box(double top, double bottom, const char* fill,
                         double opacity = 1) {
    return fmt::format(
        "<rect x=\"{}\" y=\"{:.1f}\" width=\"{}\" height=\"{:.1f}\""
        " fill=\"{}\" fill-opacity=\"{}\" stroke=\"{}\"/>\n",
        kLeft, top, kPlotWidth, bottom - top, fill, opacity, kFrame);
  }

  /// The marks of a group whose methods differ in effort only.
  [[nodiscard]] std::vector<const Mark*> EffortMarks(std::size_t group) const {
    std::vector<const Mark*> marks;
    for (const Mark& mark : marks_) {
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

  [[nodiscard]] const Mark* MarkOf(std::size_t method) const {
    const auto found = std::ranges::find(marks_, method, &Mark::method);
    return found == marks_.end() ? nullptr : &*found;
  }

  /// A stair: whoever accepts an error gets the time of the last step above.
  [[nodiscard]] std::string Front() const {
    std::string path;
    double x = 0;
    for (const std::size_t method : view_.front) {
      const Mark* mark = MarkOf(method);
      if (mark == nullptr) continue;
      path +=
          path.empty()
              ? fmt::format("M {:.1f} {:.1f} V {:.1f}", mark->x, top_, mark->y)
              : fmt::format(" H {:.1f} V {:.1f}", mark->x, mark->y);
      x = mark->x;
    }
    if (path.empty()) return "";
    if (x < kLeft + kPlotWidth)
      path += fmt::format(" H {:.1f}", kLeft + kPlotWidth);
    return fmt::format(
        "<path class=\"front\" d=\"{}\" fill=\"none\" stroke=\"#9a9a9a\""
        " stroke-width=\"1.5\" stroke-dasharray=\"5 3\"/>\n",
        path);
  }

  [[nodiscard]] std::string Stems() const {
    std::string svg;
    for (const Mark& mark : marks_) {
      const double largest = LargestError(mark);
      if (mark.place != Place::kPlot) continue;
      const double top = std::isfinite(largest) ? Y(largest) : top_;
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
    LabelLayout layout(
        {kLeft + 2, kTop, kLeft + kPlotWidth - 2, exact_bottom_});
    constexpr double kHalf = 6;
    for (const Mark& mark : marks_) {
      layout.Avoid(
          {mark.x - kHalf, mark.y - kHalf, mark.x + kHalf, mark.y + kHalf});
    }
    std::string svg;
    for (const std::size_t method : view_.front) {
      const Mark* mark = MarkOf(method);
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
    constexpr double kX = kLeft + kPlotWidth + 24;
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
  std::vector<Mark> marks_;
  DecadeAxis x_axis_;
  DecadeAxis y_axis_;
  double top_ = 0;  ///< of the plot
  double bottom_ = 0;
  double exact_top_ = 0;
  double exact_bottom_ = 0;
};

}  // namespace

std::string SpeedChart(const ReportView& view) {
  return Chart(view).Svg();
}

}  // namespace truelux
