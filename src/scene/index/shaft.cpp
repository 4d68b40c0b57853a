// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/index/shaft.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "base/id_vector.h"
#include "base/ids.h"
#include "exact/lanes.h"
#include "exact/recipe.h"
#include "exact/rounding.h"

namespace truelux {
namespace {

using Vector = Vec3<double>;

// Sources with more corners stand behind the corners of their box: each
// half-space costs one look at each of these points.
constexpr std::size_t kMaxPoints = 16;

Vector ToVector(const std::array<double, 3>& p) {
  return {p[0], p[1], p[2]};
}

bool IsFinite(const Vector& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

double LargestComponent(const Vector& v) {
  return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

/// About 1 / x, finite.
double Reciprocal(double x) {
  return std::min(1 / x, std::numeric_limits<double>::max());
}

/// The vector at a size at which its products neither over- nor underflow.
Vector Normalized(const Vector& v) {
  return Reciprocal(LargestComponent(v)) * v;
}

/// At least the greatest m . p over points, as products and sums are rounded
/// upwards.
double Most(const Vector& m, std::span<const Vector> points) {
  double most = -HUGE_VAL;
  for (const Vector& p : points)
    most = std::max(most, Dot(m, p));
  return most;
}

/// The same over a box.
double Most(const Vector& m, const Box& box) {
  return std::max(m.x * box.lo[0], m.x * box.hi[0]) +
         std::max(m.y * box.lo[1], m.y * box.hi[1]) +
         std::max(m.z * box.lo[2], m.z * box.hi[2]);
}

/// The axis of a vector along one, or nothing.
std::optional<std::size_t> AxisOf(const Vector& v) {
  if (v.y == 0 && v.z == 0) return 0;
  if (v.x == 0 && v.z == 0) return 1;
  if (v.x == 0 && v.y == 0) return 2;
  return std::nullopt;
}

/// The vertices of a facet: in the order of its ring if it is a triangle or
/// two triangles with a common edge.
std::vector<VertexId> VerticesOf(std::span<const Triangle> facet) {
  std::vector<VertexId> vertices;
  for (const Triangle& triangle : facet) {
    const std::array<VertexId, 3> corners = CornersOf(triangle);
    vertices.insert(vertices.end(), corners.begin(), corners.end());
  }
  if (facet.size() == 2) {
    const std::array<VertexId, 3> first = CornersOf(facet[0]);
    const std::array<VertexId, 3> second = CornersOf(facet[1]);
    vertices.resize(3);
    for (std::size_t k = 0; k < 3; ++k) {
      if (std::ranges::find(first, second[k]) != first.end()) continue;
      // The ring leaves the new corner for its successor in the triangle.
      const auto next = std::ranges::find(vertices, second[(k + 1) % 3]);
      vertices.insert(next, second[k]);
    }
  } else if (facet.size() > 2) {
    std::ranges::sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()),
                   vertices.end());
  }
  return vertices;
}

}  // namespace

ShaftSource::ShaftSource(std::span<const Point3> vertices,
                         std::span<const Triangle> facet) {
  assert(IsRoundingUpward());
  assert(!facet.empty());
  const IdSpan<VertexId, const Point3> places(vertices);
  for (const VertexId vertex : VerticesOf(facet)) {
    const Point3& p = places[vertex];
    points_.push_back({p.x, p.y, p.z});
    box_.Include(p);
  }
  const auto corner = [&](const Triangle& triangle, std::size_t k) {
    const Point3& p = places[VertexId(triangle.vertices[k])];
    return Vector{p.x, p.y, p.z};
  };
  const double scale =
      Reciprocal(LargestComponent(ToVector(box_.hi) - ToVector(box_.lo)));
  Vector normal{0, 0, 0};  // the vector area, nearly
  for (const Triangle& triangle : facet) {
    const Vector a = corner(triangle, 0);
    normal = normal - Cross(scale * (corner(triangle, 2) - a),
                            scale * (corner(triangle, 1) - a));
  }
  if (!IsFinite(normal)) normal = {0, 0, 0};
  SetEdges(normal);
  if (!AxisOf(normal)) {  // otherwise the box says it all
    normal_ = Normalized(normal);
    normal_most_ = Most(normal_, points_);
    normal_least_ = -Most(-normal_, points_);
  }
  if (points_.size() > kMaxPoints) {
    points_.clear();
    for (const double x : {box_.lo[0], box_.hi[0]}) {
      for (const double y : {box_.lo[1], box_.hi[1]}) {
        for (const double z : {box_.lo[2], box_.hi[2]})
          points_.push_back({x, y, z});
      }
    }
  }
}

/// Of a source with more than four corners, the edges of a rectangle.
void ShaftSource::SetEdges(const Vector& normal) {
  std::array<Vector, 4> ring{};
  if (points_.size() <= ring.size()) {
    edge_count_ = points_.size();
    std::ranges::copy(points_, ring.begin());
  } else {
    // Two axes in the plane: the cross product of the normal with the
    // coordinate axis it is farthest from, and of that with the normal.
    const Vector size{std::fabs(normal.x), std::fabs(normal.y),
                      std::fabs(normal.z)};
    const double least = std::min({size.x, size.y, size.z});
    const Vector axis{size.x == least ? 1.0 : 0.0,
                      size.x != least && size.y == least ? 1.0 : 0.0,
                      size.x != least && size.y != least ? 1.0 : 0.0};
    const Vector n = Normalized(normal);
    const Vector u = Cross(n, axis);
    const Vector v = Cross(n, u);
    const double u_least = -Most(-u, points_) / Dot(u, u);
    const double u_most = Most(u, points_) / Dot(u, u);
    const double v_least = -Most(-v, points_) / Dot(v, v);
    const double v_most = Most(v, points_) / Dot(v, v);
    const double height = Dot(n, points_[0]) / Dot(n, n);
    const auto at = [&](double a, double b) {
      return height * n - ((-a) * u - b * v);
    };
    edge_count_ = 4;
    ring = {at(u_least, v_least), at(u_most, v_least), at(u_most, v_most),
            at(u_least, v_most)};
  }
  for (std::size_t k = 0; k < edge_count_; ++k) {
    const Vector along = ring[(k + 1) % edge_count_] - ring[k];
    edges_[k] = {ring[k], Normalized(along)};
  }
}

Shaft::Shaft(const ShaftSource& source, const Box& receivers,
             const std::optional<Vector3>& normal)
    : box_(source.box_) {
  assert(IsRoundingUpward());
  box_.Include(receivers);
  AddSides(source, receivers);
  if (!AxisOf(source.normal_)) AddSourcePlane(source, receivers);
  if (normal) AddHorizon(receivers, {normal->x, normal->y, normal->z});
}

void Shaft::Add(const Vector& normal, double least) {
  const auto row = [](double component, std::size_t axis) {
    return component > 0 ? axis + 3 : axis;
  };
  assert(count_ < half_spaces_.size());
  half_spaces_[count_++] = {
      normal, least, {row(normal.x, 0), row(normal.y, 1), row(normal.z, 2)}};
}

/// The planes through the centre of the receivers and the source's edges,
/// moved outwards where the receivers have an extent.
void Shaft::AddSides(const ShaftSource& source, const Box& receivers) {
  const Vector centre =
      0.5 * ToVector(receivers.lo) - (-0.5) * ToVector(receivers.hi);
  std::array<Vector, 4> to{};
  double size = 0;
  Vector inside{0, 0, 0};
  for (std::size_t k = 0; k < source.edge_count_; ++k) {
    to[k] = source.edges_[k].from - centre;
    size = std::max(size, LargestComponent(to[k]));
    inside = inside - -to[k];
  }
  const double scale = Reciprocal(size);
  for (std::size_t k = 0; k < source.edge_count_; ++k) {
    Vector normal = Cross(scale * to[k], source.edges_[k].along);
    if (!IsFinite(normal)) continue;
    if (Dot(normal, inside) < 0) normal = -normal;
    const Vector outwards = -normal;
    Add(normal,
        -std::max(Most(outwards, source.points_), Most(outwards, receivers)));
  }
}

/// Not beyond the source, and not behind the receivers.
void Shaft::AddSourcePlane(const ShaftSource& source, const Box& receivers) {
  const Vector& n = source.normal_;
  Add(-n, -std::max(source.normal_most_, Most(n, receivers)));
  Add(n, std::min(source.normal_least_, -Most(-n, receivers)));
}

void Shaft::AddHorizon(const Box& receivers, const Vector& normal) {
  const std::optional<std::size_t> axis = AxisOf(normal);
  if (!axis) {
    Add(normal, -Most(-normal, receivers));
  } else if (normal.x + normal.y + normal.z > 0) {
    box_.lo[*axis] = std::max(box_.lo[*axis], receivers.lo[*axis]);
  } else {
    box_.hi[*axis] = std::min(box_.hi[*axis], receivers.hi[*axis]);
  }
}

unsigned Shaft::Kept(const FourBoxes& boxes) const {
  assert(IsRoundingUpward());
  LaneFlags outside{0, 0, 0, 0};
  Lanes x;
  Lanes y;
  Lanes z;
  for (std::size_t k = 0; k < 3; ++k) {
    Load(boxes.rows[k], x);
    outside |= x > box_.hi[k];
    Load(boxes.rows[k + 3], x);
    outside |= x < box_.lo[k];
  }
  for (const HalfSpace& h : std::span(half_spaces_.data(), count_)) {
    Load(boxes.rows[h.rows[0]], x);
    Load(boxes.rows[h.rows[1]], y);
    Load(boxes.rows[h.rows[2]], z);
    outside |= h.normal.x * x + h.normal.y * y + h.normal.z * z < h.least;
  }
  return ~Gather(outside) & ((1U << kLanes) - 1);
}

bool Shaft::Keeps(const Box& box) const {
  FourBoxes boxes;
  boxes.Set(0, box);
  return (Kept(boxes) & 1U) != 0;
}

}  // namespace truelux
