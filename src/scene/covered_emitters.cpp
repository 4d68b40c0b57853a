// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/covered_emitters.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "exact/decide.h"
#include "exact/number.h"
#include "exact/vec3.h"
#include "scene/emitters.h"
#include "scene/index/box_overlap.h"
#include "scene/index/triangle_tree.h"
#include "scene/newell.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

using Corners = std::array<Point3, 3>;

template <class NT>
Vec3<NT> NormalOf(const Corners& c) {
  return Cross(Displacement<NT>(c[0], c[1]), Displacement<NT>(c[0], c[2]));
}

/// The side of an edge of a triangle on which a point lies, seen along the
/// triangle's normal: kPositive on the triangle's.
template <class NT>
NT SideOfEdge(const Corners& triangle, std::size_t edge, const Point3& p) {
  const Point3& from = triangle[edge];
  return Dot(Cross(Displacement<NT>(from, triangle[(edge + 1) % 3]),
                   Displacement<NT>(from, p)),
             NormalOf<NT>(triangle));
}

bool IsSame(const Point3& p, const Point3& q) {
  return p.x == q.x && p.y == q.y && p.z == q.z;
}

/// Whether the line of an edge parts a triangle from another one, seen along
/// its normal. Where ask() of a side is unknown, the answer is no.
template <class Ask>
bool IsPartedByEdge(const Corners& triangle, const Corners& other,
                    const Ask& ask) {
  for (std::size_t edge = 0; edge < 3; ++edge) {
    const bool parts = std::ranges::all_of(other, [&](const Point3& p) {
      // Neighbours in a mesh are parted by an edge that holds these points.
      if (IsSame(p, triangle[edge]) || IsSame(p, triangle[(edge + 1) % 3]))
        return true;
      const std::optional<Sign> sign = ask(triangle, edge, p);
      return sign && *sign != Sign::kPositive;
    });
    if (parts) return true;
  }
  return false;
}

template <class Ask>
bool AreParted(const Corners& a, const Corners& b, const Ask& ask) {
  return IsPartedByEdge(a, b, ask) || IsPartedByEdge(b, a, ask);
}

bool AreCoplanarAlike(const Corners& a, const Corners& b) {
  for (const Point3& p : b) {
    const Sign height = Decide(
        [&]<class NT>() { return HeightOver(NormalOf<NT>(a), a[0], p); });
    if (height != Sign::kZero) return false;
  }
  return Decide([&]<class NT>() {
           return Dot(NormalOf<NT>(a), NormalOf<NT>(b));
         }) == Sign::kPositive;
}

/// Whether two triangles lie in one plane, look to the same side and have more
/// than a line in common. Two convex polygons that do not are parted by an edge
/// of one of them.
bool Overlap(const Corners& a, const Corners& b) {
  const auto by_interval = [](const Corners& t, std::size_t edge,
                              const Point3& p) {
    return TrySign(SideOfEdge<Interval>(t, edge, p));
  };
  // First what is cheap and tells nearly always: not in one plane for certain,
  // or parted along some normal.
  for (const Point3& p : b) {
    const auto height = TrySign(HeightOver(NormalOf<Interval>(a), a[0], p));
    if (height && *height != Sign::kZero) return false;
  }
  if (AreParted(a, b, by_interval) || !AreCoplanarAlike(a, b)) return false;
  return !AreParted(
      a, b, [](const Corners& t, std::size_t edge, const Point3& p) {
        return std::optional<Sign>(
            Decide([&]<class NT>() { return SideOfEdge<NT>(t, edge, p); }));
      });
}

/// The triangles that emit, face by face; backs are left out, since they cover
/// each other as the fronts do.
struct EmittingTriangles {
  std::vector<Corners> corners;
  std::vector<int> faces;
  std::vector<Box> boxes;
};

EmittingTriangles EmittingTrianglesOf(const Scene& scene) {
  EmittingTriangles all;
  for (const int face : EmittersOf(scene)) {
    for (const FacetId id : FacetsOf(FacesOf(scene)[FaceId(face)])) {
      const Facet& facet = FacetsOf(scene)[id];
      if (facet.is_back) continue;
      for (const Triangle& triangle : TrianglesOf(scene, facet)) {
        Corners& corners = all.corners.emplace_back();
        Box& box = all.boxes.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
          corners[k] = VerticesOf(scene)[VertexId(triangle.vertices[k])];
          box.Include(corners[k]);
        }
        all.faces.push_back(face);
      }
    }
  }
  return all;
}

}  // namespace

CoveredEmitters CoveredEmittersOf(const Scene& scene) {
  const EmittingTriangles all = EmittingTrianglesOf(scene);
  CoveredEmitters covered;
  if (all.faces.empty() || all.faces.front() == all.faces.back())
    return covered;
  const TriangleTree tree(all.boxes);
  const RoundUpward rounding;
  std::int64_t tests = 0;
  for (std::size_t i = 0; i < all.faces.size(); ++i) {
    const int face = all.faces[i];
    std::vector<CoveredEmitter>& found = covered.found;
    if (!found.empty() && found.back().face == face) continue;
    if (tests > kMostCoverTests) {
      covered.is_all = false;
      break;
    }
    BoxOverlap region(all.boxes[i]);
    tree.Visit(region, [&](int index) {
      const auto k = static_cast<std::size_t>(index);
      if (all.faces[k] >= face) return;
      ++tests;
      if (!Overlap(all.corners[i], all.corners[k])) return;
      if (!found.empty() && found.back().face == face) return;
      found.push_back({face, all.faces[k]});
      region = BoxOverlap(Box());  // nothing more to be found
    });
  }
  return covered;
}

}  // namespace truelux
