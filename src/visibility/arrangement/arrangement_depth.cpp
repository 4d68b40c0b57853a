// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/arrangement/arrangement_depth.h"

#include <cassert>

namespace truelux {
namespace {

ImageDirection Flat(const ImagePoint& p) {
  return {p.x, p.y, p.w};
}

}  // namespace

ImagePlane PlaneOf(const ImageTriangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  // The cofactors of the rows a, b, c: a plane that holds all three.
  ImagePlane plane{
      Determinant<Exact>({a.y, a.z, a.w}, {b.y, b.z, b.w}, {c.y, c.z, c.w}),
      -Determinant<Exact>({a.x, a.z, a.w}, {b.x, b.z, b.w}, {c.x, c.z, c.w}),
      Determinant<Exact>({a.x, a.y, a.w}, {b.x, b.y, b.w}, {c.x, c.y, c.w}),
      -Determinant<Exact>({a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z})};
  assert(SignOf(plane.z) != Sign::kZero);
  if (SignOf(plane.z) == Sign::kNegative) {
    plane = {-plane.x, -plane.y, -plane.z, -plane.w};
  }
  return plane;
}

Vec3<Exact> DepthDifference(const ImagePlane& a, const ImagePlane& b) {
  // Z = -(x X + y Y + w) / z, times both z.
  return {b.x * a.z - a.x * b.z, b.y * a.z - a.y * b.z, b.w * a.z - a.w * b.z};
}

std::optional<std::pair<ImageDirection, ImageDirection>> LineInTriangle(
    const Vec3<Exact>& f, const ImageTriangle& triangle) {
  std::vector<ImageDirection> ends;
  for (std::size_t k = 0; k < 3; ++k) {
    const ImageDirection p = Flat(triangle.corners[k]);
    const ImageDirection q = Flat(triangle.corners[(k + 1) % 3]);
    const Exact at_p = Dot(f, p);
    const Exact at_q = Dot(f, q);
    if (SignOf(at_p) == Sign::kZero) ends.push_back(p);
    if (SignOf(at_p) * SignOf(at_q) == Sign::kNegative) {
      // f is 0 between p and q; the factors keep the depth w positive.
      const bool p_first = SignOf(at_p) == Sign::kPositive;
      ends.push_back(p_first ? at_p * q - at_q * p : at_q * p - at_p * q);
    }
  }
  if (ends.size() != 2) return std::nullopt;
  return std::pair{ends[0], ends[1]};
}

}  // namespace truelux
