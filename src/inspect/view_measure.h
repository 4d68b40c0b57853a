// SPDX-License-Identifier: GPL-3.0-or-later
// Angles and sizes of what a receiver sees.

#ifndef TRUELUX_INSPECT_VIEW_MEASURE_H_
#define TRUELUX_INSPECT_VIEW_MEASURE_H_

#include <cstddef>
#include <vector>

#include "inspect/projection.h"
#include "visibility/view/whole_view.h"

namespace truelux {

/// An arc of a view in the frame of a receiver, in its sense.
[[nodiscard]] CircleArc ArcInFrame(const WholeView& view,
                                   const WholeViewArc& arc,
                                   const ViewFrame& frame);

/// The angle of an arc [rad]; 2 pi for the whole horizon.
[[nodiscard]] double AngleOfArc(const WholeView& view, const WholeViewArc& arc);

/// A vector's components right, up, ahead.
[[nodiscard]] Vector3 InFrame(const Vector3& v, const ViewFrame& frame);

/// The border of a region: its loops, each run through with the region on the
/// left for somebody outside of the hemisphere.
[[nodiscard]] std::vector<std::vector<CircleArc>> BorderOf(
    const WholeView& view, int region, const ViewFrame& frame);

/// The solid angle inside a border [sr]: the sum over its arcs of the signed
/// spherical triangles with one direction near the middle of it. In double
/// from rounded directions: the absolute error is a few 1e-16 times the length
/// of the border [rad] plus a few units in the last place of the result.
[[nodiscard]] double SolidAngleOf(
    const std::vector<std::vector<CircleArc>>& border);

/// A unit vector near the middle of a border, not necessarily inside.
[[nodiscard]] Vector3 MiddleOf(
    const std::vector<std::vector<CircleArc>>& border);

}  // namespace truelux

#endif  // TRUELUX_INSPECT_VIEW_MEASURE_H_
