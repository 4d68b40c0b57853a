// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a triangle meets the hull of a receiver and a source, with exact
// numbers and no geometry but the separating axes.

#ifndef TRUELUX_TESTS_SCENE_INDEX_HULL_TWIN_H_
#define TRUELUX_TESTS_SCENE_INDEX_HULL_TWIN_H_

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "truelux/geometry.h"
#include "truelux/scene.h"

#include "exact/number.h"
#include "exact/sign.h"
#include "exact/vec3.h"

namespace truelux::testing {

using ExactPoint = Vec3<Exact>;

inline ExactPoint ToExact(const Point3& p) {
  return {Exact(p.x), Exact(p.y), Exact(p.z)};
}

/// Whether all of `a` lies strictly on one side of all of `b` along an axis.
inline bool Separates(const ExactPoint& axis, std::span<const ExactPoint> a,
                      std::span<const ExactPoint> b) {
  const auto extent = [&axis](std::span<const ExactPoint> points) {
    std::array<Exact, 2> ends{Dot(axis, points[0]), Dot(axis, points[0])};
    for (const ExactPoint& p : points.subspan(1)) {
      const Exact x = Dot(axis, p);
      if (x < ends[0]) ends[0] = x;
      if (ends[1] < x) ends[1] = x;
    }
    return ends;
  };
  const auto [a_least, a_most] = extent(a);
  const auto [b_least, b_most] = extent(b);
  return a_most < b_least || b_most < a_least;
}

/// Whether a closed triangle meets a closed tetrahedron, which must have a
/// volume: then the facets of their Minkowski difference are normal to a face
/// of either or to an edge of both, and one of these axes tells them apart.
inline bool Meets(const std::array<ExactPoint, 3>& triangle,
                  const std::array<ExactPoint, 4>& tetrahedron) {
  const auto apart = [&](const ExactPoint& axis) {
    return Separates(axis, triangle, tetrahedron);
  };
  std::vector<ExactPoint> edges;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j)
      edges.push_back(tetrahedron[j] - tetrahedron[i]);
  }
  // Faces of the tetrahedron hold two of its edges.
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      if (apart(Cross(edges[i], edges[j]))) return false;
    }
  }
  const ExactPoint u = triangle[1] - triangle[0];
  const ExactPoint v = triangle[2] - triangle[0];
  if (apart(Cross(u, v))) return false;
  for (const ExactPoint& side : {u, v, v - u}) {
    for (const ExactPoint& edge : edges) {
      if (apart(Cross(side, edge))) return false;
    }
  }
  return true;
}

/// The receiver and the triangles of a source, not in one plane with it.
class HullTwin {
 public:
  HullTwin(std::span<const Point3> vertices, std::span<const Triangle> facet,
           const Point3& receiver)
      : vertices_(vertices) {
    for (const Triangle& t : facet) {
      const auto [a, b, c] = Corners(t);
      parts_.push_back({ToExact(receiver), a, b, c});
      has_volume_ =
          has_volume_ &&
          SignOf(Determinant(a - parts_.back()[0], b - parts_.back()[0],
                             c - parts_.back()[0])) != Sign::kZero;
    }
  }

  [[nodiscard]] bool has_volume() const { return has_volume_; }

  /// Whether a triangle meets the hull of r and one of the source's triangles.
  [[nodiscard]] bool Meets(const Triangle& triangle) const {
    const std::array<ExactPoint, 3> corners = Corners(triangle);
    return std::ranges::any_of(parts_, [&](const auto& part) {
      return testing::Meets(corners, part);
    });
  }

 private:
  [[nodiscard]] std::array<ExactPoint, 3> Corners(const Triangle& t) const {
    const auto corner = [&](std::size_t k) {
      return ToExact(vertices_[static_cast<std::size_t>(t.vertices[k])]);
    };
    return {corner(0), corner(1), corner(2)};
  }

  std::span<const Point3> vertices_;
  std::vector<std::array<ExactPoint, 4>> parts_;
  bool has_volume_ = true;
};

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_SCENE_INDEX_HULL_TWIN_H_
