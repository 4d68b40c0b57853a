// SPDX-License-Identifier: GPL-3.0-or-later
// A constrained triangulation of the plane by CGAL. Its predicates are computed
// with exact numbers: rings that meet themselves are few, and no filter has to
// know the rounding mode.
#include "scene/boundary_triangulation.h"

#include <map>

#include <CGAL/Constrained_triangulation_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "exact/number.h"

namespace truelux {
namespace {

using Kernel = CGAL::Simple_cartesian<Exact>;
using Vertices = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Faces = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<Vertices, Faces>;
using Plane =
    CGAL::Constrained_triangulation_2<Kernel, Structure,
                                      CGAL::No_constraint_intersection_tag>;

/// The triangulation of a boundary's points that has its steps as edges.
class BoundaryPlane {
 public:
  BoundaryPlane(const ProjectedRing& ring,
                const std::vector<BoundaryStep>& boundary)
      : ring_(ring) {
    for (const auto& [from, to] : boundary)
      plane_.insert_constraint(HandleOf(from), HandleOf(to));
  }

  /// The triangles of the inside: outside is outside, and every step has the
  /// inside on one side of it only.
  void AppendInside(std::vector<RingTriangle>& triangles) const {
    std::map<Plane::Face_handle, bool> inside;
    std::vector<Plane::Face_handle> open;
    const auto mark = [&](Plane::Face_handle face, bool is_inside) {
      if (inside.emplace(face, is_inside).second) open.push_back(face);
    };
    mark(plane_.infinite_face(), false);
    while (!open.empty()) {
      const Plane::Face_handle face = open.back();
      open.pop_back();
      const bool is_inside = inside.at(face);
      for (int k = 0; k < 3; ++k) {
        const bool is_step = face->is_constrained(k);
        mark(face->neighbor(k), is_step ? !is_inside : is_inside);
      }
      if (is_inside) triangles.push_back(CornersOf(face));
    }
  }

 private:
  Plane::Vertex_handle HandleOf(int point) {
    const auto found = handles_.find(point);
    if (found != handles_.end()) return found->second;
    const auto [u, v] = ring_.PlanarImage(point);
    const Plane::Vertex_handle handle =
        plane_.insert(Kernel::Point_2(Exact(u), Exact(v)));
    handle->info() = point;
    handles_.emplace(point, handle);
    return handle;
  }

  static RingTriangle CornersOf(Plane::Face_handle face) {
    return {face->vertex(0)->info(), face->vertex(1)->info(),
            face->vertex(2)->info()};
  }

  const ProjectedRing& ring_;
  Plane plane_;
  std::map<int, Plane::Vertex_handle> handles_;
};

}  // namespace

void TriangulateInside(const ProjectedRing& ring,
                       const std::vector<BoundaryStep>& boundary,
                       std::vector<RingTriangle>& triangles) {
  triangles.clear();
  BoundaryPlane(ring, boundary).AppendInside(triangles);
}

}  // namespace truelux
