// SPDX-License-Identifier: GPL-3.0-or-later
// Faces and edges in words.

#ifndef TRUELUX_EXPLAIN_EDGE_TEXT_H_
#define TRUELUX_EXPLAIN_EDGE_TEXT_H_

#include <string>

#include "truelux/geometry.h"
#include "truelux/scene.h"

#include "visibility/view/seen_edge.h"

namespace truelux {

/// "(0, 0.5, -1)", every number the shortest that reads back.
[[nodiscard]] std::string TextOf(const Point3& point);

/// "face 12 (line 40, Table/top)"; what is not known is left out. face: its
/// number, from 1.
[[nodiscard]] std::string TextOfFace(const Scene& scene, int face);

/// "face 12 (line 40, Table/top), edge (0, 0, 1) to (0, 1, 1)", or "face 3
/// where it meets the plane of face 5".
[[nodiscard]] std::string TextOf(const Scene& scene, const SeenEdge& edge);

}  // namespace truelux

#endif  // TRUELUX_EXPLAIN_EDGE_TEXT_H_
