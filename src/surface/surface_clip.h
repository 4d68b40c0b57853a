// SPDX-License-Identifier: GPL-3.0-or-later
// What of a straight line lies on a flat surface.

#ifndef TRUELUX_SURFACE_SURFACE_CLIP_H_
#define TRUELUX_SURFACE_SURFACE_CLIP_H_

#include <array>
#include <span>
#include <vector>

#include "truelux/scene.h"

#include "exact/rational.h"
#include "surface/surface_frame.h"

namespace truelux {

/// A segment in the plane of a surface.
struct ExactSegment {
  RationalVector from;
  RationalVector to;
};

/// Cuts lines to faces of a surface, exactly.
class SurfaceClip {
 public:
  /// faces: indices into Scene::faces(), all of them of the surface.
  SurfaceClip(const Scene& scene, const SurfaceFrame& frame,
              std::span<const int> faces);

  /// The parts of a segment that lie on the faces, their outlines included, in
  /// its sense; none of them is a point.
  [[nodiscard]] std::vector<ExactSegment> PartsOf(
      const ExactSegment& segment) const;

  /// The part of a plane's trace in the extent of the faces: normal . p =
  /// offset. None if the plane is parallel to the surface or misses the extent.
  [[nodiscard]] std::vector<ExactSegment> TraceOf(
      const RationalVector& normal, const mpq_class& offset) const;

 private:
  using Coordinates = SurfaceFrame::Coordinates;

  [[nodiscard]] RationalVector PointAt(const Coordinates& at) const;

  const SurfaceFrame& frame_;
  std::vector<std::array<Coordinates, 3>> triangles_;
};

}  // namespace truelux

#endif  // TRUELUX_SURFACE_SURFACE_CLIP_H_
