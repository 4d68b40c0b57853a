// SPDX-License-Identifier: GPL-3.0-or-later
// How a receiver lies to a triangle that is near it, exactly.
//
//   r   the receiver's position      n   its normal
//   m   (b - a) x (c - a), the normal of the triangle abc on its front
//   w   m . (r - a): |w| / |m| is the distance of r to the plane
//   t   what counts as near

#ifndef TRUELUX_SCENE_NEAR_TRIANGLE_H_
#define TRUELUX_SCENE_NEAR_TRIANGLE_H_

#include <array>
#include <cstddef>
#include <optional>

#include "truelux/geometry.h"
#include "truelux/receiver.h"

#include "exact/number.h"
#include "exact/sign.h"

namespace truelux {

/// How the front of a triangle is turned to a receiver's normal.
enum class Turn {
  kAlike,     ///< n . m >= |n| |m| / 2: by at most 60 degrees
  kSameSide,  ///< n . m > 0, by more
  kOpposite,  ///< n . m < 0
  kAcross,    ///< n . m = 0
};

/// A distance t = plain + 2^-22 coordinate + 2^-20 (high - low), kept in its
/// parts so that it is exact. All are finite, coordinate and plain >= 0.
struct NearLimit {
  double plain = 0;
  double coordinate = 0;
  double low = 0;
  double high = 0;

  template <class NT>
  [[nodiscard]] NT In() const {
    return NT(plain) + NT(0x1p-22) * NT(coordinate) +
           NT(0x1p-20) * (NT(high) - NT(low));
  }
};

/// A triangle and a receiver. Every answer is exact: by intervals or, where
/// they cannot tell, by exact numbers. The members require a RoundUpward
/// object in the calling thread.
class NearTriangle {
 public:
  /// corners: finite, not on one line. receiver: finite, its normal not zero;
  /// must outlive the object.
  NearTriangle(const std::array<Point3, 3>& corners, const Receiver& receiver)
      : corners_(corners), receiver_(receiver) {}

  [[nodiscard]] Turn TurnOf() const;

  /// Whether r is at most t away from the plane.
  [[nodiscard]] bool IsPlaneWithin(const NearLimit& limit) const;

  /// Whether the foot of the perpendicular from r to the plane lies in the
  /// triangle or is at most t away from it.
  [[nodiscard]] bool IsFootWithin(const NearLimit& limit) const;

  /// Whether the plane lies above r, on the side that n points to: (n . m) w
  /// < 0.
  [[nodiscard]] bool HasReceiverBehind() const;

  /// The sign of the distance to this plane less that to another one. Both
  /// triangles have the same receiver.
  [[nodiscard]] Sign ComparePlanes(const NearTriangle& other) const;

  /// The sign of the distance to this triangle less that to another one.
  [[nodiscard]] Sign CompareDistances(const NearTriangle& other) const;

  /// Whether r is at most so far away from the triangle. Finite, >= 0.
  [[nodiscard]] bool IsWithin(double distance) const;

  /// The distance to the plane and the one to the triangle, within a few ulps.
  [[nodiscard]] double PlaneDistance() const;
  [[nodiscard]] double Distance() const;

 private:
  /// What of a triangle is nearest to a point.
  enum class Part { kInside, kEdge, kCorner };

  struct Nearest {
    Part part = Part::kInside;
    std::size_t index = 0;  ///< of the corner, or where the edge starts
  };

  /// A number >= 0 as a quotient.
  template <class NT>
  struct Quotient {
    NT above;
    NT below;  ///< > 0
  };

  template <class NT>
  struct Plane;
  template <class NT>
  struct Edge;

  [[nodiscard]] const Nearest& NearestPart() const;
  [[nodiscard]] Nearest FindNearest() const;
  [[nodiscard]] static double RootOf(const Quotient<Exact>& square);
  template <class NT>
  [[nodiscard]] Plane<NT> PlaneIn() const;
  template <class NT>
  [[nodiscard]] Edge<NT> EdgeIn(std::size_t start) const;
  template <class NT>
  [[nodiscard]] Quotient<NT> SquaredPlaneDistance() const;
  template <class NT>
  [[nodiscard]] Quotient<NT> SquaredDistance() const;

  std::array<Point3, 3> corners_;
  const Receiver& receiver_;
  mutable std::optional<Nearest> nearest_;  ///< nothing until it is needed
};

}  // namespace truelux

#endif  // TRUELUX_SCENE_NEAR_TRIANGLE_H_
