// SPDX-License-Identifier: GPL-3.0-or-later
#include "isomesh/refined_plane.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#define CGAL_NO_CDT_2_WARNING
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "base/stop.h"

namespace truelux {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
/// Of points that the mesher has just put in.
constexpr int kUnnamed = -1;

struct PointName {
  int value = kUnnamed;
};

using Vertices = CGAL::Triangulation_vertex_base_with_info_2<PointName, Kernel>;
using Faces = CGAL::Delaunay_mesh_face_base_2<
    Kernel,
    CGAL::Constrained_Delaunay_triangulation_face_base_2<
        Kernel,
        CGAL::Constrained_triangulation_face_base_2<
            Kernel, CGAL::Triangulation_face_base_with_info_2<int, Kernel>>>>;
using Structure = CGAL::Triangulation_data_structure_2<Vertices, Faces>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, Structure,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;
using Point = Kernel::Point_2;
using VertexHandle = Delaunay::Vertex_handle;
using FaceHandle = Delaunay::Face_handle;

PlanPoint PlanPointOf(const Point& p) {
  return {p.x(), p.y()};
}

Corners CornersOf(FaceHandle face) {
  return OrderedCorners({face->vertex(0)->info().value,
                         face->vertex(1)->info().value,
                         face->vertex(2)->info().value});
}

/// Bad are those that are listed.
class ListedCriteria {
 public:
  /// The triangle with the largest number goes first.
  struct Quality {
    double size = 0;

    bool operator<(const Quality& other) const { return size > other.size; }
  };

  class Is_bad {
   public:
    explicit Is_bad(const std::map<Corners, double>* listed)
        : listed_(listed) {}

    CGAL::Mesh_2::Face_badness operator()(const Quality& quality) const {
      return quality.size > 0 ? CGAL::Mesh_2::IMPERATIVELY_BAD
                              : CGAL::Mesh_2::NOT_BAD;
    }

    CGAL::Mesh_2::Face_badness operator()(const FaceHandle& face,
                                          Quality& quality) const {
      const auto entry = listed_->find(CornersOf(face));
      quality.size = entry == listed_->end() ? 0 : entry->second;
      return (*this)(quality);
    }

   private:
    const std::map<Corners, double>* listed_;
  };

  explicit ListedCriteria(const std::map<Corners, double>* listed)
      : listed_(listed) {}

  [[nodiscard]] Is_bad is_bad_object() const { return Is_bad(listed_); }

 private:
  const std::map<Corners, double>* listed_;
};

double AreaOf(FaceHandle face) {
  return std::fabs(CGAL::area(face->vertex(0)->point(),
                              face->vertex(1)->point(),
                              face->vertex(2)->point()));
}

}  // namespace

Corners OrderedCorners(const Corners& corners) {
  Corners ordered = corners;
  std::ranges::rotate(ordered, std::ranges::min_element(ordered));
  return ordered;
}

class RefinedPlane::Plane {
 public:
  explicit Plane(const EdgePlan& plan) : plan_(plan) {
    std::vector<VertexHandle> vertices;
    FaceHandle near;
    for (std::size_t i = 0; i < plan.points.size(); ++i) {
      const VertexHandle vertex =
          delaunay_.insert({plan.points[i].s, plan.points[i].t}, near);
      near = vertex->face();
      vertex->info().value = static_cast<int>(i);
      vertices.push_back(vertex);
    }
    for (std::size_t i = 0; i < plan.edges.size(); ++i) {
      const PlanEdge& edge = plan.edges[i];
      delaunay_.insert_constraint(vertices[static_cast<std::size_t>(edge.from)],
                                  vertices[static_cast<std::size_t>(edge.to)]);
      edges_[std::minmax(edge.from, edge.to)] = static_cast<int>(i);
    }
    point_count_ = plan.points.size();
  }

  /// Marks each part that outlines and jumps enclose by its largest triangle.
  void MarkDomain(const std::function<bool(const PlanPoint&)>& is_inside) {
    NameEdges();
    std::set<FaceHandle> seen;
    for (const FaceHandle first : delaunay_.finite_face_handles()) {
      if (!seen.insert(first).second) continue;
      std::vector<FaceHandle> part = {first};
      for (std::size_t i = 0; i < part.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
          const FaceHandle next = part[i]->neighbor(k);
          if (IsBorder(part[i], k)) continue;
          if (!delaunay_.is_infinite(next) && seen.insert(next).second)
            part.push_back(next);
        }
      }
      const FaceHandle largest = *std::ranges::max_element(part, {}, AreaOf);
      const bool is_in = is_inside(PlanPointOf(CGAL::centroid(
          largest->vertex(0)->point(), largest->vertex(1)->point(),
          largest->vertex(2)->point())));
      for (const FaceHandle face : part)
        face->set_in_domain(is_in);
    }
  }

  void Divide(const std::map<Corners, double>& triangles,
              std::size_t most_points, const StopFlag* stop) {
    Refine(ListedCriteria(&triangles), most_points, stop);
  }

  void DivideTo(double longest, const StopFlag* stop) {
    constexpr double kShape = 0.125;  // no angle below 20.7 degrees
    Refine(CGAL::Delaunay_mesh_size_criteria_2<Delaunay>(kShape, longest),
           std::numeric_limits<std::size_t>::max(), stop);
  }

  [[nodiscard]] std::size_t point_count() const {
    return delaunay_.number_of_vertices();
  }

  SharedMesh Mesh() {
    SharedMesh mesh;
    NameEdges();
    mesh.points.resize(delaunay_.number_of_vertices());
    for (const VertexHandle vertex : delaunay_.finite_vertex_handles())
      mesh.points[static_cast<std::size_t>(vertex->info().value)] =
          PlanPointOf(vertex->point());
    int count = 0;
    for (const FaceHandle face : delaunay_.all_face_handles())
      face->info() = face->is_in_domain() ? count++ : -1;
    for (const FaceHandle face : delaunay_.finite_face_handles()) {
      if (face->is_in_domain()) mesh.triangles.push_back(TriangleOf(face));
    }
    return mesh;
  }

  [[nodiscard]] std::optional<int> TriangleAt(const PlanPoint& p) const {
    const FaceHandle face = delaunay_.locate({p.s, p.t}, last_found_);
    if (face == nullptr || delaunay_.is_infinite(face)) return std::nullopt;
    last_found_ = face;
    if (face->info() < 0) return std::nullopt;
    return face->info();
  }

 private:
  template <class Criteria>
  void Refine(const Criteria& criteria, std::size_t most_points,
              const StopFlag* stop) {
    CGAL::Delaunay_mesher_2<Delaunay, Criteria> mesher(delaunay_, criteria);
    mesher.init(true);
    // What is as thin as a rounding cannot be divided: the mesher would try it
    // for ever.
    std::size_t idle = 0;
    while (!mesher.is_refinement_done() &&
           delaunay_.number_of_vertices() < most_points &&
           idle <= 2 * delaunay_.number_of_faces()) {
      StopIfAsked(stop);
      const std::size_t before = delaunay_.number_of_vertices();
      mesher.try_one_step_refine_mesh();
      idle = delaunay_.number_of_vertices() > before ? 0 : idle + 1;
    }
    // The mesher does not name its points.
    for (const VertexHandle vertex : delaunay_.finite_vertex_handles()) {
      if (vertex->info().value == kUnnamed)
        vertex->info().value = static_cast<int>(point_count_++);
    }
    last_found_ = nullptr;
  }

  /// Which edge of the plan each edge is a part of.
  void NameEdges() {
    parts_.clear();
    std::map<int, std::vector<int>> ways;
    for (const auto& edge : delaunay_.finite_edges()) {
      if (!edge.first->is_constrained(edge.second)) continue;
      const auto [p, q] = EndsOf(edge.first, edge.second);
      ways[p].push_back(q);
      ways[q].push_back(p);
    }
    const auto first_new = static_cast<int>(plan_.points.size());
    for (const auto& [start, ends] : ways) {
      if (start >= first_new) continue;
      for (const int next : ends) {
        // Points that were put in divide an edge in two.
        std::vector<int> way = {start, next};
        while (way.back() >= first_new) {
          const auto& both = ways.at(way.back());
          way.push_back(both[0] == way[way.size() - 2] ? both[1] : both[0]);
        }
        if (way.back() < start) continue;
        const int edge = edges_.at({start, way.back()});
        for (std::size_t i = 1; i < way.size(); ++i)
          parts_[std::minmax(way[i - 1], way[i])] = edge;
      }
    }
  }

  [[nodiscard]] static std::pair<int, int> EndsOf(FaceHandle face, int k) {
    return std::minmax(face->vertex(Delaunay::ccw(k))->info().value,
                       face->vertex(Delaunay::cw(k))->info().value);
  }

  [[nodiscard]] int EdgeAt(FaceHandle face, int k) const {
    if (!face->is_constrained(k)) return -1;
    return parts_.at(EndsOf(face, k));
  }

  [[nodiscard]] bool IsBorder(FaceHandle face, int k) const {
    const int edge = EdgeAt(face, k);
    if (edge < 0) return false;
    const SideKind kind = plan_.edges[static_cast<std::size_t>(edge)].kind;
    return kind == SideKind::kOutline || kind == SideKind::kJump;
  }

  [[nodiscard]] PlanTriangle TriangleOf(FaceHandle face) const {
    PlanTriangle triangle;
    for (int k = 0; k < 3; ++k) {
      const auto side = static_cast<std::size_t>(k);
      triangle.corners[side] = face->vertex(k)->info().value;
      const int edge = EdgeAt(face, k);
      triangle.seams[side] = edge;
      if (edge >= 0) {
        triangle.kinds[side] = plan_.edges[static_cast<std::size_t>(edge)].kind;
      }
      triangle.neighbors[side] =
          IsBorder(face, k) ? -1 : face->neighbor(k)->info();
    }
    return triangle;
  }

  EdgePlan plan_;
  Delaunay delaunay_;
  std::size_t point_count_ = 0;
  std::map<std::pair<int, int>, int> edges_;  ///< of the plan, by their ends
  std::map<std::pair<int, int>, int> parts_;  ///< the same of their parts
  mutable FaceHandle last_found_;
};

RefinedPlane::RefinedPlane(
    const EdgePlan& plan,
    const std::function<bool(const PlanPoint&)>& is_inside)
    : plane_(std::make_unique<Plane>(plan)) {
  plane_->MarkDomain(is_inside);
}

RefinedPlane::~RefinedPlane() = default;

void RefinedPlane::Divide(const std::map<Corners, double>& triangles,
                          std::size_t most_points, const StopFlag* stop) {
  plane_->Divide(triangles, most_points, stop);
}

void RefinedPlane::DivideTo(double longest, const StopFlag* stop) {
  plane_->DivideTo(longest, stop);
}

std::size_t RefinedPlane::point_count() const {
  return plane_->point_count();
}

SharedMesh RefinedPlane::Mesh() const {
  return plane_->Mesh();
}

std::optional<int> RefinedPlane::TriangleAt(const PlanPoint& p) const {
  return plane_->TriangleAt(p);
}

}  // namespace truelux
