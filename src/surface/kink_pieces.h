// SPDX-License-Identifier: GPL-3.0-or-later
// Where on a flat surface the gradient of irradiance jumps, decided exactly.

#ifndef TRUELUX_SURFACE_KINK_PIECES_H_
#define TRUELUX_SURFACE_KINK_PIECES_H_

#include <array>
#include <cstddef>
#include <vector>

#include "truelux/geometry.h"
#include "truelux/scene.h"
#include "truelux/stop.h"

#include "exact/rational.h"
#include "surface/edge_planes.h"
#include "surface/surface_frame.h"

namespace truelux {

/// A part of the trace of a plane on the surface on which the gradient jumps.
struct KinkPiece {
  RationalVector from;  ///< exact points of the surface's plane
  RationalVector to;
  /// b [W/m^3] in the middle, per channel, with a relative error below 1e-12.
  Rgb size{};
  /// The numbers of the faces in the plane, seen edge-on, that cause it;
  /// ascending.
  std::vector<int> faces;
  /// The edges in the plane that cause it, by indices into Scene::vertices(),
  /// ascending: those on whose lines the light of the strips beside the plane
  /// differs. A line where faces pierce each other is none.
  std::vector<std::array<int, 2>> edges;
};

/// The parts of the trace of a plane, between two of its points, on which the
/// gradient of irradiance jumps across the plane. Each is as long as its causes
/// stay the same; they are in the order from `from` to `to`.
///
/// Receivers lie on the surface, and look to the front of the frame's first
/// face, or to its back if reversed_side. All faces in the plane of the surface
/// are left out. Where a face stands on the surface along the trace irradiance
/// itself jumps: that is no kink.
///
/// What is seen is decided exactly. Whether parts of it cancel is decided
/// exactly direction by direction; where the sum over directions vanishes at
/// two points of a piece, to 2^-160 of its terms, there is no kink, either.
///
/// planes: of the scene and the surface. from, to: two different points in the
/// surface's plane and in planes.planes[plane_index]. stop: may be null. Throws
/// Stopped, and std::invalid_argument for other points.
[[nodiscard]] std::vector<KinkPiece> KinkPiecesOf(
    const Scene& scene, const SurfaceFrame& frame, const EdgePlanes& planes,
    std::size_t plane_index, const RationalVector& from,
    const RationalVector& to, bool reversed_side,
    const StopFlag* stop = nullptr);

}  // namespace truelux

#endif  // TRUELUX_SURFACE_KINK_PIECES_H_
