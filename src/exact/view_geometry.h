// SPDX-License-Identifier: GPL-3.0-or-later
// Planes and directions seen from one receiver, and the signs between them.
//
// Every sign is decided in stages: a double filter, intervals,
// double-double, exact numbers.
// Each stage is a function of its own that says "not known" by an empty
// optional; the public predicate is the cascade, and counts who answered.
// The whole class works under RoundUpward.

#ifndef TRUELUX_EXACT_VIEW_GEOMETRY_H_
#define TRUELUX_EXACT_VIEW_GEOMETRY_H_

#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "truelux/statistics.h"

#include "base/id_vector.h"
#include "base/ids.h"
#include "base/stamped_table.h"
#include "exact/crossing.h"
#include "exact/doubled.h"
#include "exact/filter.h"
#include "exact/plane_bundle.h"
#include "exact/predicate_kind.h"
#include "exact/recipe_evaluator.h"
#include "exact/sign.h"

namespace truelux {

/// The filtered normals of the triangles of a scene; independent of receivers.
IdVector<TriangleId, FilteredPlane> FilteredTriangleNormals(
    std::span<const Point3> vertices, std::span<const Triangle> triangles);

template <PredicateKind kKind>
class BasicViewGeometry {
 public:
  /// triangle_normals: FilteredTriangleNormals of the view's scene. What the
  /// arguments refer to must outlive the object.
  BasicViewGeometry(const ReceiverView& view,
                    IdSpan<TriangleId, const FilteredPlane> triangle_normals);

  /// Of kDisplaced: where the next receivers are displaced to, and which vertex
  /// is; it must outlive its use. Before SetReceiver.
  void SetDisplacement(const Displacement* displacement) requires(
      kKind == PredicateKind::kDisplaced) {
    view_.displacement = displacement;
  }

  /// Forgets all planes, directions and counts and starts with another
  /// receiver in the same scene. Allocates nothing in the steady state.
  void SetReceiver(const Point3& position, const Vector3& normal);

  /// Adds a plane and returns its id. A kCut plane may refer to any triangle.
  ViewPlaneId AddPlane(const PlaneRecipe& recipe);

  /// The id of the direction to a scene vertex.
  ViewDirectionId VertexDirection(VertexId vertex) {
    return vertex_directions_.Has(vertex) ? vertex_directions_[vertex]
                                          : AddVertexDirection(vertex);
  }

  /// Adds a direction that is no vertex and returns its id. kCrossing must
  /// not be added: no predicate needs it.
  ViewDirectionId AddDirection(const DirectionRecipe& recipe);

  [[nodiscard]] const ReceiverView& view() const { return view_; }

  [[nodiscard]] const PlaneRecipe& plane(ViewPlaneId id) const {
    return planes_[id].recipe;
  }

  [[nodiscard]] const DirectionRecipe& direction(ViewDirectionId id) const {
    return directions_[id].recipe;
  }

  [[nodiscard]] std::size_t plane_count() const { return planes_.size(); }

  [[nodiscard]] std::size_t direction_count() const {
    return directions_.size();
  }

  /// The direction as the filter sees it.
  [[nodiscard]] const FilteredDirection& DirectionFilter(
      ViewDirectionId id) const {
    return directions_[id].filtered;
  }

  /// The normal of a triangle as the filter sees it.
  [[nodiscard]] const FilteredPlane& TriangleNormalFilter(
      TriangleId triangle) const {
    return triangle_normals_[triangle];
  }

  /// Sign of h_t = N_t . (t0 - r): negative if r is in front of triangle t.
  /// Properties: (1) swapping two corners negates it; (2) zero exactly if r
  /// lies in the plane of t. Degree 3. No tie rule.
  Sign ReceiverSide(TriangleId triangle);

  /// Sign of N_t . (v - t0): positive if vertex v is in front of triangle t.
  /// Properties: (1) zero for the triangle's own corners; (2) does not depend
  /// on the receiver. Degree 3. No tie rule.
  Sign VertexSide(TriangleId triangle, VertexId vertex);

  /// Sign of N . d. Properties: (1) negating either argument negates it;
  /// (2) zero for the two ends of the plane's own edge, known without
  /// arithmetic. No tie rule.
  Side PlaneSide(ViewPlaneId plane, ViewDirectionId direction) {
    const BoundedValue value = PlaneSideFilter(plane, direction);
    if constexpr (kKind == PredicateKind::kUnfiltered) {
      ++statistics_.plane_side.filter;
      return {SignOf(value.value), value};
    }
    if (const auto sign = TrySign(value)) {
      ++statistics_.plane_side.filter;
      return {*sign, value};
    }
    return {PlaneSideSlowly(plane, direction), value};
  }

  /// Puts up to BundleSides::kMaxPlanes planes side by side, for FilterSides.
  /// Returns the bundle's id.
  BundleId AddBundle(std::span<const ViewPlaneId> planes);

  /// PlaneSide of all planes of a bundle, as far as the filter knows: a plane
  /// with neither bit set is not known yet. Faster than one by one.
  void FilterSides(BundleId bundle, ViewDirectionId direction,
                   BundleSides& sides) {
    bundles_[bundle].template Filter<kKind != PredicateKind::kUnfiltered>(
        directions_[direction].filtered, sides);
    statistics_.plane_side.filter += static_cast<std::uint64_t>(
        std::popcount(sides.positive | sides.negative));
  }

  /// Decides the planes that FilterSides left open. After it, a plane with
  /// neither bit set has sign zero.
  void CompleteSides(BundleId bundle, ViewDirectionId direction,
                     BundleSides& sides) {
    if (sides.complete) return;
    sides.complete = true;
    if constexpr (kKind == PredicateKind::kUnfiltered) return;
    const std::uint32_t open =
        BundleMask(bundle) & ~(sides.positive | sides.negative);
    if (open != 0) DecideSides(bundle, direction, open, sides);
  }

  /// A bit for every plane of a bundle.
  [[nodiscard]] std::uint32_t BundleMask(BundleId bundle) const {
    return bundles_[bundle].mask();
  }

  /// Order of two crossings along an edge u -> v in the plane N, N a positive
  /// multiple of u x v: negative if a comes first, zero if they coincide.
  /// With |A.u| / |A.v| growing along the edge this is the sign of
  /// |A.u| |B.v| - |B.u| |A.v| = -s_A s_B det(N, A, B) (method.md eq. (8)).
  /// Properties: (1) antisymmetric; (2) transitive; (3) negating A or B keeps
  /// it. Degree 6 for edge planes. No tie rule.
  Sign EdgeOrder(ViewPlaneId edge_plane, const Crossing& a, const Crossing& b) {
    if constexpr (kKind == PredicateKind::kUnfiltered) {
      ++statistics_.edge_order.filter;
      return SignOf(a.parameter - b.parameter);
    }
    if (const auto sign = TryOrder(a, b)) {
      ++statistics_.edge_order.filter;
      return *sign;
    }
    return EdgeOrderSlowly(edge_plane, a, b);
  }

  [[nodiscard]] const Statistics& statistics() const { return statistics_; }

  // The stages, for the cascades above and for tests.
  [[nodiscard]] bool Incident(ViewPlaneId plane,
                              ViewDirectionId direction) const;
  [[nodiscard]] bool SameEdge(ViewPlaneId plane, ViewPlaneId other) const;
  [[nodiscard]] std::optional<Sign> ReceiverSideInterval(
      TriangleId triangle) const;
  [[nodiscard]] std::optional<Sign> ReceiverSideDoubled(
      TriangleId triangle) const;
  [[nodiscard]] Sign ReceiverSideExact(TriangleId triangle) const;
  [[nodiscard]] std::optional<Sign> VertexSideInterval(TriangleId triangle,
                                                       VertexId vertex) const;
  [[nodiscard]] std::optional<Sign> VertexSideDoubled(TriangleId triangle,
                                                      VertexId vertex) const;
  [[nodiscard]] Sign VertexSideExact(TriangleId triangle,
                                     VertexId vertex) const;

  [[nodiscard]] BoundedValue PlaneSideFilter(ViewPlaneId plane,
                                             ViewDirectionId direction) const {
    return Filter(planes_[plane].filtered, directions_[direction].filtered);
  }

  std::optional<Sign> PlaneSideInterval(ViewPlaneId plane,
                                        ViewDirectionId direction);
  std::optional<Sign> PlaneSideDoubled(ViewPlaneId plane,
                                       ViewDirectionId direction);
  Sign PlaneSideExact(ViewPlaneId plane, ViewDirectionId direction);
  std::optional<Sign> EdgeOrderInterval(ViewPlaneId edge_plane,
                                        const Crossing& a, const Crossing& b);
  std::optional<Sign> EdgeOrderDoubled(ViewPlaneId edge_plane,
                                       const Crossing& a, const Crossing& b);
  Sign EdgeOrderExact(ViewPlaneId edge_plane, const Crossing& a,
                      const Crossing& b);

 private:
  using SlowId = Id<struct SlowTag>;
  using DoubledId = Id<struct DoubledTag>;

  /// A vector at the slow stages, made when one is first needed.
  struct SlowVector {
    Vec3<Interval> interval;
    DoubledId doubled{};  ///< none until it is needed
    std::unique_ptr<Vec3<Exact>> exact{};
  };

  /// A direction to a vertex or a point of an edge.
  struct DirectionEntry {
    FilteredDirection filtered;
    DirectionRecipe recipe;
    SlowId slow;  ///< none until it is needed
  };

  struct PlaneEntry {
    FilteredPlane filtered;
    PlaneRecipe recipe;
    SlowId slow;  ///< none until it is needed
  };

  /// What an interval says; of kDisplaced nothing where it says zero.
  static std::optional<Sign> SignFrom(const Interval& x) {
    const std::optional<Sign> sign = TrySign(x);
    if constexpr (kKind == PredicateKind::kDisplaced) {
      if (sign == Sign::kZero) return std::nullopt;
    }
    return sign;
  }

  /// N . d with its bound; unfiltered without one.
  static BoundedValue Filter(const FilteredPlane& plane,
                             const FilteredDirection& direction) {
    if constexpr (kKind == PredicateKind::kUnfiltered) {
      return {plane.v.x * direction.v.x + plane.v.y * direction.v.y +
                  plane.v.z * direction.v.z,
              0};
    }
    return FilteredDot(plane, direction);
  }

  ViewDirectionId AddVertexDirection(VertexId vertex);
  Sign PlaneSideSlowly(ViewPlaneId plane, ViewDirectionId direction);
  void DecideSides(BundleId bundle, ViewDirectionId direction,
                   std::uint32_t open, BundleSides& sides);
  Sign EdgeOrderSlowly(ViewPlaneId edge_plane, const Crossing& a,
                       const Crossing& b);
  SlowVector& SlowPlane(ViewPlaneId id);
  SlowVector& SlowDirection(ViewDirectionId id);
  const DoubledVector& PlaneDoubled(ViewPlaneId id);
  const DoubledVector& DirectionDoubled(ViewDirectionId id);
  const Vec3<Exact>& PlaneExact(ViewPlaneId id);
  const Vec3<Exact>& DirectionExact(ViewDirectionId id);

  ReceiverView view_;
  IdSpan<TriangleId, const FilteredPlane> triangle_normals_;
  RecipeEvaluator<Interval> interval_;
  RecipeEvaluator<Exact> exact_;
  IdVector<ViewPlaneId, PlaneEntry> planes_;
  IdVector<ViewDirectionId, DirectionEntry> directions_;
  IdVector<BundleId, PlaneBundle> bundles_;
  IdVector<SlowId, SlowVector> slow_;
  IdVector<DoubledId, DoubledVector> doubled_;
  StampedTable<ViewDirectionId, VertexId> vertex_directions_;
  Statistics statistics_;
};

using ViewGeometry = BasicViewGeometry<PredicateKind::kExact>;
using UnfilteredViewGeometry = BasicViewGeometry<PredicateKind::kUnfiltered>;
using DisplacedViewGeometry = BasicViewGeometry<PredicateKind::kDisplaced>;

extern template class BasicViewGeometry<PredicateKind::kExact>;
extern template class BasicViewGeometry<PredicateKind::kUnfiltered>;
extern template class BasicViewGeometry<PredicateKind::kDisplaced>;

}  // namespace truelux

#endif  // TRUELUX_EXACT_VIEW_GEOMETRY_H_
