// SPDX-License-Identifier: GPL-3.0-or-later
// A ring of points, exactly: its normal, its shape, and its image along the
// normal. Every sign is decided by interval arithmetic or, where that cannot
// tell, by exact numbers.

#ifndef TRUELUX_SCENE_PROJECTED_RING_H_
#define TRUELUX_SCENE_PROJECTED_RING_H_

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "truelux/geometry.h"

#include "exact/number.h"
#include "exact/sign.h"
#include "exact/vec3.h"

namespace truelux {

/// What a closed ring of points is in space.
enum class RingShape {
  kNoArea,      ///< all points on one line
  kFlat,        ///< in one plane, but the Newell normal is zero
  kZeroNormal,  ///< not in one plane, and the Newell normal is zero
  kPlanar,      ///< all points in one plane
  kNotPlanar,
};

/// Whether three points lie on one line (two that are equal included).
bool AreOnOneLine(const Point3& a, const Point3& b, const Point3& c);

/// Points of a ring that are displaced by an infinitesimal step
/// (exact/displacement.h).
struct RingDisplacement {
  std::vector<bool> is_displaced;  ///< per point
  Vec3<Exact> step;
};

/// A ring projected along its Newell normal, the vector area (doubled) that
/// does not depend on a choice of triangles: sum of (p_i - p_0) x
/// (p_(i+1) - p_0). Seen so, its enclosed area is positive.
///
/// The image has the axes (u, v) = (p_1 - p_3 n_1 / n_3, p_2 - p_3 n_2 / n_3)
/// times n_3, where n_3 is a component of the normal n that is not zero and
/// the indices follow it cyclically: a linear map whose kernel is n. u and v
/// change places if n_3 < 0. In a planar ring u, v are the coordinates p_1,
/// p_2 themselves, whose orientation is the same.
///
/// All members require a RoundUpward object in the calling thread.
class ProjectedRing {
 public:
  /// Takes n >= 3 points, finite, no two consecutive ones equal (cyclically),
  /// which must outlive the use. The members below may be called if the shape
  /// is kPlanar, kNotPlanar or kFlat; not needed for three points, and not
  /// ready. Of kFlat, the image is along either normal of the plane.
  RingShape Project(std::span<const Point3> points);

  /// The same for a ring of which some points are displaced; `displacement`
  /// must outlive the use, too. Not for PlanarImage.
  RingShape Project(std::span<const Point3> points,
                    const RingDisplacement& displacement);

  [[nodiscard]] int size() const { return static_cast<int>(u_.size()); }

  /// The image of a point, exactly. Only if the shape is kPlanar or kFlat.
  [[nodiscard]] std::array<double, 2> PlanarImage(int i) const;

  /// kPositive if i, j, k turn counter-clockwise. i, j, k  indices of points.
  [[nodiscard]] Sign Orientation(int i, int j, int k) const;

  /// The order of points along any line of the image: kPositive if j comes
  /// after i, kZero if their images coincide.
  [[nodiscard]] Sign Order(int i, int j) const;

  /// The order of points by v: kPositive if j lies above i.
  [[nodiscard]] Sign Rise(int i, int j) const;

  /// The order of the middle between i and j and of point k by v: kPositive if
  /// the middle lies above k.
  [[nodiscard]] Sign MiddleAbove(int i, int j, int k) const;

  /// kPositive if the middle between k and l lies to the left of the line from
  /// i to j.
  [[nodiscard]] Sign MiddleSide(int i, int j, int k, int l) const;

  /// True only if the segments ij and kl have disjoint bounding boxes.
  [[nodiscard]] bool SurelyApart(int i, int j, int k, int l) const;

 private:
  struct ExactPoint {
    Exact u;
    Exact v;
  };

  [[nodiscard]] int UAxis() const { return (axis_ + (mirrored_ ? 2 : 1)) % 3; }

  [[nodiscard]] int VAxis() const { return (axis_ + (mirrored_ ? 1 : 2)) % 3; }

  RingShape ProjectFlat();
  [[nodiscard]] std::vector<Vec3<Exact>> ExactPoints() const;
  [[nodiscard]] std::optional<Sign> Known(const Interval& x) const;
  void ComputeImage(const Vec3<Interval>& normal);
  void ComputeExactImage() const;
  [[nodiscard]] const ExactPoint& ExactImage(int i) const;

  std::span<const Point3> points_;
  const RingDisplacement* displacement_ = nullptr;
  RingShape shape_ = RingShape::kNoArea;
  int axis_ = 0;           ///< the component n_3
  bool mirrored_ = false;  ///< n_3 < 0
  std::vector<Interval> u_;
  std::vector<Interval> v_;
  mutable std::vector<ExactPoint> exact_;  ///< empty until first needed
};

}  // namespace truelux

#endif  // TRUELUX_SCENE_PROJECTED_RING_H_
