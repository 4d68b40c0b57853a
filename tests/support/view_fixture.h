// SPDX-License-Identifier: GPL-3.0-or-later
// A view of a few triangles, for tests of the exact layer.

#ifndef TRUELUX_TESTS_SUPPORT_VIEW_FIXTURE_H_
#define TRUELUX_TESTS_SUPPORT_VIEW_FIXTURE_H_

#include <vector>

#include "exact/view_geometry.h"

namespace truelux::testing {

/// A few triangles and a receiver, kept alive together.
struct ViewFixture {
  std::vector<Point3> vertices;
  std::vector<Triangle> triangles;
  IdVector<TriangleId, FilteredPlane> normals;
  Point3 position;
  Vector3 normal{0, 0, 1};

  void AddTriangle(const Point3& a, const Point3& b, const Point3& c) {
    const int first = static_cast<int>(vertices.size());
    vertices.insert(vertices.end(), {a, b, c});
    triangles.push_back({{first, first + 1, first + 2}, 0});
  }

  ViewGeometry Make() {
    normals = FilteredTriangleNormals(vertices, triangles);
    return ViewGeometry(
        {IdSpan<VertexId, const Point3>(vertices),
         IdSpan<TriangleId, const Triangle>(triangles), position, normal},
        normals);
  }
};

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_SUPPORT_VIEW_FIXTURE_H_
