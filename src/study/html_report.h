// SPDX-License-Identifier: GPL-3.0-or-later
// A comparison as one page.

#ifndef TRUELUX_STUDY_HTML_REPORT_H_
#define TRUELUX_STUDY_HTML_REPORT_H_

#include <string>

#include "study/comparison.h"

namespace truelux {

/// A self-contained HTML5 page that is also well-formed XML: the chart of speed
/// against error, a table of the methods, their error histograms and the worst
/// receivers. Needs no network, no other file and no script. Requires one truth
/// and one reason per receiver, and one value or nothing per receiver and
/// method.
std::string HtmlReport(const Comparison& comparison);

}  // namespace truelux

#endif  // TRUELUX_STUDY_HTML_REPORT_H_
