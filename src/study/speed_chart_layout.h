// SPDX-License-Identifier: GPL-3.0-or-later
// Where everything stands in the chart of speed against error.

#ifndef TRUELUX_STUDY_SPEED_CHART_LAYOUT_H_
#define TRUELUX_STUDY_SPEED_CHART_LAYOUT_H_

#include <cstddef>
#include <vector>

#include "draw/svg_axis.h"
#include "study/report_view.h"

namespace truelux {

/// The plot, with a band below it for methods without any error and, if
/// needed, one above it for errors that are no number or infinite. In pixels,
/// y downwards.
class SpeedChartLayout {
 public:
  enum class Place { kPlot, kExact, kNoNumber };

  /// A method in the chart.
  struct Mark {
    std::size_t method = 0;
    double microseconds = 0;
    double error = 0;  ///< as ErrorInChart
    Place place = Place::kPlot;
    std::size_t row = 0;  ///< in its band
    double x = 0;
    double y = 0;
  };

  /// Methods without any value have no mark.
  explicit SpeedChartLayout(const ReportView& view);

  static constexpr double kLeft = 84;  ///< of plot and bands
  static constexpr double kRight = 814;
  static constexpr double kTop = 14;
  static constexpr double kGap = 10;  ///< between the plot and its bands

  [[nodiscard]] const std::vector<Mark>& marks() const { return marks_; }

  [[nodiscard]] const DecadeAxis& x_axis() const { return x_axis_; }

  [[nodiscard]] const DecadeAxis& y_axis() const { return y_axis_; }

  [[nodiscard]] bool HasNoNumberBand() const { return top_ > kTop; }

  [[nodiscard]] double top() const { return top_; }  ///< of the plot

  [[nodiscard]] double bottom() const { return bottom_; }

  [[nodiscard]] double exact_top() const { return bottom_ + kGap; }

  [[nodiscard]] double exact_bottom() const { return exact_bottom_; }

  [[nodiscard]] double X(double microseconds) const;
  [[nodiscard]] double Y(double error) const;

  /// The mark of a method; null if it has none.
  [[nodiscard]] const Mark* Find(std::size_t method) const;

 private:
  void CollectMarks(const ReportView& view);
  void CoverAxes(const ReportView& view);
  void PlaceMarks();
  double FillBand(Place place);

  std::vector<Mark> marks_;
  DecadeAxis x_axis_;
  DecadeAxis y_axis_;
  double top_ = 0;
  double bottom_ = 0;
  double exact_bottom_ = 0;
};

}  // namespace truelux

#endif  // TRUELUX_STUDY_SPEED_CHART_LAYOUT_H_
