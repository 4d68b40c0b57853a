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

#include "isomesh/near_points.h"
#include "isomesh/seam_pieces.h"

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

/// Places are one if they are nearer, by the distance from corners: a 16th of
/// the margin, so that what is moved stays on its side of a jump.
constexpr double kAlike = 0x1p-24;

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
  int piece = -1;
  int level = -1;
};

class EdgePlanner {
 public:
  EdgePlanner(std::span<const Seam> seams, const EdgeTolerances& tolerances)
      : tolerances_(tolerances),
        pieces_(seams, kAlike * tolerances.corner),
        corners_(tolerances.corner) {
    for (const SeamPiece& piece : pieces_.pieces()) {
      corners_.Add(piece.from);
      corners_.Add(piece.to);
    }
  }

  EdgePlan Plan(std::span<const ContourLine> contours) {
    std::vector<std::vector<Point>> paths;
    for (const ContourLine& contour : contours)
      paths.push_back(PathOf(contour));
    for (std::size_t i = 0; i < pieces_.pieces().size(); ++i)
      InsertPiece(i);
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
    bool is_last_inside = false;
    for (const ContourPoint& point : contour.points) {
      const Point at = PointOf(PlaceOf(point));
      const bool is_inside = point.seam < 0;
      if (!path.empty() &&
          pieces_.AreAlike(PlanPointOf(path.back()), PlanPointOf(at))) {
        // What lies on a line stays there.
        if (is_inside || path.back() == at) continue;
        if (is_last_inside) path.pop_back();
      }
      path.push_back(at);
      is_last_inside = is_inside;
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
    return pieces_.Divide(point.seam, point.at);
  }

  void InsertPiece(std::size_t i) {
    std::vector<Point> path;
    for (const PlanPoint& p : pieces_.PathOf(i)) {
      path.push_back(PointOf(p));
      known_.insert({p.s, p.t});
    }
    const auto id = plane_.insert_constraint(path.begin(), path.end());
    origins_[id].piece = static_cast<int>(i);
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
        const SeamPiece& piece =
            pieces_.pieces()[static_cast<std::size_t>(origin.piece)];
        edge.seam = piece.seam;
        edge.kind = piece.kind;
      }
    }
    for (const auto& [ends, edge] : edges)
      plan_.edges.push_back(edge);
  }

  EdgeTolerances tolerances_;
  SeamPieces pieces_;
  NearPoints corners_;
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
