// SPDX-License-Identifier: GPL-3.0-or-later
// Notation
//   o, d     origin and direction of the ray; its points are o + t d, t > 0
//   a, b, c  corners of a triangle; w = a - o
//   N        the triangle's normal (b - a) x (c - a), of any length
//   height   N . w;  speed  N . d; the ray is in the plane at t = height / speed
//   terms    a bound on the products that a value is the sum of

#include "visibility/first_hit.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "exact/double_double.h"
#include "exact/exact_conversion.h"
#include "exact/filter.h"
#include "exact/number.h"
#include "exact/rational.h"
#include "exact/rounding.h"
#include "exact/sign.h"
#include "exact/vec3.h"
#include "scene/coplanar_order.h"
#include "scene/index/ray_boxes.h"
#include "scene/newell.h"

namespace truelux {
namespace {

/// The corners of a triangle.
struct Corners {
  Corners(const Scene& scene, int index) {
    const Triangle& triangle =
        scene.triangles()[static_cast<std::size_t>(index)];
    for (std::size_t k = 0; k < 3; ++k)
      at[k] = scene.vertices()[static_cast<std::size_t>(triangle.vertices[k])];
  }

  std::array<Point3, 3> at;
};

/// N . (p - origin) and N . d of a triangle with normal N and a point p on it,
/// both times the sign of the latter: the ray is in the plane where the
/// parameter is height / speed.
struct ExactParameter {
  ExactParameter(const Ray& ray, const Corners& corners) {
    const auto& [a, b, c] = corners.at;
    const Vec3<Exact> normal =
        Cross(Displacement<Exact>(a, b), Displacement<Exact>(a, c));
    height = Dot(normal, Displacement<Exact>(ray.origin, a));
    speed =
        Dot(normal, Vec3<Exact>{Exact(ray.direction.x), Exact(ray.direction.y),
                                Exact(ray.direction.z)});
    if (SignOf(speed) == Sign::kNegative) {
      height = -height;
      speed = -speed;
    }
  }

  Exact height;
  Exact speed;
};

/// A triangle that the ray meets, and where.
struct MetTriangle {
  int triangle = -1;
  SeenFacet seen;
  double least = 0;  ///< the ray's parameter lies in [least, most]
  double most = HUGE_VAL;
};

/// One search. All members require RoundUpward.
class Search {
 public:
  Search(const Scene& scene, const Ray& ray)
      : scene_(scene),
        ray_(ray),
        direction_(MakeFilteredDirection(
            {ray.direction.x, ray.direction.y, ray.direction.z, 0})),
        boxes_(ray.origin, ray.direction) {
    assert(IsRoundingUpward());
  }

  [[nodiscard]] const RayBoxes& boxes() const { return boxes_; }

  [[nodiscard]] const FirstHitCounts& counts() const { return counts_; }

  [[nodiscard]] std::optional<FirstHit> result() const {
    if (first_.triangle < 0) return std::nullopt;
    return FirstHit{first_.triangle, first_.seen.shows_front};
  }

  /// Takes a triangle into account.
  void Try(int index) {
    const Corners corners(scene_, index);
    std::array<FilteredDirection, 3> spokes;
    for (std::size_t k = 0; k < 3; ++k)
      spokes[k] = FilteredDifference(ray_.origin, corners.at[k]);
    // The three determinants add up to N . d.
    Sign side = Sign::kZero;
    for (std::size_t k = 0; k < 3; ++k) {
      const Sign edge = EdgeSide(corners, spokes[k], k);
      if (edge == Sign::kZero) continue;
      if (side == -edge) return;
      side = edge;
    }
    if (side == Sign::kZero) return;  // the ray lies in a parallel plane
    const FacetId facet = FacetOf(TrianglesOf(scene_)[TriangleId(index)]);
    MetTriangle met{index, {facet, side == Sign::kNegative}, 0, HUGE_VAL};
    const FilteredPlane normal = MakeFilteredPlane(
        FilteredCross(FilteredDifference(corners.at[0], corners.at[1]),
                      FilteredDifference(corners.at[0], corners.at[2])));
    if (HeightSide(normal, spokes[0], corners) != side) return;
    Bound(normal, spokes[0], side, met);
    if (first_.triangle >= 0 && !GoesBeforeFirst(met, corners)) return;
    first_ = met;
    boxes_.EndAt(met.most);
  }

 private:
  /// Sign of det(d, p_k, p_k+1), corners relative to the origin.
  Sign EdgeSide(const Corners& corners, const FilteredDirection& spoke,
                std::size_t k) {
    const Point3& from = corners.at[k];
    const Point3& to = corners.at[k == 2 ? 0 : k + 1];
    const FilteredPlane plane =
        MakeFilteredPlane(FilteredCross(spoke, FilteredDifference(from, to)));
    if (const auto sign = TrySign(FilteredDot(plane, direction_))) {
      ++counts_.side_filter;
      return *sign;
    }
    ++counts_.side_exact;
    return SignOf(Determinant(
        Vec3<Exact>{Exact(ray_.direction.x), Exact(ray_.direction.y),
                    Exact(ray_.direction.z)},
        Displacement<Exact>(ray_.origin, from), Displacement<Exact>(from, to)));
  }

  /// Sign of N . (p - origin).
  Sign HeightSide(const FilteredPlane& normal, const FilteredDirection& spoke,
                  const Corners& corners) {
    if (const auto sign = TrySign(FilteredDot(normal, spoke))) {
      ++counts_.side_filter;
      return *sign;
    }
    ++counts_.side_exact;
    const auto& [a, b, c] = corners.at;
    return SignOf(Determinant(Displacement<Exact>(a, b),
                              Displacement<Exact>(a, c),
                              Displacement<Exact>(ray_.origin, a)));
  }

  /// Bounds on the parameter height / speed, both known up to an error and
  /// positive in truth.
  void Bound(const FilteredPlane& normal, const FilteredDirection& spoke,
             Sign side, MetTriangle& met) const {
    const BoundedValue height = FilteredDot(normal, spoke);
    const BoundedValue speed = FilteredDot(normal, direction_);
    const double sign = side == Sign::kPositive ? 1 : -1;
    const double h = sign * height.value;
    const double s = sign * speed.value;
    // -x is a number from below if x was rounded upwards.
    const double minus_least_height = height.error - h;
    const double minus_least_speed = speed.error - s;
    if (minus_least_speed < 0)
      met.most = (h + height.error) / -minus_least_speed;
    if (minus_least_height < 0)
      met.least = -(minus_least_height / (s + speed.error));
    // Written so that a NaN tells nothing.
    if (!(met.most >= 0)) met.most = HUGE_VAL;
    if (!(met.least >= 0)) met.least = 0;
  }

  bool GoesBeforeFirst(const MetTriangle& met, const Corners& corners) {
    if (met.most < first_.least || first_.most < met.least) {
      ++counts_.order_filter;
      return met.most < first_.least;
    }
    ++counts_.order_exact;
    const ExactParameter a(ray_, corners);
    const ExactParameter b(ray_, Corners(scene_, first_.triangle));
    const Sign order = SignOf(a.height * b.speed - b.height * a.speed);
    if (order != Sign::kZero) return order == Sign::kNegative;
    return std::pair(CoplanarClass(scene_, met.seen), met.triangle) <
           std::pair(CoplanarClass(scene_, first_.seen), first_.triangle);
  }

  const Scene& scene_;
  const Ray& ray_;
  FilteredDirection direction_;
  RayBoxes boxes_;
  MetTriangle first_;
  FirstHitCounts counts_;
};

double LargestComponent(const Vector3& v) {
  return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

using NearVector = Vec3<DoubleDouble>;

/// to - from, exactly.
NearVector NearDisplacement(const Point3& from, const Point3& to) {
  return {TwoSum(to.x, -from.x), TwoSum(to.y, -from.y), TwoSum(to.z, -from.z)};
}

double LargestComponent(const NearVector& v) {
  return std::max(
      {std::fabs(v.x.high), std::fabs(v.y.high), std::fabs(v.z.high)});
}

/// A triangle's normal in about 106 bits of its terms.
struct NearNormal {
  explicit NearNormal(const Corners& corners) {
    const auto& [a, b, c] = corners.at;
    const NearVector u = NearDisplacement(a, b);
    const NearVector v = NearDisplacement(a, c);
    normal = {SumOfProducts(u.y, v.z, -u.z, v.y),
              SumOfProducts(u.z, v.x, -u.x, v.z),
              SumOfProducts(u.x, v.y, -u.y, v.x)};
    terms = LargestComponent(u) * LargestComponent(v);
  }

  /// N . w. Each component of the normal is within 26 u^2 of `terms`, the sum
  /// adds less than 60 u^2: in all less than 2^-97 of terms times |w|.
  [[nodiscard]] DoubleDouble Along(const NearVector& w) const {
    return SumOfProducts(normal.x, w.x, normal.y, w.y, normal.z, w.z);
  }

  NearVector normal;
  double terms;
};

/// Where no number of twice the precision has under- or overflowed.
bool IsInRange(double x) {
  return x > 0x1p-800 && x < 0x1p800;
}

/// The parameter within 2^-79 of itself, mostly far nearer; not known if twice
/// the precision of binary64 does not give it.
std::optional<DoubleDouble> NearParameter(const Ray& ray,
                                          const Corners& corners,
                                          const NearNormal& normal) {
  const NearVector w = NearDisplacement(ray.origin, corners.at[0]);
  const Vector3& d = ray.direction;
  const NearVector direction{{d.x, 0}, {d.y, 0}, {d.z, 0}};
  const DoubleDouble height = normal.Along(w);
  const DoubleDouble speed = normal.Along(direction);
  const double height_terms = normal.terms * LargestComponent(w);
  const double speed_terms = normal.terms * LargestComponent(direction);
  constexpr double kKnown = 0x1p-17;
  if (!IsInRange(normal.terms) || !IsInRange(height_terms) ||
      !IsInRange(speed_terms) ||
      !(std::fabs(height.high) > kKnown * height_terms) ||
      !(std::fabs(speed.high) > kKnown * speed_terms)) {
    return std::nullopt;
  }
  return height / speed;
}

/// o + t d with a t of about 106 bits; not known if too much of it cancels.
std::optional<double> NearCoordinate(double o, const DoubleDouble& t,
                                     double d) {
  const DoubleDouble way = t * d;
  const double sum = (way + o).high;
  // The way is within 2^-78 of itself, so the sum is, before it is rounded,
  // within 2^-58 of itself: a thirtieth of an ulp.
  constexpr double kKnown = 0x1p-20;
  if (!(std::fabs(sum) >= kKnown * std::fabs(way.high))) return std::nullopt;
  return sum;
}

/// Whether the plane of three corners lies across an axis: it then tells the
/// coordinate. a, b, c: those of the corners.
bool IsAcross(double a, double b, double c) {
  return a == b && a == c;
}

/// The point by numbers of twice the precision, if they give it.
std::optional<Point3> NearPointOn(const Ray& ray, const Corners& corners,
                                  const NearNormal& normal) {
  const Point3& o = ray.origin;
  const Vector3& d = ray.direction;
  const auto& [a, b, c] = corners.at;
  const auto t = NearParameter(ray, corners, normal);
  if (!t) return std::nullopt;
  const auto x = IsAcross(a.x, b.x, c.x) ? a.x : NearCoordinate(o.x, *t, d.x);
  if (!x) return std::nullopt;
  const auto y = IsAcross(a.y, b.y, c.y) ? a.y : NearCoordinate(o.y, *t, d.y);
  if (!y) return std::nullopt;
  const auto z = IsAcross(a.z, b.z, c.z) ? a.z : NearCoordinate(o.z, *t, d.z);
  if (!z) return std::nullopt;
  return Point3{*x, *y, *z};
}

Point3 RoundedPointOn(const Ray& ray, const Corners& corners,
                      const NearNormal& normal) {
  if (const auto near = NearPointOn(ray, corners, normal)) return *near;
  const Point3& o = ray.origin;
  const Vector3& d = ray.direction;
  const auto& [a, b, c] = corners.at;
  const ExactParameter exact(ray, corners);
  const mpq_class s = RationalOf(exact.height) / RationalOf(exact.speed);
  const auto on_ray = [&s](double from, double speed) {
    return NearestTo(mpq_class(from) + s * mpq_class(speed));
  };
  return {IsAcross(a.x, b.x, c.x) ? a.x : on_ray(o.x, d.x),
          IsAcross(a.y, b.y, c.y) ? a.y : on_ray(o.y, d.y),
          IsAcross(a.z, b.z, c.z) ? a.z : on_ray(o.z, d.z)};
}

/// Moves a point that is behind a plane by rounding to the side that is seen,
/// along the axis on which a unit in the last place leads farthest.
void LiftFrom(const Corners& corners, const NearNormal& near, bool from_front,
              Point3& point) {
  const auto& [a, b, c] = corners.at;
  const bool is_across_axis = (a.x == b.x && a.x == c.x) ||
                              (a.y == b.y && a.y == c.y) ||
                              (a.z == b.z && a.z == c.z);
  if (is_across_axis) return;  // the point is on the plane exactly
  const NearVector w = NearDisplacement(a, point);
  const double height = near.Along(w).high;
  const double height_terms = near.terms * LargestComponent(w);
  constexpr double kKnown = 0x1p-90;
  if (IsInRange(near.terms) && IsInRange(height_terms) &&
      std::fabs(height) > kKnown * height_terms && (height > 0) == from_front) {
    return;
  }
  const Vec3<Exact> normal =
      Cross(Displacement<Exact>(a, b), Displacement<Exact>(a, c));
  const Sign behind = from_front ? Sign::kNegative : Sign::kPositive;
  const auto is_behind = [&] {
    return SignOf(HeightOver(normal, corners.at[0], point)) == behind;
  };
  if (!is_behind()) return;
  const std::array<double*, 3> coordinates{&point.x, &point.y, &point.z};
  std::size_t axis = 0;
  double farthest = -1;
  double towards = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Sign side = SignOf(Component(normal, static_cast<int>(k)));
    if (side == Sign::kZero) continue;
    const double up = side == behind ? -HUGE_VAL : HUGE_VAL;
    const double step =
        std::fabs(std::nextafter(*coordinates[k], up) - *coordinates[k]) *
        std::fabs(CGAL::to_double(Component(normal, static_cast<int>(k))));
    if (step > farthest) {
      farthest = step;
      axis = k;
      towards = up;
    }
  }
  // Rounding moved it by at most half a unit along each axis.
  for (int i = 0; i < 4 && is_behind(); ++i)
    *coordinates[axis] = std::nextafter(*coordinates[axis], towards);
}

}  // namespace

FirstHitFinder::FirstHitFinder(const Scene& scene)
    : scene_(scene), tree_(scene.vertices(), scene.triangles()) {}

std::optional<FirstHit> FirstHitFinder::Find(const Ray& ray,
                                             FirstHitCounts* counts) const {
  const double size = LargestComponent(ray.direction);
  const Point3& o = ray.origin;
  if (!std::isfinite(o.x) || !std::isfinite(o.y) || !std::isfinite(o.z) ||
      !(size >= 0x1p-500) || !(size <= 0x1p500)) {
    throw std::invalid_argument(
        "a ray's origin is not finite, or its direction is zero or not "
        "between 2^-500 and 2^500");
  }
  const RoundUpward rounding;
  Search search(scene_, ray);
  tree_.Visit(search.boxes(),
              [&search](int triangle) { search.Try(triangle); });
  if (counts != nullptr) {
    counts->side_filter += search.counts().side_filter;
    counts->side_exact += search.counts().side_exact;
    counts->order_filter += search.counts().order_filter;
    counts->order_exact += search.counts().order_exact;
  }
  return search.result();
}

Point3 FirstHitFinder::PointOn(const Ray& ray, const FirstHit& hit) const {
  assert(!IsRoundingUpward());
  const Corners corners(scene_, hit.triangle);
  assert(SignOf(ExactParameter(ray, corners).speed) == Sign::kPositive);
  const NearNormal normal(corners);
  Point3 point = RoundedPointOn(ray, corners, normal);
  LiftFrom(corners, normal, hit.from_front, point);
  return point;
}

}  // namespace truelux
