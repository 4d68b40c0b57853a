// SPDX-License-Identifier: GPL-3.0-or-later
// A comparison as tables.

#ifndef TRUELUX_STUDY_COMPARISON_CSV_H_
#define TRUELUX_STUDY_COMPARISON_CSV_H_

#include <string>
#include <string_view>

#include "study/comparison.h"

namespace truelux {

/// A text as one field of a table: in quotes where it needs them (RFC 4180).
std::string CsvField(std::string_view text);

/// One row per method: its time and its errors.
std::string MethodsCsv(const Comparison& comparison);

/// One row per receiver: what it is, the truth, the reason, and for each method
/// the mean of the channels and the largest relative error of a channel with
/// truth > 0. Empty: no value, or no such channel.
std::string ReceiversCsv(const Comparison& comparison);

}  // namespace truelux

#endif  // TRUELUX_STUDY_COMPARISON_CSV_H_
