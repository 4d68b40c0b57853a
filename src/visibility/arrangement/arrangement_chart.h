// SPDX-License-Identifier: GPL-3.0-or-later
// Four exact projective charts that together show the receiver's hemisphere.
//
// The closed hemisphere n.d >= 0 has no bounded chart, so two planes through
// n cut it into four cones, each bounded by three planes through r. A cone is
// pointed: the sum of its inward wall normals is positive on all of it but r.
// That sum is the chart's depth w, and each cone's image is the triangle
// x >= 0, y >= 0, x + y <= 1. No orthonormal frame is needed, only ring
// operations on the receiver's normal.
//
// Frames
//   world  the scene's, origin moved to r
//   image  [x:y:z:w] homogeneous; (x/w, y/w) tells the direction from r, and
//          z/w = -1 / (depth) orders points along it, smaller is nearer.
//          Planes of the world are planes of the image.

#ifndef TRUELUX_VISIBILITY_ARRANGEMENT_ARRANGEMENT_CHART_H_
#define TRUELUX_VISIBILITY_ARRANGEMENT_ARRANGEMENT_CHART_H_

#include <array>
#include <vector>

#include "truelux/geometry.h"

#include "exact/number.h"
#include "exact/vec3.h"

namespace truelux {

/// The point offset / scale of the world frame; scale > 0.
struct WorldPoint {
  Vec3<Exact> offset;
  Exact scale;
};

/// The point (x/w, y/w, z/w) of the image frame; w > 0.
struct ImagePoint {
  Exact x;
  Exact y;
  Exact z;
  Exact w;
};

/// A direction of the image frame, [x:y:w]; w > 0.
using ImageDirection = Vec3<Exact>;

/// One cone and its chart.
class ViewChart {
 public:
  /// Inward normals of the two cuts; they are orthogonal to the receiver's
  /// normal and not parallel.
  ViewChart(const Vec3<Exact>& receiver_normal, const Vec3<Exact>& cut_a,
            const Vec3<Exact>& cut_b);

  /// The part of a triangle in the closed cone: a convex polygon, in the
  /// triangle's order, no three of its corners on one line; empty if it would
  /// have no area. Requires that the triangle's plane does not contain r.
  [[nodiscard]] std::vector<WorldPoint> Clip(
      const std::array<Vec3<Exact>, 3>& triangle) const;

  /// Requires a point of the closed cone other than r.
  [[nodiscard]] ImagePoint ImageFromWorld(const WorldPoint& point) const;

  /// A positive multiple of the direction. A turn to the left in the image is
  /// one to the right for a viewer at r: det is kept up to a positive factor.
  [[nodiscard]] Vec3<Exact> WorldFromImage(
      const ImageDirection& direction) const;

  /// Whether an image point lies on a wall of the cone: the receiver plane,
  /// or a cut.
  [[nodiscard]] static bool OnHorizon(const ImageDirection& direction);
  [[nodiscard]] static bool OnCutA(const ImageDirection& direction);
  [[nodiscard]] static bool OnCutB(const ImageDirection& direction);

 private:
  // image_from_world: rows x, y (walls), w; the third wall is n = w - x - y.
  Vec3<Exact> row_x_;
  Vec3<Exact> row_y_;
  Vec3<Exact> row_n_;
  Vec3<Exact> row_w_;
  // world_from_image times its determinant, which is positive: its columns.
  Vec3<Exact> column_x_;
  Vec3<Exact> column_y_;
  Vec3<Exact> column_w_;
};

/// The four charts of a receiver's hemisphere. normal: not zero.
std::array<ViewChart, 4> ViewChartsOf(const Vector3& normal);

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_ARRANGEMENT_ARRANGEMENT_CHART_H_
