// SPDX-License-Identifier: GPL-3.0-or-later
// What the words of truelux isolux ask for.

#ifndef TRUELUX_CLI_ISOLUX_REQUEST_H_
#define TRUELUX_CLI_ISOLUX_REQUEST_H_

#include <optional>
#include <string>
#include <vector>

#include "truelux/irradiance.h"
#include "truelux/isolux.h"
#include "truelux/isomesh.h"

#include "cli/input_arguments.h"
#include "cli/output_paths.h"

namespace truelux {

/// The words of the command line, before they are looked at.
struct IsoluxArguments {
  SceneArguments scene;
  std::string surface;
  std::optional<std::string> levels;
  std::optional<std::string> count;
  std::optional<std::string> channel;
  std::vector<std::string> outputs;
  std::optional<std::string> lines;
  std::optional<std::string> extrema;
  std::string chord = "0";
  std::string half_width = "0";
  std::string smallest = "0";
  std::optional<std::string> most_triangles;
  std::optional<std::string> mesh_error;
  std::optional<std::string> mesh_smallest;
  std::optional<std::string> mesh_vertices;
  std::string method;
  std::string emission;
  std::string threads;
};

/// How contours are written, and the mesh along them.
enum class PlanFormat { kCsv, kJson, kSvg, kDxf, kObj, kPly, kVtu };

/// Whether a file has the mesh.
[[nodiscard]] constexpr bool IsOfMesh(PlanFormat format) {
  return format >= PlanFormat::kObj;
}

/// What is to be done, as plain values.
struct IsoluxRequest {
  SceneRequest scene;
  std::string surface;
  OracleOptions options;
  IsoluxOptions wishes;
  IsoMeshOptions mesh_wishes;  ///< without those of contours
  bool has_contours = true;    ///< whether contours are looked for
  bool has_mesh = false;       ///< and a mesh along them
  /// All files that are written: of contours in `formats`, then the lines, if
  /// has_lines, and extrema, if has_extrema.
  OutputPaths outputs;
  std::vector<PlanFormat> formats;
  bool has_lines = false;
  bool has_extrema = false;
};

/// Throws UsageError if the words do not fit together or are no numbers.
IsoluxRequest ParseIsoluxRequest(const IsoluxArguments& arguments);

}  // namespace truelux

#endif  // TRUELUX_CLI_ISOLUX_REQUEST_H_
