// SPDX-License-Identifier: GPL-3.0-or-later
// Contours, and lines at which light jumps, as tables.

#ifndef TRUELUX_PLAN_PLAN_TABLES_H_
#define TRUELUX_PLAN_PLAN_TABLES_H_

#include <array>
#include <span>
#include <string>
#include <vector>

#include "truelux/isolux.h"
#include "truelux/scene.h"

namespace truelux {

/// By index into Scene::vertices(): the number of the vertex in the scene's
/// file, the first one of several in one place; 0: no face has it.
[[nodiscard]] std::vector<int> VertexNumbers(const Scene& scene);

/// "12-15;3-4": edges by the numbers of their vertices; "cut" where faces pierce
/// each other.
[[nodiscard]] std::string EdgeText(std::span<const std::array<int, 2>> edges,
                                   std::span<const int> vertex_numbers);

/// One row a vertex of a contour, below a header. Of the last vertex of a line
/// that is open the chord is empty, since none begins there.
[[nodiscard]] std::string ContourCsv(const Isolux& isolux);

/// One row a line, below a header; what a kind of line does not have is empty.
[[nodiscard]] std::string SurfaceLineCsv(const SurfaceLines& lines,
                                         std::span<const int> vertex_numbers);

/// One row a critical point, then one a region that is undecided, with the middle
/// of its first triangle as its place and no E.
[[nodiscard]] std::string ExtremaCsv(const SurfaceExtrema& extrema);

}  // namespace truelux

#endif  // TRUELUX_PLAN_PLAN_TABLES_H_
