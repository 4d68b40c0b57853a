// SPDX-License-Identifier: GPL-3.0-or-later
// The orthonormal frame of a receiver, at a working precision.

#ifndef TRUELUX_RADIOMETRY_RECEIVER_FRAME_H_
#define TRUELUX_RADIOMETRY_RECEIVER_FRAME_H_

#include "truelux/geometry.h"

#include "exact/multiprecision.h"
#include "exact/vec3.h"

namespace truelux {

/// A receiver's normal n as a working vector, times a power of two, exactly;
/// n is not zero.
template <class W>
Vec3<W> ScaledNormal(const Vector3& normal);

/// The frame (u, v, n): orthonormal and right-handed, n the receiver's normal.
/// If n is +- an axis of the scene, u and v are axes, too, and nothing is
/// rounded. W: Ball<DoubleDouble> or Multiprecision.
template <class W>
class ReceiverFrame {
 public:
  /// precision [bits]: of Multiprecision; not looked at otherwise.
  ReceiverFrame(const Vector3& normal, mpfr_prec_t precision);

  /// Takes a vector of the scene's axes to the frame.
  [[nodiscard]] Vec3<W> FromScene(const Vec3<W>& v) const;

 private:
  int axis_ = -1;               ///< n is +- this axis; -1: n is no axis
  bool negative_axis_ = false;  ///< the axis' opposite
  Vec3<W> u_;
  Vec3<W> v_;
  Vec3<W> n_;
};

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_RECEIVER_FRAME_H_
