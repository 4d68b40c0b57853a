// SPDX-License-Identifier: GPL-3.0-or-later
// Contours for programs that draw: DXF of AutoCAD release 12, which all read.
//
// Source: AutoCAD Release 12, Drawing Interchange File format: groups of a code
// and a value, each on a line.

#ifndef TRUELUX_PLAN_PLAN_DXF_H_
#define TRUELUX_PLAN_PLAN_DXF_H_

#include <string>

#include "truelux/isolux.h"

namespace truelux {

/// The layer of a level's contours: "LEVEL_" and the level, with _ for its
/// point, which names of layers may not have.
[[nodiscard]] std::string LayerOf(double level);

/// Contours as three-dimensional polylines in the scene's frame, one layer a
/// level; lines on the layers OUTLINE, JUMPS and KINKS; open triangles as faces
/// on the layer OPEN.
[[nodiscard]] std::string PlanDxf(const Isolux& isolux);

}  // namespace truelux

#endif  // TRUELUX_PLAN_PLAN_DXF_H_
