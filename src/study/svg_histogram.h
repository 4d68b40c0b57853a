// SPDX-License-Identifier: GPL-3.0-or-later
// A method's errors at a glance.

#ifndef TRUELUX_STUDY_SVG_HISTOGRAM_H_
#define TRUELUX_STUDY_SVG_HISTOGRAM_H_

#include <cstddef>
#include <string>

#include "study/comparison_summary.h"

namespace truelux {

/// An <svg> element for a page: one bar per decade of relative error, apart
/// from it exact values on the left, and light where there is none and missing
/// values on the right. scale: the count of the highest bar; what is higher is
/// cut off and marked. Counts outside the decades are written on top.
std::string HistogramSvg(const ErrorHistogram& histogram, std::size_t scale,
                         std::size_t series);

}  // namespace truelux

#endif  // TRUELUX_STUDY_SVG_HISTOGRAM_H_
