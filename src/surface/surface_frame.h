// SPDX-License-Identifier: GPL-3.0-or-later
// The axes and the extent of a flat surface.

#ifndef TRUELUX_SURFACE_SURFACE_FRAME_H_
#define TRUELUX_SURFACE_SURFACE_FRAME_H_

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <gmpxx.h>

#include "truelux/scene.h"

#include "exact/rational.h"

namespace truelux {

/// Coordinates (a, b) on a flat surface: the point origin + a u + b v.
/// Everything is exact.
struct SurfaceFrame {
  std::vector<int> faces;  ///< indices into Scene::faces(); all have area
  RationalVector origin;   ///< the first corner v0 of the first of them
  RationalVector u;        ///< v1 - v0
  RationalVector v;        ///< v_last - v0
  mpq_class a_least;       ///< the least a of any corner
  mpq_class a_most;
  mpq_class b_least;
  mpq_class b_most;
  /// Faces, of the above, whose front is the first one's back.
  std::vector<int> reversed;

  /// The coordinates of a point in the plane.
  struct Coordinates {
    mpq_class a;
    mpq_class b;
  };

  [[nodiscard]] Coordinates Of(const RationalVector& p) const;

  [[nodiscard]] Coordinates Of(const Point3& p) const {
    return Of(RationalOf(p));
  }

  /// How many times as high as wide the extent is, |v| (b_most - b_least) by
  /// |u| (a_most - a_least), in double.
  [[nodiscard]] double HeightByWidth() const;
};

/// The frame of the surface that some faces make. Those without area do not
/// count. Nothing, and the reason in `defect`, if no face has area, if a face
/// is not exactly in the plane of the first one, or if u and v of the first one
/// are parallel. faces: indices into Scene::faces(), ascending.
std::optional<SurfaceFrame> SurfaceFrameOf(const Scene& scene,
                                           std::span<const int> faces,
                                           std::string& defect);

}  // namespace truelux

#endif  // TRUELUX_SURFACE_SURFACE_FRAME_H_
