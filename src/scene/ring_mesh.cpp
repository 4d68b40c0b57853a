// SPDX-License-Identifier: GPL-3.0-or-later
// A walk through a Delaunay triangulation by CGAL cuts the ring's edges at the
// points that lie on them. How often each piece is run through, forward less
// backward, is the difference of the winding numbers on its two sides; from the
// outside, which has 0, they are found triangle by triangle, once the pieces are
// sides of triangles.
#include "scene/ring_mesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace truelux {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertices = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Faces = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<Vertices, Faces>;
using Plane = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, Structure,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;

class RingMesh {
 public:
  explicit RingMesh(const ProjectedRing& ring) {
    // Points that coincide have the name of the first of them.
    std::map<std::array<double, 2>, int> names;
    std::vector<std::pair<Kernel::Point_2, int>> points;
    std::vector<int> name_of;
    for (int i = 0; i < ring.size(); ++i) {
      const std::array<double, 2> image = ring.PlanarImage(i);
      const auto [entry, is_new] = names.emplace(image, i);
      if (is_new) points.emplace_back(Kernel::Point_2(image[0], image[1]), i);
      name_of.push_back(entry->second);
    }
    // All at once, in an order that CGAL chooses: in that of the ring a convex
    // one takes the square of the time. None may fall on an edge that is there
    // already.
    plane_.insert(points.begin(), points.end());
    points_.resize(name_of.size());
    for (const Plane::Vertex_handle vertex : plane_.finite_vertex_handles())
      points_[static_cast<std::size_t>(vertex->info())] = vertex;
    for (std::size_t i = 0; i < points_.size(); ++i)
      points_[i] = points_[static_cast<std::size_t>(name_of[i])];
  }

  /// Makes the pieces that bound something edges of the triangulation; bridges,
  /// which are run through as often forward as backward, bound nothing. False
  /// if two cross, or if one is run through more than once.
  bool AddBoundary() {
    for (std::size_t i = 0; i < points_.size(); ++i)
      CountPieces(points_[i], points_[i + 1 < points_.size() ? i + 1 : 0]);
    try {
      for (const auto& [ends, net] : net_) {
        if (net > 1 || net < -1) return false;
        if (net == 0) continue;
        plane_.insert_constraint(
            points_[static_cast<std::size_t>(ends.first)],
            points_[static_cast<std::size_t>(ends.second)]);
      }
    } catch (const Plane::Intersection_of_constraints_exception&) {
      return false;
    }
    return true;
  }

  RingInside FindInside(std::vector<RingTriangle>& triangles) const {
    std::map<Plane::Face_handle, int> windings;
    std::vector<Plane::Face_handle> open;
    const auto set = [&](Plane::Face_handle face, int winding) {
      if (windings.emplace(face, winding).second) open.push_back(face);
    };
    set(plane_.infinite_face(), 0);
    while (!open.empty()) {
      const Plane::Face_handle face = open.back();
      open.pop_back();
      const int winding = windings.at(face);
      if (winding < 0 || winding > 1) return RingInside::kOther;
      for (int k = 0; k < 3; ++k)
        set(face->neighbor(k), winding - NetAlong(face, k));
      if (winding == 1) {
        triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(),
                             face->vertex(2)->info()});
      }
    }
    return triangles.empty() ? RingInside::kNothing : RingInside::kOnce;
  }

 private:
  /// Counts the pieces of an edge.
  void CountPieces(Plane::Vertex_handle from, Plane::Vertex_handle to) {
    while (from != to) {
      const Plane::Vertex_handle next = NextTowards(from, to);
      net_[std::minmax(from->info(), next->info())] +=
          from->info() < next->info() ? 1 : -1;
      from = next;
    }
  }

  /// The first point on the way to another one, which may be that one. Walks
  /// through the triangles that the way crosses.
  [[nodiscard]] Plane::Vertex_handle NextTowards(
      Plane::Vertex_handle from, Plane::Vertex_handle to) const {
    const auto side = [&](Plane::Vertex_handle vertex) {
      return plane_.orientation(from->point(), to->point(), vertex->point());
    };
    const auto is_ahead = [&](Plane::Vertex_handle vertex) {
      return side(vertex) == CGAL::COLLINEAR &&
             plane_.compare_xy(from->point(), vertex->point()) ==
                 plane_.compare_xy(from->point(), to->point());
    };
    auto at = plane_.incident_faces(from);
    for (;; ++at) {
      if (plane_.is_infinite(at)) continue;
      const int own = at->index(from);
      const Plane::Vertex_handle right = at->vertex(Plane::ccw(own));
      const Plane::Vertex_handle left = at->vertex(Plane::cw(own));
      if (is_ahead(right)) return right;
      if (is_ahead(left)) return left;
      if (side(right) == CGAL::RIGHT_TURN && side(left) == CGAL::LEFT_TURN)
        break;  // the way leaves through the side opposite
    }
    Plane::Face_handle face = at;
    int exit = face->index(from);
    for (;;) {
      const Plane::Face_handle next = face->neighbor(exit);
      const int entry = next->index(face);
      const Plane::Vertex_handle tip = next->vertex(entry);
      const CGAL::Orientation turn = side(tip);
      if (turn == CGAL::COLLINEAR) return tip;
      // The way leaves between the tip and the corner on its other side: seen
      // from the next triangle, the left corner comes after its tip.
      exit = turn == CGAL::LEFT_TURN ? Plane::ccw(entry) : Plane::cw(entry);
      face = next;
    }
  }

  /// How often the ring runs along side k of a triangle with the triangle on
  /// its left, less how often with it on its right.
  [[nodiscard]] int NetAlong(Plane::Face_handle face, int k) const {
    if (!face->is_constrained(k)) return 0;
    const int from = face->vertex(Plane::ccw(k))->info();
    const int to = face->vertex(Plane::cw(k))->info();
    const int net = net_.at(std::minmax(from, to));
    return from < to ? net : -net;
  }

  Plane plane_;
  std::vector<Plane::Vertex_handle> points_;  ///< of the ring
  /// By its ends, how often a piece is run through from the lower one, less
  /// how often backward.
  std::map<std::pair<int, int>, int> net_;
};

}  // namespace

RingInside MeshInside(const ProjectedRing& ring,
                      std::vector<RingTriangle>& triangles) {
  // The bounds of CGAL's static filters are those of rounding to nearest.
  const CGAL::Protect_FPU_rounding<true> rounding(CGAL_FE_TONEAREST);
  triangles.clear();
  RingMesh mesh(ring);
  if (!mesh.AddBoundary()) return RingInside::kOther;
  const RingInside inside = mesh.FindInside(triangles);
  if (inside != RingInside::kOnce) triangles.clear();
  return inside;
}

}  // namespace truelux
