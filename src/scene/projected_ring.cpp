// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/projected_ring.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "exact/vec3.h"
#include "scene/newell.h"

namespace truelux {
namespace {

/// A component of the Newell normal whose sign is known not to be zero.
struct NormalAxis {
  int axis = 0;
  Sign sign = Sign::kZero;
};

/// The component farthest from zero, if intervals can tell.
std::optional<NormalAxis> TryNormalAxis(const Vec3<Interval>& normal) {
  std::optional<NormalAxis> best;
  double best_size = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Interval& component = Component(normal, axis);
    const double size = std::max(component.inf(), -component.sup());
    if (size > best_size) {
      best_size = size;
      best = {axis, component.inf() > 0 ? Sign::kPositive : Sign::kNegative};
    }
  }
  return best;
}

/// A component that is not zero; nothing if all are.
std::optional<NormalAxis> ExactNormalAxis(const Vec3<Exact>& normal) {
  for (int axis = 0; axis < 3; ++axis) {
    const Sign sign = SignOf(Component(normal, axis));
    if (sign != Sign::kZero) return NormalAxis{axis, sign};
  }
  return std::nullopt;
}

/// A normal of the plane through the first edge and a point off its line;
/// nothing if all points are on it.
std::optional<Vec3<Exact>> NormalOfCorner(std::span<const Point3> ring) {
  const Vec3<Exact> along = Displacement<Exact>(ring[0], ring[1]);
  for (const Point3& p : ring.subspan(2)) {
    const Vec3<Exact> normal = Cross(along, Displacement<Exact>(ring[0], p));
    if (ExactNormalAxis(normal)) return normal;
  }
  return std::nullopt;
}

bool IsPlanar(std::span<const Point3> ring, const Vec3<Interval>& normal) {
  bool all_known = true;
  for (const Point3& p : ring.subspan(1)) {
    const std::optional<Sign> sign = TrySign(HeightOver(normal, ring[0], p));
    if (sign && *sign != Sign::kZero) return false;
    all_known = all_known && sign;
  }
  if (all_known) return true;
  const auto exact_normal = NewellNormal<Exact>(ring);
  return std::ranges::all_of(ring.subspan(1), [&](const Point3& p) {
    return SignOf(HeightOver(exact_normal, ring[0], p)) == Sign::kZero;
  });
}

/// n_3 (p_axis - o_axis) - n_axis (p_3 - o_3): one axis of the image.
template <class NT>
NT ImageCoordinate(const Vec3<NT>& normal, const Vec3<NT>& point, int axis,
                   int kernel_axis) {
  return Component(normal, kernel_axis) * Component(point, axis) -
         Component(normal, axis) * Component(point, kernel_axis);
}

/// > 0 if c lies to the left of the line from a to b.
template <class NT>
NT Turn(const NT& au, const NT& av, const NT& bu, const NT& bv, const NT& cu,
        const NT& cv) {
  return (bu - au) * (cv - av) - (bv - av) * (cu - au);
}

/// NewellNormal of exact points.
Vec3<Exact> NewellNormalOf(const std::vector<Vec3<Exact>>& ring) {
  Vec3<Exact> normal{Exact(0), Exact(0), Exact(0)};
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    normal = normal + Cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  return normal;
}

constexpr std::size_t Index(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

bool AreOnOneLine(const Point3& a, const Point3& b, const Point3& c) {
  const std::array<Point3, 3> ring{a, b, c};
  return !NormalOfCorner(ring);
}

RingShape ProjectedRing::Project(std::span<const Point3> points,
                                 const RingDisplacement& displacement) {
  const RingShape shape = Project(points);
  if (points.size() == 3 ||
      (shape != RingShape::kPlanar && shape != RingShape::kNotPlanar)) {
    return shape;
  }
  displacement_ = &displacement;
  u_.clear();
  v_.clear();
  const std::vector<Vec3<Exact>> ring = ExactPoints();
  const Vec3<Exact> normal = NewellNormalOf(ring);
  const bool is_planar = std::ranges::all_of(ring, [&](const Vec3<Exact>& p) {
    return SignOf(Dot(normal, p - ring[0])) == Sign::kZero;
  });
  shape_ = is_planar ? RingShape::kPlanar : RingShape::kNotPlanar;
  ComputeImage(NewellNormal<Interval>(points));
  return shape_;
}

/// The points, displaced if they are.
std::vector<Vec3<Exact>> ProjectedRing::ExactPoints() const {
  std::vector<Vec3<Exact>> ring;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Point3& p = points_[i];
    ring.push_back({Exact(p.x), Exact(p.y), Exact(p.z)});
    if (displacement_ != nullptr && displacement_->is_displaced[i])
      ring.back() = ring.back() + displacement_->step;
  }
  return ring;
}

/// What an interval says; nothing if it says zero, but points are displaced.
std::optional<Sign> ProjectedRing::Known(const Interval& x) const {
  const std::optional<Sign> sign = TrySign(x);
  if (displacement_ != nullptr && sign == Sign::kZero) return std::nullopt;
  return sign;
}

RingShape ProjectedRing::Project(std::span<const Point3> points) {
  displacement_ = nullptr;
  points_ = points;
  u_.clear();
  v_.clear();
  exact_.clear();
  const auto normal = NewellNormal<Interval>(points);
  std::optional<NormalAxis> found = TryNormalAxis(normal);
  if (!found) found = ExactNormalAxis(NewellNormal<Exact>(points));
  if (!found) return ProjectFlat();
  if (points.size() == 3) return RingShape::kPlanar;
  axis_ = found->axis;
  mirrored_ = found->sign == Sign::kNegative;
  shape_ =
      IsPlanar(points, normal) ? RingShape::kPlanar : RingShape::kNotPlanar;
  ComputeImage(normal);
  return shape_;
}

/// The same for a ring without a Newell normal.
RingShape ProjectedRing::ProjectFlat() {
  const std::optional<Vec3<Exact>> normal = NormalOfCorner(points_);
  if (!normal) return RingShape::kNoArea;
  const bool flat =
      std::ranges::all_of(points_.subspan(1), [&](const Point3& p) {
        return SignOf(HeightOver(*normal, points_[0], p)) == Sign::kZero;
      });
  if (!flat) return RingShape::kZeroNormal;
  const NormalAxis found = *ExactNormalAxis(*normal);
  axis_ = found.axis;
  mirrored_ = found.sign == Sign::kNegative;
  shape_ = RingShape::kFlat;
  ComputeImage({});
  return shape_;
}

void ProjectedRing::ComputeImage(const Vec3<Interval>& normal) {
  for (const Point3& p : points_) {
    if (shape_ != RingShape::kNotPlanar) {
      u_.emplace_back(Coordinate(p, UAxis()));
      v_.emplace_back(Coordinate(p, VAxis()));
    } else {
      const auto d = Displacement<Interval>(points_[0], p);
      u_.push_back(ImageCoordinate(normal, d, UAxis(), axis_));
      v_.push_back(ImageCoordinate(normal, d, VAxis(), axis_));
    }
  }
}

void ProjectedRing::ComputeExactImage() const {
  const std::vector<Vec3<Exact>> ring = ExactPoints();
  if (shape_ != RingShape::kNotPlanar) {
    for (const Vec3<Exact>& p : ring)
      exact_.push_back({Component(p, UAxis()), Component(p, VAxis())});
    return;
  }
  const Vec3<Exact> normal = NewellNormalOf(ring);
  for (const Vec3<Exact>& p : ring) {
    const Vec3<Exact> d = p - ring[0];
    exact_.push_back({ImageCoordinate(normal, d, UAxis(), axis_),
                      ImageCoordinate(normal, d, VAxis(), axis_)});
  }
}

const ProjectedRing::ExactPoint& ProjectedRing::ExactImage(int i) const {
  if (exact_.empty()) ComputeExactImage();
  return exact_[Index(i)];
}

std::array<double, 2> ProjectedRing::PlanarImage(int i) const {
  assert(shape_ == RingShape::kPlanar || shape_ == RingShape::kFlat);
  return {u_[Index(i)].inf(), v_[Index(i)].inf()};
}

Sign ProjectedRing::Orientation(int i, int j, int k) const {
  const std::optional<Sign> sign =
      Known(Turn(u_[Index(i)], v_[Index(i)], u_[Index(j)], v_[Index(j)],
                 u_[Index(k)], v_[Index(k)]));
  if (sign) return *sign;
  const ExactPoint& a = ExactImage(i);
  const ExactPoint& b = ExactImage(j);
  const ExactPoint& c = ExactImage(k);
  return SignOf(Turn(a.u, a.v, b.u, b.v, c.u, c.v));
}

Sign ProjectedRing::Order(int i, int j) const {
  std::optional<Sign> sign = Known(u_[Index(j)] - u_[Index(i)]);
  if (!sign) sign = SignOf(ExactImage(j).u - ExactImage(i).u);
  if (*sign != Sign::kZero) return *sign;
  sign = Known(v_[Index(j)] - v_[Index(i)]);
  if (!sign) sign = SignOf(ExactImage(j).v - ExactImage(i).v);
  return *sign;
}

Sign ProjectedRing::Rise(int i, int j) const {
  const std::optional<Sign> sign = Known(v_[Index(j)] - v_[Index(i)]);
  return sign ? *sign : SignOf(ExactImage(j).v - ExactImage(i).v);
}

Sign ProjectedRing::MiddleAbove(int i, int j, int k) const {
  const Interval two(2);
  const std::optional<Sign> sign =
      Known(v_[Index(i)] + v_[Index(j)] - two * v_[Index(k)]);
  return sign ? *sign
              : SignOf(ExactImage(i).v + ExactImage(j).v -
                       Exact(2) * ExactImage(k).v);
}

Sign ProjectedRing::MiddleSide(int i, int j, int k, int l) const {
  const Sign k_side = Orientation(i, j, k);
  const Sign l_side = Orientation(i, j, l);
  if (k_side * l_side != Sign::kNegative) {
    return k_side != Sign::kZero ? k_side : l_side;
  }
  // The turn of the middle is half the sum of theirs.
  const ExactPoint& a = ExactImage(i);
  const ExactPoint& b = ExactImage(j);
  const ExactPoint& c = ExactImage(k);
  const ExactPoint& d = ExactImage(l);
  return SignOf(Turn(a.u, a.v, b.u, b.v, c.u, c.v) +
                Turn(a.u, a.v, b.u, b.v, d.u, d.v));
}

bool ProjectedRing::SurelyApart(int i, int j, int k, int l) const {
  // Four comparisons instead of minima: false for NaN.
  const auto before = [&](const std::vector<Interval>& x, int a, int b, int c,
                          int d) {
    return x[Index(a)].sup() < x[Index(c)].inf() &&
           x[Index(a)].sup() < x[Index(d)].inf() &&
           x[Index(b)].sup() < x[Index(c)].inf() &&
           x[Index(b)].sup() < x[Index(d)].inf();
  };
  return before(u_, i, j, k, l) || before(u_, k, l, i, j) ||
         before(v_, i, j, k, l) || before(v_, k, l, i, j);
}

}  // namespace truelux
