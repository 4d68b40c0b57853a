// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/view_geometry.h"

#include <bit>

#include "exact/approximation.h"

namespace truelux {
namespace {

/// Whether two recipes are for the same edge, in either direction.
template <class Recipe>
bool HaveSameEnds(const PlaneRecipe& p, const Recipe& q) {
  return (p.from() == q.from() && p.to() == q.to()) ||
         (p.from() == q.to() && p.to() == q.from());
}

/// The sign by the first stage that knows it.
template <class ByInterval, class ByDoubled, class ByExact>
Sign BySlowStages(StageCounts& counts, const ByInterval& interval,
                  const ByDoubled& doubled, const ByExact& exact) {
  if (const std::optional<Sign> sign = interval()) {
    ++counts.interval;
    return *sign;
  }
  if (const std::optional<Sign> sign = doubled()) {
    ++counts.double_double;
    return *sign;
  }
  ++counts.exact;
  return exact();
}

}  // namespace

IdVector<TriangleId, FilteredPlane> FilteredTriangleNormals(
    std::span<const Point3> vertices, std::span<const Triangle> triangles) {
  const RoundUpward rounding;
  const ReceiverView view{IdSpan<VertexId, const Point3>(vertices),
                          IdSpan<TriangleId, const Triangle>(triangles),
                          {},
                          {}};
  const RecipeEvaluator<Interval> evaluator(view);
  IdVector<TriangleId, FilteredPlane> normals;
  normals.reserve(triangles.size());
  for (const TriangleId t : view.triangles.ids()) {
    normals.push_back(
        MakeFilteredPlane(Approximate(evaluator.TriangleNormal(t))));
  }
  return normals;
}

template <PredicateKind kKind>
BasicViewGeometry<kKind>::BasicViewGeometry(
    const ReceiverView& view,
    IdSpan<TriangleId, const FilteredPlane> triangle_normals)
    : view_(view),
      triangle_normals_(triangle_normals),
      interval_(view),
      exact_(view),
      vertex_directions_(view.vertices.size()) {
  SetReceiver(view.position, view.normal);
}

template <PredicateKind kKind>
void BasicViewGeometry<kKind>::SetReceiver(const Point3& position,
                                           const Vector3& normal) {
  view_.position = position;
  view_.normal = normal;
  interval_ = RecipeEvaluator<Interval>(view_);
  exact_ = RecipeEvaluator<Exact>(view_);
  planes_.clear();
  directions_.clear();
  bundles_.clear();
  slow_.clear();
  doubled_.clear();
  statistics_ = {};
  vertex_directions_.Clear();
}

template <PredicateKind kKind>
ViewPlaneId BasicViewGeometry<kKind>::AddPlane(const PlaneRecipe& recipe) {
  const ViewPlaneId id = planes_.push_back({{}, recipe, SlowId()});
  if (recipe.kind() == PlaneRecipe::Kind::kEdge) {
    const Point3& a = view_.vertices[recipe.from()];
    const Point3& b = view_.vertices[recipe.to()];
    ApproxVector normal = FilteredCross(FilteredDifference(view_.position, a),
                                        FilteredDifference(a, b));
    if (recipe.negated()) {
      normal = {-normal.x, -normal.y, -normal.z, normal.error};
    }
    planes_.back().filtered = MakeFilteredPlane(normal);
  } else {
    planes_.back().filtered =
        MakeFilteredPlane(Approximate(SlowPlane(id).interval));
  }
  return id;
}

template <PredicateKind kKind>
ViewDirectionId BasicViewGeometry<kKind>::AddVertexDirection(VertexId vertex) {
  const ViewDirectionId id = directions_.push_back(
      {FilteredDifference(view_.position, view_.vertices[vertex]),
       DirectionRecipe::ToVertex(vertex), SlowId()});
  vertex_directions_.Set(vertex, id);
  return id;
}

template <PredicateKind kKind>
ViewDirectionId BasicViewGeometry<kKind>::AddDirection(
    const DirectionRecipe& recipe) {
  const ViewDirectionId id = directions_.push_back({{}, recipe, SlowId()});
  directions_.back().filtered =
      MakeFilteredDirection(Approximate(SlowDirection(id).interval));
  return id;
}

template <PredicateKind kKind>
auto BasicViewGeometry<kKind>::SlowPlane(ViewPlaneId id) -> SlowVector& {
  SlowId& slow = planes_[id].slow;
  if (!slow.valid()) {
    slow =
        slow_.push_back({interval_.Plane(planes_[id].recipe, {}), {}, nullptr});
  }
  return slow_[slow];
}

template <PredicateKind kKind>
auto BasicViewGeometry<kKind>::SlowDirection(ViewDirectionId id)
    -> SlowVector& {
  SlowId& slow = directions_[id].slow;
  if (!slow.valid())
    slow =
        slow_.push_back({interval_.Direction(directions_[id].recipe, {}, {})});
  return slow_[slow];
}

template <PredicateKind kKind>
const DoubledVector& BasicViewGeometry<kKind>::PlaneDoubled(ViewPlaneId id) {
  DoubledId& at = SlowPlane(id).doubled;
  if (!at.valid())
    at = doubled_.push_back(DoubledPlane(view_, planes_[id].recipe));
  return doubled_[at];
}

template <PredicateKind kKind>
const DoubledVector& BasicViewGeometry<kKind>::DirectionDoubled(
    ViewDirectionId id) {
  DoubledId& at = SlowDirection(id).doubled;
  if (!at.valid())
    at = doubled_.push_back(DoubledDirection(view_, directions_[id].recipe));
  return doubled_[at];
}

template <PredicateKind kKind>
const Vec3<Exact>& BasicViewGeometry<kKind>::PlaneExact(ViewPlaneId id) {
  SlowVector& slow = SlowPlane(id);
  if (!slow.exact) {
    slow.exact =
        std::make_unique<Vec3<Exact>>(exact_.Plane(planes_[id].recipe, {}));
  }
  return *slow.exact;
}

template <PredicateKind kKind>
const Vec3<Exact>& BasicViewGeometry<kKind>::DirectionExact(
    ViewDirectionId id) {
  SlowVector& slow = SlowDirection(id);
  if (!slow.exact) {
    slow.exact = std::make_unique<Vec3<Exact>>(
        exact_.Direction(directions_[id].recipe, {}, {}));
  }
  return *slow.exact;
}

template <PredicateKind kKind>
std::optional<Sign> BasicViewGeometry<kKind>::ReceiverSideInterval(
    TriangleId triangle) const {
  return SignFrom(interval_.Height(triangle));
}

template <PredicateKind kKind>
std::optional<Sign> BasicViewGeometry<kKind>::ReceiverSideDoubled(
    TriangleId triangle) const {
  return DoubledHeight(view_, triangle);
}

template <PredicateKind kKind>
Sign BasicViewGeometry<kKind>::ReceiverSideExact(TriangleId triangle) const {
  return SignOf(exact_.Height(triangle));
}

template <PredicateKind kKind>
Sign BasicViewGeometry<kKind>::ReceiverSide(TriangleId triangle) {
  const Point3& corner = view_.Corner(triangle, 0);
  StageCounts& counts = statistics_.receiver_side;
  const BoundedValue value = Filter(triangle_normals_[triangle],
                                    FilteredDifference(view_.position, corner));
  if (const auto sign = TrySign(value)) {
    ++counts.filter;
    return *sign;
  }
  if constexpr (kKind == PredicateKind::kUnfiltered) return Sign::kZero;
  return BySlowStages(
      counts, [&] { return ReceiverSideInterval(triangle); },
      [&] { return ReceiverSideDoubled(triangle); },
      [&] { return ReceiverSideExact(triangle); });
}

template <PredicateKind kKind>
std::optional<Sign> BasicViewGeometry<kKind>::VertexSideInterval(
    TriangleId triangle, VertexId vertex) const {
  return SignFrom(interval_.AboveTriangle(triangle, vertex));
}

template <PredicateKind kKind>
std::optional<Sign> BasicViewGeometry<kKind>::VertexSideDoubled(
    TriangleId triangle, VertexId vertex) const {
  return DoubledAbove(view_, triangle, vertex);
}

template <PredicateKind kKind>
Sign BasicViewGeometry<kKind>::VertexSideExact(TriangleId triangle,
                                               VertexId vertex) const {
  return SignOf(exact_.AboveTriangle(triangle, vertex));
}

template <PredicateKind kKind>
Sign BasicViewGeometry<kKind>::VertexSide(TriangleId triangle,
                                          VertexId vertex) {
  const auto [a, b, c] = CornersOf(view_.triangles[triangle]);
  StageCounts& counts = statistics_.vertex_side;
  if (vertex == a || vertex == b || vertex == c) {
    ++counts.symbolic;
    return Sign::kZero;
  }
  const BoundedValue value =
      Filter(triangle_normals_[triangle],
             FilteredDifference(view_.vertices[a], view_.vertices[vertex]));
  if (const auto sign = TrySign(value)) {
    ++counts.filter;
    return *sign;
  }
  if constexpr (kKind == PredicateKind::kUnfiltered) return Sign::kZero;
  return BySlowStages(
      counts, [&] { return VertexSideInterval(triangle, vertex); },
      [&] { return VertexSideDoubled(triangle, vertex); },
      [&] { return VertexSideExact(triangle, vertex); });
}

template <PredicateKind kKind>
std::optional<Sign> BasicViewGeometry<kKind>::PlaneSideInterval(
    ViewPlaneId plane, ViewDirectionId direction) {
  // By value: the second may move the first.
  const Vec3<Interval> normal = SlowPlane(plane).interval;
  return SignFrom(Dot(normal, SlowDirection(direction).interval));
}

template <PredicateKind kKind>
std::optional<Sign> BasicViewGeometry<kKind>::PlaneSideDoubled(
    ViewPlaneId plane, ViewDirectionId direction) {
  // By value: the second may move the first.
  const DoubledVector normal = PlaneDoubled(plane);
  return DoubledDot(normal, DirectionDoubled(direction));
}

template <PredicateKind kKind>
Sign BasicViewGeometry<kKind>::PlaneSideExact(ViewPlaneId plane,
                                              ViewDirectionId direction) {
  // References stay valid: the exact vectors live on the heap.
  const Vec3<Exact>& normal = PlaneExact(plane);
  return SignOf(Dot(normal, DirectionExact(direction)));
}

template <PredicateKind kKind>
bool BasicViewGeometry<kKind>::Incident(ViewPlaneId plane,
                                        ViewDirectionId direction) const {
  const PlaneRecipe& p = planes_[plane].recipe;
  const DirectionRecipe& d = directions_[direction].recipe;
  using PlaneKind = PlaneRecipe::Kind;
  switch (d.kind()) {
    case DirectionRecipe::Kind::kVertex:
      return p.kind() == PlaneKind::kEdge &&
             (p.from() == d.vertex() || p.to() == d.vertex());
    case DirectionRecipe::Kind::kEdgeAtHorizon:
      return p.kind() == PlaneKind::kHorizon ||
             (p.kind() == PlaneKind::kEdge && HaveSameEnds(p, d));
    case DirectionRecipe::Kind::kEdgeAtPlane:
      if (p.kind() == PlaneKind::kCut) {
        // The point lies in the source's plane and on an edge of the blocker.
        const auto corners = CornersOf(view_.triangles[p.second_triangle()]);
        return p.first_triangle() == d.triangle() &&
               std::ranges::count(corners, d.from()) > 0 &&
               std::ranges::count(corners, d.to()) > 0;
      }
      return p.kind() == PlaneKind::kEdge && HaveSameEnds(p, d);
    default:
      return false;
  }
}

template <PredicateKind kKind>
Sign BasicViewGeometry<kKind>::PlaneSideSlowly(ViewPlaneId plane,
                                               ViewDirectionId direction) {
  StageCounts& counts = statistics_.plane_side;
  if (Incident(plane, direction)) {
    ++counts.symbolic;
    return Sign::kZero;
  }
  return BySlowStages(
      counts, [&] { return PlaneSideInterval(plane, direction); },
      [&] { return PlaneSideDoubled(plane, direction); },
      [&] { return PlaneSideExact(plane, direction); });
}

template <PredicateKind kKind>
BundleId BasicViewGeometry<kKind>::AddBundle(
    std::span<const ViewPlaneId> planes) {
  PlaneBundle bundle;
  for (const ViewPlaneId plane : planes)
    bundle.Add(planes_[plane].filtered, plane);
  return bundles_.push_back(bundle);
}

template <PredicateKind kKind>
void BasicViewGeometry<kKind>::DecideSides(BundleId bundle,
                                           ViewDirectionId direction,
                                           std::uint32_t open,
                                           BundleSides& sides) {
  for (; open != 0; open &= open - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(open));
    const Sign sign = PlaneSideSlowly(bundles_[bundle].id(k), direction);
    if (sign == Sign::kPositive) sides.positive |= 1U << k;
    if (sign == Sign::kNegative) sides.negative |= 1U << k;
  }
}

template <PredicateKind kKind>
bool BasicViewGeometry<kKind>::SameEdge(ViewPlaneId plane,
                                        ViewPlaneId other) const {
  if (plane == other) return true;
  const PlaneRecipe& p = planes_[plane].recipe;
  const PlaneRecipe& q = planes_[other].recipe;
  return p.kind() == PlaneRecipe::Kind::kEdge && q.kind() == p.kind() &&
         HaveSameEnds(p, q);
}

template <PredicateKind kKind>
std::optional<Sign> BasicViewGeometry<kKind>::EdgeOrderInterval(
    ViewPlaneId edge_plane, const Crossing& a, const Crossing& b) {
  // By value: making one may move the others.
  const Vec3<Interval> n = SlowPlane(edge_plane).interval;
  const Vec3<Interval> na = SlowPlane(a.plane).interval;
  const auto sign = SignFrom(Determinant(n, na, SlowPlane(b.plane).interval));
  if (!sign) return std::nullopt;
  return -(a.from * b.from * *sign);
}

template <PredicateKind kKind>
std::optional<Sign> BasicViewGeometry<kKind>::EdgeOrderDoubled(
    ViewPlaneId edge_plane, const Crossing& a, const Crossing& b) {
  // By value: making one may move the others.
  const DoubledVector n = PlaneDoubled(edge_plane);
  const DoubledVector na = PlaneDoubled(a.plane);
  const auto sign = DoubledDeterminant(n, na, PlaneDoubled(b.plane));
  if (!sign) return std::nullopt;
  return -(a.from * b.from * *sign);
}

template <PredicateKind kKind>
Sign BasicViewGeometry<kKind>::EdgeOrderExact(ViewPlaneId edge_plane,
                                              const Crossing& a,
                                              const Crossing& b) {
  // References stay valid: the exact vectors live on the heap.
  const Vec3<Exact>& n = PlaneExact(edge_plane);
  const Vec3<Exact>& na = PlaneExact(a.plane);
  const Vec3<Exact>& nb = PlaneExact(b.plane);
  return -(a.from * b.from * SignOf(Determinant(n, na, nb)));
}

template <PredicateKind kKind>
Sign BasicViewGeometry<kKind>::EdgeOrderSlowly(ViewPlaneId edge_plane,
                                               const Crossing& a,
                                               const Crossing& b) {
  StageCounts& counts = statistics_.edge_order;
  if (SameEdge(a.plane, b.plane)) {
    ++counts.symbolic;
    return Sign::kZero;
  }
  return BySlowStages(
      counts, [&] { return EdgeOrderInterval(edge_plane, a, b); },
      [&] { return EdgeOrderDoubled(edge_plane, a, b); },
      [&] { return EdgeOrderExact(edge_plane, a, b); });
}

template class BasicViewGeometry<PredicateKind::kExact>;
template class BasicViewGeometry<PredicateKind::kUnfiltered>;
template class BasicViewGeometry<PredicateKind::kDisplaced>;

}  // namespace truelux
