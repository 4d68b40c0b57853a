// SPDX-License-Identifier: GPL-3.0-or-later
// A picture of a flat surface: its pixels are points of the surface.

#ifndef TRUELUX_IMAGE_SURFACE_PIXELS_H_
#define TRUELUX_IMAGE_SURFACE_PIXELS_H_

#include <array>
#include <optional>
#include <vector>

#include "truelux/geometry.h"
#include "truelux/raster.h"
#include "truelux/receiver.h"
#include "truelux/scene.h"

#include "exact/double_double.h"
#include "image/pixel_receivers.h"
#include "surface/surface_frame.h"

namespace truelux {

/// Divides the extent of a surface into equal pixels: columns along u, the
/// first at the least a; rows along v, the first at the greatest b. The
/// receiver of a pixel is at its centre, on the face (the earliest of them)
/// that holds the centre, edges included, and looks to the face's front.
class SurfacePixels : public PixelReceivers {
 public:
  /// frame: of this scene. Costs about a microsecond for each row of pixels
  /// that each triangle of the surface meets.
  SurfacePixels(const Scene& scene, const SurfaceFrame& frame, int width,
                int height);

  /// The centre is exact if its coordinates, and those of the column's and of
  /// the row's point on the axes, have few enough digits; otherwise each
  /// coordinate is rounded once, and off by 2^-104 of these besides.
  [[nodiscard]] std::optional<Receiver> At(int x, int y) const override;

  /// Whether all positions are finite; coordinates near the largest binary64
  /// may make them overflow.
  [[nodiscard]] bool IsFinite() const;

 private:
  /// A point or vector in about 106 bits.
  using Place = std::array<DoubleDouble, 3>;

  void Fill(const Scene& scene, const SurfaceFrame& frame, int face);

  std::vector<Place> columns_;  ///< origin + a u of each column's centre
  std::vector<Place> rows_;     ///< b v of each row's centre
  Raster<int> faces_;           ///< numbers from 1; 0: none
  Vector3 normal_;              ///< of the first face
  std::vector<int> reversed_;   ///< faces with the opposite one; ascending
};

}  // namespace truelux

#endif  // TRUELUX_IMAGE_SURFACE_PIXELS_H_
