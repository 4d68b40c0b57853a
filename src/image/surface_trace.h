// SPDX-License-Identifier: GPL-3.0-or-later
// The line in which a plane cuts a pictured surface, over its pixels.

#ifndef TRUELUX_IMAGE_SURFACE_TRACE_H_
#define TRUELUX_IMAGE_SURFACE_TRACE_H_

#include <array>
#include <optional>
#include <vector>

#include <gmpxx.h>

#include "truelux/geometry.h"
#include "truelux/scene.h"

#include "exact/rational.h"
#include "exact/vec3.h"
#include "surface/surface_frame.h"

namespace truelux {

/// The pixels of a surface as exact coordinates: pixel (x, y) has its centre
/// at (x, y), and reaches half a unit to each side.
class PixelPlane {
 public:
  /// frame: of this scene.
  PixelPlane(const Scene& scene, const SurfaceFrame& frame, int width,
             int height);

  [[nodiscard]] int width() const { return width_; }

  [[nodiscard]] int height() const { return height_; }

  /// The point of the surface there, each coordinate rounded once.
  [[nodiscard]] Point3 PointAt(const mpq_class& x, const mpq_class& y) const;

  /// The same in double from the start, off by a few ulps of a pixel.
  [[nodiscard]] Point3 NearPointAt(double x, double y) const;

  /// Whether the surface's faces cover the place. In double: an edge is off by
  /// 1e-9 pixels.
  [[nodiscard]] bool Covers(double x, double y) const;

  /// How many units in the last place of a coordinate a pixel is wide, as a
  /// power of two, about.
  [[nodiscard]] int BitsPerPixel() const { return bits_per_pixel_; }

  /// The height over the plane normal . p = offset, k[0] + k[1] x + k[2] y.
  [[nodiscard]] std::array<mpq_class, 3> HeightOver(
      const RationalVector& normal, const mpq_class& offset) const;

 private:
  using Corner = std::array<double, 2>;

  int width_;
  int height_;
  RationalVector zero_;                 ///< the point at (0, 0)
  RationalVector right_;                ///< a pixel to the right
  RationalVector down_;                 ///< a pixel down
  std::array<Vec3<double>, 3> near_{};  ///< the same three in double
  int bits_per_pixel_ = 0;
  std::vector<std::array<Corner, 3>> triangles_;
};

/// The trace of a plane, at one place in each column, or in each row.
class SurfaceTrace {
 public:
  /// Nothing if the plane is parallel to the surface.
  static std::optional<SurfaceTrace> Of(const PixelPlane& pixels,
                                        const RationalVector& normal,
                                        const mpq_class& offset);

  /// A place of the trace in a pixel.
  struct Step {
    int x = 0;  ///< the pixel
    int y = 0;
    double near_x = 0;  ///< the place on the trace, in double
    double near_y = 0;
  };

  /// The pixels of the picture that the trace meets in the middle of their
  /// columns (rows, if it is steep).
  [[nodiscard]] std::vector<Step> Steps() const;

  /// The place in a step's pixel, moved across the trace by `aside` pixels
  /// along the column (the row).
  struct Place {
    mpq_class x;
    mpq_class y;
  };

  [[nodiscard]] Place At(const Step& step, const mpq_class& aside) const;

 private:
  SurfaceTrace(int width, int height, std::array<mpq_class, 3> height_over);

  int width_;
  int height_;
  bool is_steep_;
  /// Across = start + slope * along.
  mpq_class start_;
  mpq_class slope_;
};

}  // namespace truelux

#endif  // TRUELUX_IMAGE_SURFACE_TRACE_H_
