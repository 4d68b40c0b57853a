// SPDX-License-Identifier: GPL-3.0-or-later
// What the words of truelux isolux ask for.

#ifndef TRUELUX_CLI_ISOLUX_REQUEST_H_
#define TRUELUX_CLI_ISOLUX_REQUEST_H_

#include <string>
#include <vector>

#include "truelux/irradiance.h"
#include "truelux/isolux.h"

#include "cli/cmd_isolux.h"
#include "cli/output_paths.h"

namespace truelux {

/// How contours are written.
enum class PlanFormat { kCsv, kJson, kSvg, kDxf };

/// What is to be done, as plain values.
struct IsoluxRequest {
  SceneRequest scene;
  std::string surface;
  OracleOptions options;
  IsoluxOptions wishes;
  /// No contours are looked for, only the lines at which light jumps.
  bool only_lines = false;
  /// All files that are written: of contours in `formats`, then the lines, if
  /// has_lines.
  OutputPaths outputs;
  std::vector<PlanFormat> formats;
  bool has_lines = false;
};

/// Throws UsageError if the words do not fit together or are no numbers.
IsoluxRequest ParseIsoluxRequest(const IsoluxArguments& arguments);

}  // namespace truelux

#endif  // TRUELUX_CLI_ISOLUX_REQUEST_H_
