// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/plan_objects.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "base/vector_math.h"

namespace truelux {
namespace {

using Ring = std::vector<Point3>;

/// Some consecutive elements of an array of the scene.
template <class T>
std::span<const T> Part(std::span<const T> all, int first, int count) {
  return all.subspan(static_cast<std::size_t>(first),
                     static_cast<std::size_t>(count));
}

Ring PointsOf(const Scene& scene, std::span<const int> vertices) {
  Ring ring;
  for (const int vertex : vertices)
    ring.push_back(scene.vertices()[static_cast<std::size_t>(vertex)]);
  return ring;
}

/// The face, or its triangles if it is not planar.
std::vector<Ring> PolygonsOf(const Scene& scene, const Face& face) {
  const auto facets = Part(scene.facets(), face.first_facet, face.facet_count);
  if (std::ranges::count(facets, false, &Facet::is_back) == 1) {
    return {PointsOf(
        scene, Part(scene.corners(), face.first_corner, face.corner_count))};
  }
  std::vector<Ring> polygons;
  for (const Facet& facet : facets) {
    if (facet.is_back) continue;
    for (const Triangle& triangle :
         Part(scene.triangles(), facet.first_triangle, facet.triangle_count))
      polygons.push_back(PointsOf(scene, triangle.vertices));
  }
  return polygons;
}

/// A point in the plane of the surface; nothing if it has no faces.
std::optional<Point3> PointOf(const Scene& scene,
                              std::span<const int> surface) {
  for (const Face& face : scene.faces()) {
    if (face.facet_count == 0 ||
        std::ranges::find(surface, face.group) == surface.end())
      continue;
    const int corner =
        scene.corners()[static_cast<std::size_t>(face.first_corner)];
    return scene.vertices()[static_cast<std::size_t>(corner)];
  }
  return {};
}

}  // namespace

std::vector<PlanObject> PlanObjectsOf(const Scene& scene,
                                      std::span<const int> surface,
                                      const Isolux& isolux) {
  // Rounding lifts a face in the plane of an inclined surface, and the surface
  // itself, by less.
  const double least_height = 1e-9 * isolux.size;
  const std::optional<Point3> base = PointOf(scene, surface);
  if (!base) return {};
  const Vector3 normal = Cross(isolux.right, isolux.up);
  const auto is_above = [&](const Point3& p) {
    return Dot(FromTo(*base, p), normal) > least_height;
  };
  std::vector<PlanObject> objects;
  std::map<std::pair<int, bool>, std::size_t> index;
  for (const Face& face : scene.faces()) {
    for (Ring& polygon : PolygonsOf(scene, face)) {
      if (std::ranges::none_of(polygon, is_above)) continue;
      const auto [place, is_new] =
          index.try_emplace({face.group, face.is_emitter}, objects.size());
      if (is_new) {
        objects.push_back(
            {scene.group_names()[static_cast<std::size_t>(face.group)],
             face.is_emitter,
             {}});
      }
      objects[place->second].faces.push_back(std::move(polygon));
    }
  }
  return objects;
}

}  // namespace truelux
