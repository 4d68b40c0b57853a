// Planes and directions seen from one receiver, and the signs between them.
//
// Every sign is decided in stages: a double filter, intervals, exact numbers.
// Each stage is a function of its own that says "not known" by an empty
// optional; the public predicate is the cascade, and counts who answered.
// The whole class works under RoundUpward.

#ifndef TRUELUX_EXACT_VIEW_GEOMETRY_H_
#define TRUELUX_EXACT_VIEW_GEOMETRY_H_

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "truelux/statistics.h"

#include "exact/filter.h"
#include "exact/recipe.h"
#include "exact/sign.h"

namespace truelux {

/// The filtered normals of the triangles of a scene; independent of receivers.
/// Entry t belongs to triangle t.
std::vector<FilteredPlane> FilteredTriangleNormals(
    std::span<const Point3> vertices, std::span<const Triangle> triangles);

/// A sign together with the value the filter found for it.
struct Side {
  Sign sign = Sign::kZero;
  BoundedValue value;
};

/// Where an edge u -> v through the view crosses a plane A that has u and v
/// strictly on opposite sides.
struct Crossing {
  int plane = -1;  ///< A
  Side from;       ///< A . u
  Side to;         ///< A . v, the opposite sign
};

class ViewGeometry {
 public:
  /// triangle_normals: FilteredTriangleNormals of the view's scene. The
  /// arguments must outlive the object.
  ViewGeometry(const ReceiverView& view,
               std::span<const FilteredPlane> triangle_normals);

  /// Adds a plane and returns its id. A kCut plane may refer to any triangle.
  int AddPlane(const PlaneRecipe& recipe);

  /// The id of the direction to a scene vertex.
  int VertexDirection(int vertex);

  /// Adds a direction that is no vertex and returns its id. kCrossing must
  /// not be added: no predicate needs it.
  int AddDirection(const DirectionRecipe& recipe);

  [[nodiscard]] const PlaneRecipe& plane(int id) const {
    return planes_[Index(id)].recipe;
  }

  [[nodiscard]] const DirectionRecipe& direction(int id) const {
    return directions_[Index(id)].recipe;
  }

  /// The direction as intervals.
  const Vec3<Interval>& DirectionInterval(int id);

  /// The normal of a triangle as intervals.
  [[nodiscard]] Vec3<Interval> TriangleNormalInterval(int triangle) const {
    return interval_.TriangleNormal(triangle);
  }

  /// Sign of h_t = N_t . (t0 - r): negative if r is in front of triangle t.
  /// Properties: (1) swapping two corners negates it; (2) zero exactly if r
  /// lies in the plane of t. Degree 3. No tie rule.
  Sign ReceiverSide(int triangle);

  /// Sign of N_t . (v - t0): positive if vertex v is in front of triangle t.
  /// Properties: (1) zero for the triangle's own corners; (2) does not depend
  /// on the receiver. Degree 3. No tie rule.
  Sign VertexSide(int triangle, int vertex);

  /// Sign of N . d. Properties: (1) negating either argument negates it;
  /// (2) zero for the two ends of the plane's own edge, known without
  /// arithmetic. No tie rule.
  Side PlaneSide(int plane, int direction);

  /// Order of two crossings along an edge u -> v in the plane N, N a positive
  /// multiple of u x v: negative if a comes first, zero if they coincide.
  /// With |A.u| / |A.v| growing along the edge this is the sign of
  /// |A.u| |B.v| - |B.u| |A.v| = -s_A s_B det(N, A, B) (method.md eq. (8)).
  /// Properties: (1) antisymmetric; (2) transitive; (3) negating A or B keeps
  /// it. Degree 6 for edge planes. No tie rule.
  Sign EdgeOrder(int edge_plane, const Crossing& a, const Crossing& b);

  [[nodiscard]] const Statistics& statistics() const { return statistics_; }

  // The stages, for the cascades above and for tests.
  [[nodiscard]] bool Incident(int plane, int direction) const;
  [[nodiscard]] bool SameEdge(int plane, int other) const;
  [[nodiscard]] std::optional<Sign> ReceiverSideInterval(int triangle) const;
  [[nodiscard]] Sign ReceiverSideExact(int triangle) const;
  [[nodiscard]] std::optional<Sign> VertexSideInterval(int triangle,
                                                       int vertex) const;
  [[nodiscard]] Sign VertexSideExact(int triangle, int vertex) const;
  [[nodiscard]] BoundedValue PlaneSideFilter(int plane, int direction) const;
  std::optional<Sign> PlaneSideInterval(int plane, int direction);
  Sign PlaneSideExact(int plane, int direction);
  [[nodiscard]] static std::optional<Sign> EdgeOrderFilter(const Crossing& a,
                                                           const Crossing& b);
  [[nodiscard]] std::optional<Sign> EdgeOrderInterval(int edge_plane,
                                                      const Crossing& a,
                                                      const Crossing& b) const;
  Sign EdgeOrderExact(int edge_plane, const Crossing& a, const Crossing& b);

 private:
  struct PlaneEntry {
    PlaneRecipe recipe;
    FilteredPlane filtered;
    Vec3<Interval> interval;
    std::unique_ptr<Vec3<Exact>> exact;  ///< made when first needed
  };

  struct DirectionEntry {
    DirectionRecipe recipe;
    FilteredDirection filtered;
    std::optional<Vec3<Interval>> interval;  ///< made when first needed
    std::unique_ptr<Vec3<Exact>> exact;      ///< made when first needed
  };

  static std::size_t Index(int id) { return static_cast<std::size_t>(id); }

  const Vec3<Exact>& PlaneExact(int id);
  const Vec3<Exact>& DirectionExact(int id);

  ReceiverView view_;
  std::span<const FilteredPlane> triangle_normals_;
  RecipeEvaluator<Interval> interval_;
  RecipeEvaluator<Exact> exact_;
  std::vector<PlaneEntry> planes_;
  std::vector<DirectionEntry> directions_;
  std::vector<int> vertex_directions_;  ///< id per vertex; -1: not yet
  Statistics statistics_;
};

}  // namespace truelux

#endif  // TRUELUX_EXACT_VIEW_GEOMETRY_H_
