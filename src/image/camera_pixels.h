// SPDX-License-Identifier: GPL-3.0-or-later
// A picture through a pinhole camera: its pixels are the first faces along
// rays.

#ifndef TRUELUX_IMAGE_CAMERA_PIXELS_H_
#define TRUELUX_IMAGE_CAMERA_PIXELS_H_

#include <optional>
#include <vector>

#include "truelux/geometry.h"
#include "truelux/receiver.h"
#include "truelux/scene.h"

#include "image/camera_frame.h"
#include "image/pixel_receivers.h"
#include "visibility/first_hit.h"

namespace truelux {

/// The receiver of a pixel is on the first face along its ray (FirstHitFinder),
/// at the point where the ray meets that face's plane, rounded; its normal is
/// the face's, turned to the camera, and on_face names the face.
class CameraPixels : public PixelReceivers {
 public:
  CameraPixels(const Scene& scene, const CameraFrame& frame, int width,
               int height);

  [[nodiscard]] std::optional<Receiver> At(int x, int y) const override;

 private:
  Scene scene_;
  CameraFrame frame_;
  FirstHitFinder finder_;
  /// Of all facets; empty if there are more of them than pixels.
  std::vector<Vector3> normals_;
};

}  // namespace truelux

#endif  // TRUELUX_IMAGE_CAMERA_PIXELS_H_
