// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/covered_emitters.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "exact/number.h"
#include "scene/coplanar_overlap.h"
#include "scene/emitters.h"
#include "scene/index/box_overlap.h"
#include "scene/index/triangle_tree.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

using Corners = std::array<Point3, 3>;

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
      if (!OverlapInPlane(all.corners[i], all.corners[k])) return;
      if (!found.empty() && found.back().face == face) return;
      found.push_back({face, all.faces[k]});
      region = BoxOverlap(Box());  // nothing more to be found
    });
  }
  return covered;
}

}  // namespace truelux
