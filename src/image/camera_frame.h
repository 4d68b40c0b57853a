// SPDX-License-Identifier: GPL-3.0-or-later
// A pinhole camera: which ray belongs to which place of the picture.

#ifndef TRUELUX_IMAGE_CAMERA_FRAME_H_
#define TRUELUX_IMAGE_CAMERA_FRAME_H_

#include <optional>
#include <string>

#include "truelux/geometry.h"
#include "truelux/render.h"

namespace truelux {

/// The axes of a camera, orthogonal and of length 1 up to rounding.
struct CameraFrame {
  Point3 eye;
  Vector3 forward;
  Vector3 right;
  Vector3 up;
  double half_height = 0;  ///< of the picture at distance 1: tan(fov / 2)

  /// The direction through the centre of a pixel, not normalised:
  /// height forward + (2x + 1 - width) half_height right
  ///                + (height - 1 - 2y) half_height up,
  /// in double, from the left. Columns at equal distances from the middle have
  /// opposite shares of `right`, to the last bit, and so have rows of `up`.
  [[nodiscard]] Vector3 DirectionThrough(int x, int y, int width,
                                         int height) const;
};

/// Nothing, and the reason in `defect`, if the camera cannot see: eye and
/// target are the same point, up is zero or parallel to the line of sight (both
/// decided exactly), fov is not between 0 and 180. All numbers finite.
std::optional<CameraFrame> CameraFrameOf(const Camera& camera,
                                         std::string& defect);

}  // namespace truelux

#endif  // TRUELUX_IMAGE_CAMERA_FRAME_H_
