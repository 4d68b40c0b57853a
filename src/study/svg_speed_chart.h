// SPDX-License-Identifier: GPL-3.0-or-later
// Error against time, one mark per method.

#ifndef TRUELUX_STUDY_SVG_SPEED_CHART_H_
#define TRUELUX_STUDY_SVG_SPEED_CHART_H_

#include <string>

#include "study/report_view.h"

namespace truelux {

/// An <svg> element for a page. Both axes are logarithmic; methods without any
/// error stand in a band of their own below, those whose error is no number or
/// infinite above. The colour and shape of a mark belong to the method's group;
/// a thin line goes up to the method's largest error; hovering shows its
/// numbers. Methods without any value are left out.
///
/// Drawn are the methods that no other beats (ReportView::front) with a line
/// and their names. Methods of one group that differ in effort only, such as
/// "Embree Sobol 64", are joined by a line with the least and the greatest
/// effort beside its ends.
std::string SpeedChart(const ReportView& view);

}  // namespace truelux

#endif  // TRUELUX_STUDY_SVG_SPEED_CHART_H_
