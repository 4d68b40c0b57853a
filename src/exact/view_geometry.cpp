#include "exact/view_geometry.h"

namespace truelux {

std::vector<FilteredPlane> FilteredTriangleNormals(
    std::span<const Point3> vertices, std::span<const Triangle> triangles) {
  const RoundUpward rounding;
  const RecipeEvaluator<Interval> evaluator({vertices, triangles, {}, {}});
  std::vector<FilteredPlane> normals;
  normals.reserve(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    normals.push_back(MakeFilteredPlane(
        Approximate(evaluator.TriangleNormal(static_cast<int>(t)))));
  }
  return normals;
}

ViewGeometry::ViewGeometry(const ReceiverView& view,
                           std::span<const FilteredPlane> triangle_normals)
    : view_(view),
      triangle_normals_(triangle_normals),
      interval_(view),
      exact_(view),
      vertex_directions_(view.vertices.size(), -1) {}

int ViewGeometry::AddPlane(const PlaneRecipe& recipe) {
  PlaneEntry entry;
  entry.recipe = recipe;
  entry.interval = interval_.Plane(recipe, {});
  entry.filtered = MakeFilteredPlane(Approximate(entry.interval));
  planes_.push_back(std::move(entry));
  return static_cast<int>(planes_.size()) - 1;
}

int ViewGeometry::VertexDirection(int vertex) {
  int& id = vertex_directions_[Index(vertex)];
  if (id < 0) {
    id = static_cast<int>(directions_.size());
    DirectionEntry entry;
    entry.recipe = {.kind = DirectionRecipe::Kind::kVertex, .a = vertex};
    entry.filtered =
        FilteredDifference(view_.position, view_.vertices[Index(vertex)]);
    directions_.push_back(std::move(entry));
  }
  return id;
}

int ViewGeometry::AddDirection(const DirectionRecipe& recipe) {
  DirectionEntry entry;
  entry.recipe = recipe;
  entry.interval = interval_.Direction(recipe, {}, {});
  entry.filtered = MakeFilteredDirection(Approximate(*entry.interval));
  directions_.push_back(std::move(entry));
  return static_cast<int>(directions_.size()) - 1;
}

const Vec3<Interval>& ViewGeometry::DirectionInterval(int id) {
  DirectionEntry& entry = directions_[Index(id)];
  if (!entry.interval) {
    entry.interval = interval_.Direction(entry.recipe, {}, {});
  }
  return *entry.interval;
}

const Vec3<Exact>& ViewGeometry::PlaneExact(int id) {
  PlaneEntry& entry = planes_[Index(id)];
  if (!entry.exact) {
    entry.exact = std::make_unique<Vec3<Exact>>(exact_.Plane(entry.recipe, {}));
  }
  return *entry.exact;
}

const Vec3<Exact>& ViewGeometry::DirectionExact(int id) {
  DirectionEntry& entry = directions_[Index(id)];
  if (!entry.exact) {
    entry.exact =
        std::make_unique<Vec3<Exact>>(exact_.Direction(entry.recipe, {}, {}));
  }
  return *entry.exact;
}

std::optional<Sign> ViewGeometry::ReceiverSideInterval(int triangle) const {
  return TrySign(interval_.Height(triangle));
}

Sign ViewGeometry::ReceiverSideExact(int triangle) const {
  return SignOf(exact_.Height(triangle));
}

Sign ViewGeometry::ReceiverSide(int triangle) {
  const Point3& corner =
      view_.vertices[Index(view_.triangles[Index(triangle)].vertices[0])];
  StageCounts& counts = statistics_.receiver_side;
  if (const auto sign =
          TrySign(FilteredDot(triangle_normals_[Index(triangle)],
                              FilteredDifference(view_.position, corner)))) {
    ++counts.filter;
    return *sign;
  }
  if (const auto sign = ReceiverSideInterval(triangle)) {
    ++counts.interval;
    return *sign;
  }
  ++counts.exact;
  return ReceiverSideExact(triangle);
}

std::optional<Sign> ViewGeometry::VertexSideInterval(int triangle,
                                                     int vertex) const {
  return TrySign(interval_.AboveTriangle(triangle, vertex));
}

Sign ViewGeometry::VertexSideExact(int triangle, int vertex) const {
  return SignOf(exact_.AboveTriangle(triangle, vertex));
}

Sign ViewGeometry::VertexSide(int triangle, int vertex) {
  const Point3& corner =
      view_.vertices[Index(view_.triangles[Index(triangle)].vertices[0])];
  StageCounts& counts = statistics_.vertex_side;
  if (const auto sign = TrySign(FilteredDot(
          triangle_normals_[Index(triangle)],
          FilteredDifference(corner, view_.vertices[Index(vertex)])))) {
    ++counts.filter;
    return *sign;
  }
  if (const auto sign = VertexSideInterval(triangle, vertex)) {
    ++counts.interval;
    return *sign;
  }
  ++counts.exact;
  return VertexSideExact(triangle, vertex);
}

BoundedValue ViewGeometry::PlaneSideFilter(int plane, int direction) const {
  return FilteredDot(planes_[Index(plane)].filtered,
                     directions_[Index(direction)].filtered);
}

std::optional<Sign> ViewGeometry::PlaneSideInterval(int plane, int direction) {
  return TrySign(
      Dot(planes_[Index(plane)].interval, DirectionInterval(direction)));
}

Sign ViewGeometry::PlaneSideExact(int plane, int direction) {
  return SignOf(Dot(PlaneExact(plane), DirectionExact(direction)));
}

bool ViewGeometry::Incident(int plane, int direction) const {
  const PlaneRecipe& p = planes_[Index(plane)].recipe;
  const DirectionRecipe& d = directions_[Index(direction)].recipe;
  using PlaneKind = PlaneRecipe::Kind;
  switch (d.kind) {
    case DirectionRecipe::Kind::kVertex:
      return p.kind == PlaneKind::kEdge && (p.a == d.a || p.b == d.a);
    case DirectionRecipe::Kind::kEdgeAtHorizon:
      return p.kind == PlaneKind::kHorizon ||
             (p.kind == PlaneKind::kEdge &&
              ((p.a == d.a && p.b == d.b) || (p.a == d.b && p.b == d.a)));
    case DirectionRecipe::Kind::kEdgeAtPlane:
      if (p.kind == PlaneKind::kCut) {
        // The point lies in the source's plane and on an edge of the blocker.
        const auto& corners = view_.triangles[Index(p.b)].vertices;
        const auto has = [&corners](int v) {
          return corners[0] == v || corners[1] == v || corners[2] == v;
        };
        return p.a == d.c && has(d.a) && has(d.b);
      }
      return p.kind == PlaneKind::kEdge &&
             ((p.a == d.a && p.b == d.b) || (p.a == d.b && p.b == d.a));
    default:
      return false;
  }
}

bool ViewGeometry::SameEdge(int plane, int other) const {
  if (plane == other) return true;
  const PlaneRecipe& p = planes_[Index(plane)].recipe;
  const PlaneRecipe& q = planes_[Index(other)].recipe;
  return p.kind == PlaneRecipe::Kind::kEdge && q.kind == p.kind &&
         ((p.a == q.a && p.b == q.b) || (p.a == q.b && p.b == q.a));
}

Side ViewGeometry::PlaneSide(int plane, int direction) {
  StageCounts& counts = statistics_.plane_side;
  if (Incident(plane, direction)) {
    ++counts.symbolic;
    return {Sign::kZero, {}};
  }
  const BoundedValue value = PlaneSideFilter(plane, direction);
  if (const auto sign = TrySign(value)) {
    ++counts.filter;
    return {*sign, value};
  }
  if (const auto sign = PlaneSideInterval(plane, direction)) {
    ++counts.interval;
    return {*sign, value};
  }
  ++counts.exact;
  return {PlaneSideExact(plane, direction), value};
}

std::optional<Sign> ViewGeometry::EdgeOrderFilter(const Crossing& a,
                                                  const Crossing& b) {
  // |x y - fl(x~ y~)| <= |x~| e_y + |y~| e_x + e_x e_y + kUnit |x~ y~| +
  // underflow; the difference of the two products is rounded once more.
  const auto product = [](const BoundedValue& x, const BoundedValue& y) {
    const double ax = std::fabs(x.value);
    const double ay = std::fabs(y.value);
    const double value = ax * ay;
    return BoundedValue{value, ax * y.error + ay * x.error + x.error * y.error +
                                   value * kUnit + kProductFloor};
  };
  const BoundedValue first = product(a.from.value, b.to.value);
  const BoundedValue second = product(b.from.value, a.to.value);
  const double difference = first.value - second.value;
  return TrySign(BoundedValue{
      difference, first.error + second.error + std::fabs(difference) * kUnit});
}

std::optional<Sign> ViewGeometry::EdgeOrderInterval(int edge_plane,
                                                    const Crossing& a,
                                                    const Crossing& b) const {
  const auto sign = TrySign(Determinant(planes_[Index(edge_plane)].interval,
                                        planes_[Index(a.plane)].interval,
                                        planes_[Index(b.plane)].interval));
  if (!sign) return std::nullopt;
  return -(a.from.sign * b.from.sign * *sign);
}

Sign ViewGeometry::EdgeOrderExact(int edge_plane, const Crossing& a,
                                  const Crossing& b) {
  // References stay valid: the exact vectors live on the heap.
  const Vec3<Exact>& n = PlaneExact(edge_plane);
  const Vec3<Exact>& na = PlaneExact(a.plane);
  const Vec3<Exact>& nb = PlaneExact(b.plane);
  return -(a.from.sign * b.from.sign * SignOf(Determinant(n, na, nb)));
}

Sign ViewGeometry::EdgeOrder(int edge_plane, const Crossing& a,
                             const Crossing& b) {
  StageCounts& counts = statistics_.edge_order;
  if (SameEdge(a.plane, b.plane)) {
    ++counts.symbolic;
    return Sign::kZero;
  }
  if (const auto sign = EdgeOrderFilter(a, b)) {
    ++counts.filter;
    return *sign;
  }
  if (const auto sign = EdgeOrderInterval(edge_plane, a, b)) {
    ++counts.interval;
    return *sign;
  }
  ++counts.exact;
  return EdgeOrderExact(edge_plane, a, b);
}

}  // namespace truelux
