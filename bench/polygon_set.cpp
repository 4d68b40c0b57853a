// SPDX-License-Identifier: GPL-3.0-or-later
#include "polygon_set.h"

#include <cmath>
#include <cstddef>
#include <iterator>
#include <list>
#include <numbers>
#include <vector>

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_set_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include "exact/vec3.h"

namespace truelux::bench {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using Polygon = CGAL::Polygon_2<Kernel>;
using PolygonWithHoles = CGAL::Polygon_with_holes_2<Kernel>;
using PolygonSet = CGAL::Polygon_set_2<Kernel>;
using Vec = Vec3<double>;

/// The projection from r on the plane at height h over r, r at the origin.
Kernel::Point_2 Project(const Point3& p, const Point3& r, const Number& h) {
  const Number scale = h / (Number(p.z) - Number(r.z));
  return {(Number(p.x) - Number(r.x)) * scale,
          (Number(p.y) - Number(r.y)) * scale};
}

Polygon ProjectTriangle(const Scene& scene, const Triangle& triangle,
                        const Point3& r, const Number& h) {
  Polygon polygon;
  for (const int vertex : triangle.vertices) {
    polygon.push_back(
        Project(scene.vertices()[static_cast<std::size_t>(vertex)], r, h));
  }
  if (polygon.is_clockwise_oriented()) polygon.reverse_orientation();
  return polygon;
}

/// Sum over the edges of a ring of angle * (unit normal of its plane . n).
double LambertSum(const Polygon& ring, const Vec& n, double h) {
  std::vector<Vec> corners;
  for (const Kernel::Point_2& p : ring.vertices())
    corners.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), h});
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec& a = corners[i];
    const Vec& b = corners[(i + 1) % corners.size()];
    const Vec normal = Cross(a, b);
    const double length = std::sqrt(Dot(normal, normal));
    if (length > 0)
      sum += std::atan2(length, Dot(a, b)) / length * Dot(normal, n);
  }
  return sum;
}

}  // namespace

Rgb PolygonSetIrradiance(const Scene& scene, const Receiver& receiver) {
  const Point3& r = receiver.position;
  const Face& source = scene.faces()[0];
  const auto is_source = [&](const Triangle& triangle) {
    return scene.facets()[static_cast<std::size_t>(triangle.facet)].face == 0;
  };
  const double z = scene
                       .vertices()[static_cast<std::size_t>(
                           scene.triangles()[0].vertices[0])]
                       .z;
  const Number h = Number(z) - Number(r.z);
  std::vector<Polygon> shadows;
  std::vector<Polygon> lit;
  for (const Triangle& triangle : scene.triangles()) {
    const Polygon polygon = ProjectTriangle(scene, triangle, r, h);
    if (polygon.is_empty() || polygon.area() == 0) continue;
    (is_source(triangle) ? lit : shadows).push_back(polygon);
  }
  PolygonSet visible;
  visible.join(lit.begin(), lit.end());
  PolygonSet shadow;
  shadow.join(shadows.begin(), shadows.end());
  visible.difference(shadow);

  std::list<PolygonWithHoles> pieces;
  visible.polygons_with_holes(std::back_inserter(pieces));
  const Vec normal{receiver.normal.x, receiver.normal.y, receiver.normal.z};
  const Vec unit = 1 / std::sqrt(Dot(normal, normal)) * normal;
  const double height = z - r.z;
  double sum = 0;
  for (const PolygonWithHoles& piece : pieces) {
    sum += LambertSum(piece.outer_boundary(), unit, height);
    for (const Polygon& hole : piece.holes())
      sum += LambertSum(hole, unit, height);
  }
  const double factor = sum / (2 * std::numbers::pi);
  return {source.emission[0] * factor, source.emission[1] * factor,
          source.emission[2] * factor};
}

}  // namespace truelux::bench
