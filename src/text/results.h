// SPDX-License-Identifier: GPL-3.0-or-later
// Results as text: result columns of a table, statistics as JSON.

#ifndef TRUELUX_TEXT_RESULTS_H_
#define TRUELUX_TEXT_RESULTS_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "truelux/irradiance.h"
#include "truelux/scene.h"
#include "truelux/statistics.h"

namespace truelux {

/// Appends the shortest decimal that reads back to the same binary64; "inf"
/// for infinity, "nan" for no number.
void AppendNumber(std::string& text, double value);

/// Names of the result columns, with a separator before each: E_r, E_g, E_b
/// [W/m^2], and the bounds of their errors if the method is kDouble.
std::string ResultHeader(Method method, char separator = ',');

/// Appends one row's results, with a separator before each, as ResultHeader
/// names them.
void AppendResult(std::string& text, const Irradiance& irradiance,
                  Method method, char separator = ',');

/// What a run did, for --stats.
struct RunReport {
  std::string_view version;
  double load_seconds = 0;
  double evaluate_seconds = 0;
  int threads = 0;
  std::uint64_t receivers = 0;
  OracleOptions options;
  Statistics statistics;
  std::vector<LeftOutFaces> left_out;  ///< of the scene
};

/// The report as a JSON object, ended by a line end.
std::string JsonText(const RunReport& report);

}  // namespace truelux

#endif  // TRUELUX_TEXT_RESULTS_H_
