// SPDX-License-Identifier: GPL-3.0-or-later
// Which of two image triangles is nearer, and along which line they cross.

#ifndef TRUELUX_VISIBILITY_ARRANGEMENT_ARRANGEMENT_DEPTH_H_
#define TRUELUX_VISIBILITY_ARRANGEMENT_ARRANGEMENT_DEPTH_H_

#include <optional>
#include <utility>
#include <vector>

#include "visibility/arrangement/arrangement_types.h"

namespace truelux {

/// The plane of an image triangle: x X + y Y + z Z + w = 0, z > 0.
struct ImagePlane {
  Exact x;
  Exact y;
  Exact z;
  Exact w;
};

/// Requires that the triangle is not seen edge-on.
ImagePlane PlaneOf(const ImageTriangle& triangle);

/// The linear function [x, y, w] that is, up to a positive factor, Z of a
/// minus Z of b at [X:Y:1]: negative where a is nearer.
Vec3<Exact> DepthDifference(const ImagePlane& a, const ImagePlane& b);

/// The part of the line f = 0 inside a triangle's image, by its ends; nothing
/// if it is empty or a point.
std::optional<std::pair<ImageDirection, ImageDirection>> LineInTriangle(
    const Vec3<Exact>& f, const ImageTriangle& triangle);

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_ARRANGEMENT_ARRANGEMENT_DEPTH_H_
