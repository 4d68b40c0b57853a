// SPDX-License-Identifier: GPL-3.0-or-later
// What an exact library for Boolean operations does with the same question.

#ifndef TRUELUX_BENCH_POLYGON_SET_H_
#define TRUELUX_BENCH_POLYGON_SET_H_

#include "truelux/geometry.h"
#include "truelux/receiver.h"
#include "truelux/scene.h"

namespace truelux::bench {

/// The irradiance [W/m^2] from face 1, a convex polygon in a plane z =
/// constant above the receiver, with all other triangles between the two: the
/// triangles are projected on the source's plane exactly, joined, and taken
/// from the source by CGAL::Polygon_set_2 with the kernel Epeck; Lambert's
/// formula, in double, gives the value. The source must lie above the horizon.
Rgb PolygonSetIrradiance(const Scene& scene, const Receiver& receiver);

}  // namespace truelux::bench

#endif  // TRUELUX_BENCH_POLYGON_SET_H_
