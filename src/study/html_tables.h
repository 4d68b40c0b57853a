// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of a report's page.

#ifndef TRUELUX_STUDY_HTML_TABLES_H_
#define TRUELUX_STUDY_HTML_TABLES_H_

#include <string>

#include "study/report_view.h"

namespace truelux {

/// Per bound on the error the fastest method that keeps it at every receiver.
std::string ChoiceTable(const ReportView& view);

/// All methods with their numbers.
std::string MethodsTable(const ReportView& view);

/// Per group of methods the receivers with the largest errors.
std::string WorstTables(const ReportView& view);

}  // namespace truelux

#endif  // TRUELUX_STUDY_HTML_TABLES_H_
