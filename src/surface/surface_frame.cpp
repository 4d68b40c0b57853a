// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/surface_frame.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>

#include "exact/number.h"
#include "exact/sign.h"
#include "explain/edge_text.h"
#include "scene/newell.h"

namespace truelux {
namespace {

std::span<const Triangle> TrianglesOf(const Scene& scene, int face) {
  const Face& f = scene.faces()[static_cast<std::size_t>(face)];
  if (f.facet_count == 0) return {};
  const auto facets =
      scene.facets().subspan(static_cast<std::size_t>(f.first_facet),
                             static_cast<std::size_t>(f.facet_count));
  const int end = facets.back().first_triangle + facets.back().triangle_count;
  const int first = facets.front().first_triangle;
  return scene.triangles().subspan(static_cast<std::size_t>(first),
                                   static_cast<std::size_t>(end - first));
}

/// The corners of a triangle.
std::array<Point3, 3> CornersOf(const Scene& scene, const Triangle& triangle) {
  std::array<Point3, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    corners[k] =
        scene.vertices()[static_cast<std::size_t>(triangle.vertices[k])];
  }
  return corners;
}

Vec3<Exact> NormalOf(const std::array<Point3, 3>& corners) {
  return Cross(Displacement<Exact>(corners[0], corners[1]),
               Displacement<Exact>(corners[0], corners[2]));
}

/// Whether a plane through `at` with a normal holds all corners of a face.
bool HoldsFace(const Scene& scene, const Vec3<Exact>& normal, const Point3& at,
               int face) {
  return std::ranges::all_of(
      TrianglesOf(scene, face), [&](const Triangle& triangle) {
        return std::ranges::all_of(
            CornersOf(scene, triangle), [&](const Point3& corner) {
              return SignOf(HeightOver(normal, at, corner)) == Sign::kZero;
            });
      });
}

/// Of two axes of space, those along which the plane is not seen edge-on.
struct PlaneAxes {
  int first;
  int second;
};

/// Requires that u and v are not parallel.
PlaneAxes AxesFor(const RationalVector& u, const RationalVector& v) {
  const RationalVector normal = Cross(u, v);
  if (normal.z != 0) return {0, 1};
  if (normal.x != 0) return {1, 2};
  return {2, 0};
}

/// Sets the extent to that of the faces' corners.
void FindExtent(const Scene& scene, SurfaceFrame& frame) {
  bool is_first = true;
  for (const int face : frame.faces) {
    const Face& f = scene.faces()[static_cast<std::size_t>(face)];
    for (const int vertex :
         scene.corners().subspan(static_cast<std::size_t>(f.first_corner),
                                 static_cast<std::size_t>(f.corner_count))) {
      const auto [a, b] =
          frame.Of(scene.vertices()[static_cast<std::size_t>(vertex)]);
      if (is_first || a < frame.a_least) frame.a_least = a;
      if (is_first || a > frame.a_most) frame.a_most = a;
      if (is_first || b < frame.b_least) frame.b_least = b;
      if (is_first || b > frame.b_most) frame.b_most = b;
      is_first = false;
    }
  }
}

}  // namespace

SurfaceFrame::Coordinates SurfaceFrame::Of(const RationalVector& p) const {
  const RationalVector w = p - origin;
  const auto [i, k] = AxesFor(u, v);
  const auto determinant = [i = i, k = k](const RationalVector& s,
                                          const RationalVector& t) {
    return mpq_class(Component(s, i) * Component(t, k) -
                     Component(s, k) * Component(t, i));
  };
  const mpq_class whole = determinant(u, v);
  return {mpq_class(determinant(w, v) / whole),
          mpq_class(determinant(u, w) / whole)};
}

double SurfaceFrame::HeightByWidth() const {
  const auto square = [](const RationalVector& s, const mpq_class& range) {
    return mpq_class(Dot(s, s) * range * range);
  };
  return std::sqrt(NearestTo(
      mpq_class(square(v, b_most - b_least) / square(u, a_most - a_least))));
}

std::optional<SurfaceFrame> SurfaceFrameOf(const Scene& scene,
                                           std::span<const int> faces,
                                           std::string& defect) {
  SurfaceFrame frame;
  for (const int face : faces) {
    if (!TrianglesOf(scene, face).empty()) frame.faces.push_back(face);
  }
  if (frame.faces.empty()) {
    defect = "none of its faces has an area";
    return std::nullopt;
  }
  const int first = frame.faces.front();
  const std::array<Point3, 3> corners =
      CornersOf(scene, TrianglesOf(scene, first).front());
  const Vec3<Exact> normal = NormalOf(corners);
  for (const int face : frame.faces) {
    if (HoldsFace(scene, normal, corners[0], face)) {
      const Vec3<Exact> other =
          NormalOf(CornersOf(scene, TrianglesOf(scene, face).front()));
      if (SignOf(Dot(normal, other)) == Sign::kNegative)
        frame.reversed.push_back(face);
      continue;
    }
    defect = face == first ? fmt::format("{} is not exactly planar",
                                         TextOfFace(scene, face + 1))
                           : fmt::format("{} is not exactly in the plane of {}",
                                         TextOfFace(scene, face + 1),
                                         TextOfFace(scene, first + 1));
    return std::nullopt;
  }
  const Face& f = scene.faces()[static_cast<std::size_t>(first)];
  const auto corner = [&](int k) {
    const int vertex =
        scene.corners()[static_cast<std::size_t>(f.first_corner) +
                        static_cast<std::size_t>(k)];
    return RationalOf(scene.vertices()[static_cast<std::size_t>(vertex)]);
  };
  frame.origin = corner(0);
  frame.u = corner(1) - frame.origin;
  frame.v = corner(f.corner_count - 1) - frame.origin;
  const RationalVector across = Cross(frame.u, frame.v);
  if (across.x == 0 && across.y == 0 && across.z == 0) {
    defect = fmt::format(
        "the first corner of {} lies on the line between its neighbours, so "
        "that it gives no two axes; let the face start at another corner",
        TextOfFace(scene, first + 1));
    return std::nullopt;
  }
  FindExtent(scene, frame);
  return frame;
}

}  // namespace truelux
