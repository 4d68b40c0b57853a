// SPDX-License-Identifier: GPL-3.0-or-later
#include "image/camera_frame.h"

#include <cmath>

#include <mpfr.h>

#include "exact/multiprecision.h"
#include "exact/number.h"
#include "exact/primitive.h"
#include "exact/vec3.h"
#include "scene/newell.h"

namespace truelux {
namespace {

/// Of length 1 up to rounding. v: not zero.
Vector3 UnitOf(const Vec3<Exact>& v) {
  // Of largest component 1, whatever the size of v.
  const Vector3 d = ToDouble(MakePrimitive(v));
  const double length = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
  return {d.x / length, d.y / length, d.z / length};
}

Vector3 CrossOf(const Vector3& a, const Vector3& b) {
  const Vec3<double> c =
      Cross(Vec3<double>{a.x, a.y, a.z}, Vec3<double>{b.x, b.y, b.z});
  return {c.x, c.y, c.z};
}

/// The tangent of half an angle [degrees], the nearest binary64 but for a
/// chance of 2^-70: 1 for a right angle, and the same on every platform.
double TangentOfHalf(double degrees) {
  constexpr int kPrecision = 128;
  constexpr unsigned long kHalfTurn = 180;
  Multiprecision angle = PiOf(kPrecision) * Multiprecision(kPrecision, degrees);
  mpfr_div_ui(angle.get(), angle.get(), 2 * kHalfTurn, MPFR_RNDN);
  mpfr_tan(angle.get(), angle.get(), MPFR_RNDN);
  return angle.ToDouble();
}

}  // namespace

Vector3 CameraFrame::DirectionThrough(int x, int y, int width,
                                      int height) const {
  const double along = height;
  const double across = (2.0 * x + 1 - width) * half_height;
  const double above = (height - 1 - 2.0 * y) * half_height;
  const auto component = [&](double f, double r, double u) {
    return along * f + across * r + above * u;
  };
  return {component(forward.x, right.x, up.x),
          component(forward.y, right.y, up.y),
          component(forward.z, right.z, up.z)};
}

std::optional<CameraFrame> CameraFrameOf(const Camera& camera,
                                         std::string& defect) {
  const Vec3<Exact> forward = Displacement<Exact>(camera.eye, camera.target);
  if (IsZero(forward)) {
    defect = "the eye and the target are the same point";
    return std::nullopt;
  }
  const Vec3<Exact> up{Exact(camera.up.x), Exact(camera.up.y),
                       Exact(camera.up.z)};
  if (IsZero(up)) {
    defect = "the up vector is zero";
    return std::nullopt;
  }
  const Vec3<Exact> right = Cross(forward, up);
  if (IsZero(right)) {
    defect = "the up vector is parallel to the line of sight";
    return std::nullopt;
  }
  constexpr double kHalfTurn = 180;
  if (!(camera.fov > 0) || !(camera.fov < kHalfTurn)) {
    defect = "the field of view is not between 0 and 180 degrees";
    return std::nullopt;
  }
  CameraFrame frame;
  frame.eye = camera.eye;
  frame.forward = UnitOf(forward);
  frame.right = UnitOf(right);
  frame.up = CrossOf(frame.right, frame.forward);
  frame.half_height = TangentOfHalf(camera.fov);
  return frame;
}

}  // namespace truelux
