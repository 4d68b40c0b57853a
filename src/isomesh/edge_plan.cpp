// SPDX-License-Identifier: GPL-3.0-or-later
#include "isomesh/edge_plan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyline_simplification_2/Squared_distance_cost.h>
#include <CGAL/Polyline_simplification_2/Stop_above_cost_threshold.h>
#include <CGAL/Polyline_simplification_2/Vertex_base_2.h>
#include <CGAL/Polyline_simplification_2/simplify.h>
#include <CGAL/Triangulation_data_structure_2.h>

namespace truelux {
namespace {

namespace Simplification = CGAL::Polyline_simplification_2;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertices = Simplification::Vertex_base_2<Kernel>;
using Faces = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<Vertices, Faces>;
using Plane = CGAL::Constrained_triangulation_plus_2<
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                               CGAL::Exact_predicates_tag>>;
using Point = Kernel::Point_2;

Point PointOf(const PlanPoint& p) {
  return {p.s, p.t};
}

PlanPoint PlanPointOf(const Point& p) {
  return {p.x(), p.y()};
}

/// Points that are alike or near, by their squares of a grid.
class NearPoints {
 public:
  explicit NearPoints(double distance) : distance_(distance) {}

  void Add(const PlanPoint& p) { squares_[SquareOf(p)].push_back(p); }

  /// The nearest one within the distance.
  [[nodiscard]] const PlanPoint* NearestTo(const PlanPoint& p) const {
    const PlanPoint* nearest = nullptr;
    double least = distance_;
    const auto [s, t] = SquareOf(p);
    for (const double ds : {-1.0, 0.0, 1.0}) {
      for (const double dt : {-1.0, 0.0, 1.0}) {
        const auto square = squares_.find({s + ds, t + dt});
        if (square == squares_.end()) continue;
        for (const PlanPoint& other : square->second) {
          const double length = LengthOf(other - p);
          if (length > least) continue;
          least = length;
          nearest = &other;
        }
      }
    }
    return nearest;
  }

 private:
  [[nodiscard]] std::pair<double, double> SquareOf(const PlanPoint& p) const {
    return {std::floor(p.s / distance_), std::floor(p.t / distance_)};
  }

  double distance_;
  std::map<std::pair<double, double>, std::vector<PlanPoint>> squares_;
};

/// A contour's point on a seam, by its place along it.
struct SeamPoint {
  double along = 0;  ///< 0 .. 1
  PlanPoint at;
};

/// The square of the distance by which a polyline changes without a vertex. No
/// two vertices cost the same, so that the order does not depend on the places
/// of constraints in memory.
struct OrderedCost {
  template <class Triangulation>
  boost::optional<double> operator()(
      const Triangulation& plane,
      typename Triangulation::Vertices_in_constraint_iterator vertex) const {
    const auto square = Simplification::Squared_distance_cost()(plane, vertex);
    if (!square) return square;
    const auto name = static_cast<double>((*vertex)->ID);
    return *square * (1 + 0x1p-40 * name) + name * 0x1p-1000;
  }
};

/// What an edge of the triangulation is of.
struct Origin {
  int seam = -1;
  int level = -1;
};

class EdgePlanner {
 public:
  EdgePlanner(std::span<const Seam> seams, const EdgeTolerances& tolerances)
      : seams_(seams),
        tolerances_(tolerances),
        corners_(tolerances.corner),
        on_seams_(seams.size()) {
    for (const Seam& seam : seams) {
      corners_.Add(seam.from);
      corners_.Add(seam.to);
    }
  }

  EdgePlan Plan(std::span<const ContourLine> contours) {
    std::vector<std::vector<Point>> paths;
    for (const ContourLine& contour : contours)
      paths.push_back(PathOf(contour));
    for (std::size_t i = 0; i < seams_.size(); ++i)
      InsertSeam(i);
    for (auto vertex : plane_.finite_vertex_handles())
      vertex->set_removable(false);
    for (std::size_t i = 0; i < contours.size(); ++i) {
      if (paths[i].size() < 2) continue;
      const auto id =
          plane_.insert_constraint(paths[i].begin(), paths[i].end());
      origins_[id].level = static_cast<int>(contours[i].level);
    }
    CountCrossings();
    Simplification::simplify(plane_, OrderedCost(),
                             Simplification::Stop_above_cost_threshold(
                                 tolerances_.chord * tolerances_.chord));
    TakeEdges();
    return std::move(plan_);
  }

 private:
  /// A contour with its points on seams and in corners.
  std::vector<Point> PathOf(const ContourLine& contour) {
    std::vector<Point> path;
    for (const ContourPoint& point : contour.points) {
      const Point at = PointOf(PlaceOf(point));
      if (path.empty() || path.back() != at) path.push_back(at);
    }
    if (contour.is_closed && path.size() > 1 && path.back() != path.front())
      path.push_back(path.front());
    for (const Point& point : path)
      known_.insert({point.x(), point.y()});
    return path;
  }

  /// Where a vertex of a contour is put.
  PlanPoint PlaceOf(const ContourPoint& point) {
    if (const PlanPoint* corner = corners_.NearestTo(point.at)) {
      ++plan_.drawn;
      plan_.most_drawn =
          std::max(plan_.most_drawn, LengthOf(*corner - point.at));
      return *corner;
    }
    if (point.seam < 0) return point.at;
    const Seam& seam = seams_[static_cast<std::size_t>(point.seam)];
    const PlanPoint way = seam.to - seam.from;
    SeamPoint on;
    on.along = Dot(point.at - seam.from, way) / Dot(way, way);
    // Points beside jumps and outlines are the margin away from them.
    on.at =
        seam.kind == SideKind::kKink ? point.at : seam.from + on.along * way;
    on_seams_[static_cast<std::size_t>(point.seam)].push_back(on);
    return on.at;
  }

  void InsertSeam(std::size_t i) {
    auto& points = on_seams_[i];
    std::ranges::sort(points, {}, &SeamPoint::along);
    std::vector<Point> path = {PointOf(seams_[i].from)};
    for (const SeamPoint& on : points) {
      if (const Point at = PointOf(on.at); path.back() != at)
        path.push_back(at);
    }
    path.push_back(PointOf(seams_[i].to));
    for (const Point& point : path)
      known_.insert({point.x(), point.y()});
    const auto id = plane_.insert_constraint(path.begin(), path.end());
    origins_[id].seam = static_cast<int>(i);
  }

  void CountCrossings() {
    plan_.crossings =
        static_cast<int>(plane_.number_of_vertices() - known_.size());
  }

  void TakeEdges() {
    std::map<Plane::Vertex_handle, int> names;
    for (auto vertex : plane_.finite_vertex_handles()) {
      names[vertex] = static_cast<int>(plan_.points.size());
      plan_.points.push_back(PlanPointOf(vertex->point()));
    }
    std::map<std::pair<int, int>, PlanEdge> edges;
    for (const auto id : plane_.constraints()) {
      const Origin& origin = origins_.at(id);
      auto at = plane_.vertices_in_constraint_begin(id);
      const auto end = plane_.vertices_in_constraint_end(id);
      for (auto next = std::next(at); next != end; at = next++) {
        const std::pair<int, int> ends =
            std::minmax(names.at(*at), names.at(*next));
        PlanEdge& edge = edges[ends];
        edge.from = ends.first;
        edge.to = ends.second;
        if (origin.level >= 0) {
          edge.level = origin.level;
          continue;
        }
        edge.seam = origin.seam;
        edge.kind = seams_[static_cast<std::size_t>(origin.seam)].kind;
      }
    }
    for (const auto& [ends, edge] : edges)
      plan_.edges.push_back(edge);
  }

  std::span<const Seam> seams_;
  EdgeTolerances tolerances_;
  NearPoints corners_;
  std::vector<std::vector<SeamPoint>> on_seams_;
  std::set<std::pair<double, double>> known_;  ///< points put in
  Plane plane_;
  std::map<Plane::Constraint_id, Origin> origins_;
  EdgePlan plan_;
};

}  // namespace

EdgePlan EdgePlanOf(std::span<const Seam> seams,
                    std::span<const ContourLine> contours,
                    const EdgeTolerances& tolerances) {
  return EdgePlanner(seams, tolerances).Plan(contours);
}

}  // namespace truelux
