// SPDX-License-Identifier: GPL-3.0-or-later
#include "double_rays.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "exact/vec3.h"

namespace truelux::bench {
namespace {

using Vec = Vec3<double>;

/// The part of a ray in which it can be blocked. The rest leaves out the
/// emitter itself: the samples on it are rounded to float.
constexpr double kEnd = 1 - 1e-6;

Vec Between(const Point3& from, const Point3& to) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

/// Whether the ray meets the triangle before kEnd (Moeller and Trumbore).
bool Blocks(const std::array<Point3, 3>& triangle, const Point3& origin,
            const Vec& ray) {
  const Vec side1 = Between(triangle[0], triangle[1]);
  const Vec side2 = Between(triangle[0], triangle[2]);
  const Vec across = Cross(ray, side2);
  const double determinant = Dot(side1, across);
  if (determinant == 0) return false;
  const Vec offset = Between(triangle[0], origin);
  const double u = Dot(offset, across) / determinant;
  if (u < 0 || u > 1) return false;
  const Vec turned = Cross(offset, side1);
  const double v = Dot(ray, turned) / determinant;
  if (v < 0 || u + v > 1) return false;
  const double t = Dot(side2, turned) / determinant;
  return t > 0 && t < kEnd;
}

}  // namespace

DoubleRays::DoubleRays(const Scene& scene) {
  for (const Triangle& triangle : scene.triangles()) {
    Corners corners;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      corners[k] =
          scene.vertices()[static_cast<std::size_t>(triangle.vertices[k])];
    }
    triangles_.push_back(corners);
  }
}

double DoubleRays::Estimate(const Receiver& receiver,
                            const EmitterSamples& samples) const {
  const Vec normal = {receiver.normal.x, receiver.normal.y, receiver.normal.z};
  const double length = std::sqrt(Dot(normal, normal));
  double sum = 0;
  for (const EmitterSamples::Point& point : samples.points) {
    const auto& piece = samples.pieces[static_cast<std::size_t>(point.piece)];
    const Vec front = {piece.normal[0], piece.normal[1], piece.normal[2]};
    const Vec ray =
        Between(receiver.position,
                {point.position[0], point.position[1], point.position[2]});
    const double here = Dot(normal, ray) / length;
    const double there = -Dot(front, ray);
    if (!(here > 0 && there > 0)) continue;
    const bool blocked =
        std::ranges::any_of(triangles_, [&](const Corners& triangle) {
          return Blocks(triangle, receiver.position, ray);
        });
    const double square = Dot(ray, ray);
    if (!blocked) sum += piece.exitance[0] * here * there / (square * square);
  }
  return samples.area * sum /
         (std::numbers::pi * static_cast<double>(samples.points.size()));
}

}  // namespace truelux::bench
