// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/speed_chart_layout.h"

#include <algorithm>
#include <cmath>

namespace truelux {
namespace {

constexpr double kDecadeHeight = 25;
constexpr double kLeastHeight = 300;
constexpr double kMostHeight = 520;
constexpr double kRowHeight = 15;

double BandHeight(double rows) {
  return (rows + 0.5) * kRowHeight;
}

}  // namespace

SpeedChartLayout::SpeedChartLayout(const ReportView& view) {
  CollectMarks(view);
  CoverAxes(view);
  PlaceMarks();
}

void SpeedChartLayout::CollectMarks(const ReportView& view) {
  constexpr double kLeastMicroseconds = 1e-4;  // no clock shows less
  for (std::size_t m = 0; m < view.summaries.size(); ++m) {
    const MethodSummary& summary = view.summaries[m];
    if (summary.answered == 0) continue;
    Mark mark;
    mark.method = m;
    mark.microseconds =
        std::max(view.comparison.methods[m].microseconds, kLeastMicroseconds);
    mark.error = ErrorInChart(summary);
    if (mark.error == 0) mark.place = Place::kExact;
    if (std::isinf(mark.error)) mark.place = Place::kNoNumber;
    marks_.push_back(mark);
  }
}

void SpeedChartLayout::CoverAxes(const ReportView& view) {
  for (const Mark& mark : marks_) {
    x_axis_.Cover(mark.microseconds);
    if (mark.place != Place::kPlot) continue;
    y_axis_.Cover(mark.error);
    const double largest = view.summaries[mark.method].relative->max;
    if (std::isfinite(largest)) y_axis_.Cover(largest);
  }
  if (marks_.empty()) x_axis_.Cover(1);
  if (y_axis_.high < y_axis_.low) {
    // Nothing is wrong: an axis from rounding to one.
    y_axis_.Cover(1e-16);
    y_axis_.Cover(1);
  }
}

void SpeedChartLayout::PlaceMarks() {
  for (Mark& mark : marks_)
    mark.x = X(mark.microseconds);
  const double above = FillBand(Place::kNoNumber);
  const double below = std::max(FillBand(Place::kExact), 1.0);
  top_ = kTop + (above > 0 ? BandHeight(above) + kGap : 0);
  bottom_ = top_ + std::clamp(kDecadeHeight * (y_axis_.high - y_axis_.low),
                              kLeastHeight, kMostHeight);
  exact_bottom_ = exact_top() + BandHeight(below);
  for (Mark& mark : marks_) {
    const double row = (static_cast<double>(mark.row) + 0.75) * kRowHeight;
    switch (mark.place) {
      case Place::kPlot:
        mark.y = Y(mark.error);
        break;
      case Place::kExact:
        mark.y = exact_top() + row;
        break;
      case Place::kNoNumber:
        mark.y = kTop + row;
        break;
    }
  }
}

/// Puts the marks of a band into rows in which none covers another; returns
/// the number of rows.
double SpeedChartLayout::FillBand(Place place) {
  std::vector<Mark*> in_band;
  for (Mark& mark : marks_) {
    if (mark.place == place) in_band.push_back(&mark);
  }
  std::ranges::stable_sort(
      in_band, [](const Mark* a, const Mark* b) { return a->x < b->x; });
  constexpr double kLeastDistance = 12;
  std::vector<double> last_x;  // of each row
  for (Mark* mark : in_band) {
    const auto row = std::ranges::find_if(
        last_x, [mark](double x) { return x + kLeastDistance <= mark->x; });
    mark->row = static_cast<std::size_t>(row - last_x.begin());
    if (row == last_x.end()) {
      last_x.push_back(mark->x);
    } else {
      *row = mark->x;
    }
  }
  return static_cast<double>(last_x.size());
}

double SpeedChartLayout::X(double microseconds) const {
  return kLeft + (kRight - kLeft) * x_axis_.At(microseconds);
}

double SpeedChartLayout::Y(double error) const {
  return bottom_ - (bottom_ - top_) * y_axis_.At(error);
}

const SpeedChartLayout::Mark* SpeedChartLayout::Find(std::size_t method) const {
  const auto found = std::ranges::find(marks_, method, &Mark::method);
  return found == marks_.end() ? nullptr : &*found;
}

}  // namespace truelux
