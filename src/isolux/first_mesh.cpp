// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/first_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

// Without it CGAL warns in builds with assertions that exact numbers are slow.
#define CGAL_NO_CDT_2_WARNING
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Filtered_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "isolux/cut_mesh.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

// Lazy numbers would be faster; a thread that uses them for the first time ends
// the process where there is no memory for that.
using Kernel = CGAL::Filtered_kernel<CGAL::Simple_cartesian<CGAL::Gmpq>>;
using Vertices = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Faces = CGAL::Triangulation_face_base_with_info_2<
    int, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<Vertices, Faces>;
using Plane =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                               CGAL::Exact_intersections_tag>;
using Point = Kernel::Point_2;

Kernel::FT ExactOf(const mpq_class& q) {
  return Kernel::FT(q.get_mpq_t());
}

/// A constraint, and what it is of.
struct Segment {
  Point from;
  Point to;
  SideKind kind = SideKind::kOutline;
  int line = -1;
  std::array<double, 2> near_from{CGAL::to_double(from.x()),
                                  CGAL::to_double(from.y())};
  std::array<double, 2> near_to{CGAL::to_double(to.x()),
                                CGAL::to_double(to.y())};

  /// Whether double proves that a point is away from the segment: what is
  /// rounded is far below 2^-30 of the lengths.
  [[nodiscard]] bool IsClearlyAway(const Point& p) const {
    const double ax = CGAL::to_double(p.x()) - near_from[0];
    const double ay = CGAL::to_double(p.y()) - near_from[1];
    const double bx = near_to[0] - near_from[0];
    const double by = near_to[1] - near_from[1];
    const double size = std::hypot(near_from[0], near_from[1]) +
                        std::hypot(near_to[0], near_to[1]) + std::hypot(ax, ay);
    const double aside = 0x1p-30 * size * (std::hypot(bx, by) + size);
    return std::fabs(ax * by - ay * bx) > aside || ax * bx + ay * by < -aside ||
           ax * bx + ay * by > bx * bx + by * by + aside;
  }

  [[nodiscard]] bool Holds(const Point& p) const {
    return !IsClearlyAway(p) && CGAL::collinear(from, p, to) &&
           CGAL::collinear_are_ordered_along_line(from, p, to);
  }
};

class MeshMaker {
 public:
  MeshMaker(const Scene& scene, const PlanFrame& plan)
      : scene_(scene), plan_(plan) {}

  void AddFaces(std::span<const int> faces) {
    for (const int face : faces) {
      const Face& f = scene_.faces()[static_cast<std::size_t>(face)];
      for (const Facet& facet :
           scene_.facets().subspan(static_cast<std::size_t>(f.first_facet),
                                   static_cast<std::size_t>(f.facet_count))) {
        if (facet.is_back) continue;
        for (const Triangle& triangle : TrianglesOf(scene_, facet)) {
          AddTriangle(triangle);
        }
      }
    }
    for (const auto& [a, b] : OutlineOf(scene_, faces)) {
      segments_.push_back({PointOf(a), PointOf(b), SideKind::kOutline, -1});
    }
  }

  void AddLines(std::span<const ExactSurfaceLine> lines) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const auto line = static_cast<int>(i);
      const Point from = PointOf(lines[i].from);
      const Point to = PointOf(lines[i].to);
      if (!lines[i].is_jump) {
        segments_.push_back({from, to, SideKind::kKink, line});
        continue;
      }
      // A jump that ends within the surface on both sides needs a point in
      // between that has two sides: its ends are moved along it.
      const Point middle = CGAL::midpoint(from, to);
      segments_.push_back({from, middle, SideKind::kJump, line});
      segments_.push_back({middle, to, SideKind::kJump, line});
    }
  }

  FirstMesh Make() {
    for (const Segment& segment : segments_)
      plane_.insert_constraint(segment.from, segment.to);
    NamePoints();
    NameFaces();
    FindSides();
    FirstMesh result;
    SetScale(result.scale);
    mesh_ = CutApart(points_, std::move(mesh_.triangles));
    MoveInwards(result.scale.margin, mesh_);
    result.left_out = DropFlat();
    result.mesh = PlanMesh(std::move(mesh_.points), std::move(mesh_.triangles));
    result.seams = std::move(seams_);
    return result;
  }

 private:
  Point PointOf(const RationalVector& p) {
    const ExactPlanPoint place = plan_.ExactPlaceOf(p);
    return {ExactOf(place.s), ExactOf(place.t)};
  }

  Point PointOf(int vertex) {
    return PointOf(truelux::RationalOf(
        scene_.vertices()[static_cast<std::size_t>(vertex)]));
  }

  void AddTriangle(const Triangle& triangle) {
    std::array<Point, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = PointOf(triangle.vertices[k]);
    if (CGAL::orientation(corners[0], corners[1], corners[2]) ==
        CGAL::RIGHT_TURN) {
      std::swap(corners[1], corners[2]);
    }
    covers_.push_back(corners);
  }

  /// Whether a face of the triangulation is on the surface. No outline goes
  /// through it.
  [[nodiscard]] bool IsCovered(Plane::Face_handle face) const {
    const Point middle =
        CGAL::centroid(face->vertex(0)->point(), face->vertex(1)->point(),
                       face->vertex(2)->point());
    return std::ranges::any_of(covers_, [&](const auto& corners) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (CGAL::orientation(corners[k], corners[(k + 1) % 3], middle) ==
            CGAL::RIGHT_TURN) {
          return false;
        }
      }
      return true;
    });
  }

  void NamePoints() {
    for (const Plane::Vertex_handle vertex : plane_.finite_vertex_handles()) {
      vertex->info() = static_cast<int>(points_.size());
      points_.push_back({CGAL::to_double(vertex->point().x()),
                         CGAL::to_double(vertex->point().y())});
    }
  }

  void NameFaces() {
    for (const Plane::Face_handle face : plane_.finite_face_handles()) {
      face->info() = -1;
      if (!IsCovered(face)) continue;
      face->info() = static_cast<int>(handles_.size());
      handles_.push_back(face);
    }
    for (Plane::All_faces_iterator face = plane_.all_faces_begin();
         face != plane_.all_faces_end(); ++face) {
      if (plane_.is_infinite(face)) face->info() = -1;
    }
  }

  void FindSides() {
    mesh_.triangles.resize(handles_.size());
    for (std::size_t i = 0; i < handles_.size(); ++i) {
      const Plane::Face_handle face = handles_[i];
      PlanTriangle& triangle = mesh_.triangles[i];
      for (int k = 0; k < 3; ++k) {
        const auto side = static_cast<std::size_t>(k);
        triangle.corners[side] = face->vertex(k)->info();
        triangle.neighbors[side] = face->neighbor(k)->info();
        Seam seam;
        if (face->is_constrained(k)) seam = SeamAt(face, k);
        if (triangle.neighbors[side] < 0 && seam.kind != SideKind::kJump)
          seam = {{}, {}, SideKind::kOutline, -1};
        if (seam.kind == SideKind::kJump) triangle.neighbors[side] = -1;
        triangle.kinds[side] = seam.kind;
        if (seam.kind != SideKind::kInner)
          triangle.seams[side] = NameOf(seam, face, k);
      }
    }
  }

  /// What a side is, without its ends.
  [[nodiscard]] Seam SeamAt(Plane::Face_handle face, int k) const {
    Seam found;
    const Point middle = CGAL::midpoint(face->vertex(Plane::ccw(k))->point(),
                                        face->vertex(Plane::cw(k))->point());
    for (const Segment& segment : segments_) {
      // Between the surface's faces there is nothing to see.
      if (segment.kind == SideKind::kOutline) continue;
      if (!segment.Holds(middle)) continue;
      found.kind = segment.kind;
      found.line = segment.line;
      if (segment.kind == SideKind::kJump) break;
    }
    return found;
  }

  /// Its index among the seams.
  int NameOf(Seam seam, Plane::Face_handle face, int k) {
    const std::pair<int, int> ends =
        std::minmax(face->vertex(Plane::ccw(k))->info(),
                    face->vertex(Plane::cw(k))->info());
    const auto [entry, is_new] =
        seam_names_.emplace(ends, static_cast<int>(seams_.size()));
    if (is_new) {
      seam.from = points_[static_cast<std::size_t>(ends.first)];
      seam.to = points_[static_cast<std::size_t>(ends.second)];
      seams_.push_back(seam);
    }
    return entry->second;
  }

  void SetScale(PlanScale& scale) const {
    PlanPoint least{HUGE_VAL, HUGE_VAL};
    PlanPoint most{-HUGE_VAL, -HUGE_VAL};
    for (const PlanPoint& p : points_) {
      least = {std::min(least.s, p.s), std::min(least.t, p.t)};
      most = {std::max(most.s, p.s), std::max(most.t, p.t)};
    }
    if (points_.empty()) return;
    scale.size = std::max(most.s - least.s, most.t - least.t);
    constexpr double kOfSize = 0x1p-36;
    constexpr double kOfCoordinates = 0x1p-48;
    double largest = 0;
    for (const PlanPoint& p : points_) {
      const Point3 at = plan_.PointAt(p);
      for (const double x : {at.x, at.y, at.z})
        largest = std::max(largest, std::fabs(x));
    }
    scale.margin = std::max(kOfSize * scale.size, kOfCoordinates * largest);
  }

  /// Drops triangles that rounding or the margin has turned over.
  int DropFlat() {
    std::vector<int> names(mesh_.triangles.size(), -1);
    std::vector<PlanTriangle> kept;
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      const auto& c = mesh_.triangles[i].corners;
      const auto at = [&](std::size_t k) {
        return mesh_.points[static_cast<std::size_t>(c[k])];
      };
      if (Cross(at(1) - at(0), at(2) - at(0)) <= 0) continue;
      names[i] = static_cast<int>(kept.size());
      kept.push_back(mesh_.triangles[i]);
    }
    for (PlanTriangle& triangle : kept) {
      for (std::size_t k = 0; k < 3; ++k) {
        int& neighbor = triangle.neighbors[k];
        if (neighbor < 0) continue;
        neighbor = names[static_cast<std::size_t>(neighbor)];
        if (neighbor < 0) triangle.kinds[k] = SideKind::kOutline;
      }
    }
    const auto dropped = static_cast<int>(mesh_.triangles.size() - kept.size());
    mesh_.triangles = std::move(kept);
    return dropped;
  }

  const Scene& scene_;
  const PlanFrame& plan_;
  Plane plane_;
  std::vector<Segment> segments_;
  std::vector<std::array<Point, 3>> covers_;  ///< of the surface
  std::vector<Plane::Face_handle> handles_;
  std::vector<PlanPoint> points_;  ///< of the triangulation's vertices
  CutMesh mesh_;
  std::vector<Seam> seams_;
  std::map<std::pair<int, int>, int> seam_names_;  ///< by points
};

}  // namespace

FirstMesh FirstMeshOf(const Scene& scene, const PlanFrame& plan,
                      std::span<const int> faces,
                      std::span<const ExactSurfaceLine> lines) {
  MeshMaker maker(scene, plan);
  maker.AddFaces(faces);
  maker.AddLines(lines);
  return maker.Make();
}

}  // namespace truelux
