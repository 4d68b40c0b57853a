// SPDX-License-Identifier: GPL-3.0-or-later
// What a convex blocker hides from all points of a convex part of a surface.
//
// A point x is hidden from r if the ray from r through x meets the blocker: then
// no light comes from r's direction to x, whether the blocker is nearer than x
// or farther. For a fixed x, or for a fixed r, rays from the hull of some points
// meet the blocker's plane in the hull of where those from the points do, if all
// points are on one side of it. So a blocker that is met from every corner of the part, and towards both ends of a
// segment, is met from everywhere towards all of it.

#ifndef TRUELUX_ISOLUX_OCCLUSION_H_
#define TRUELUX_ISOLUX_OCCLUSION_H_

#include <span>
#include <vector>

#include "exact/vec3.h"
#include "isolux/light_features.h"
#include "isolux/plan_frame.h"

namespace truelux {

/// Part of an edge, from <= to.
struct EdgePart {
  double from = 0;
  double to = 1;
};

/// A blocker seen from the corners of a part of the surface.
class Occluder {
 public:
  /// slack: of lengths; what is hidden by less than it counts as seen.
  Occluder(const Blocker& blocker, std::span<const PlanPoint> corners,
           double slack);

  /// Whether it can tell: all corners are on one side of the blocker's plane.
  [[nodiscard]] bool IsUsable() const { return is_usable_; }

  /// The part of a segment, within `part`, that is hidden from all corners;
  /// from > to if there is none.
  [[nodiscard]] EdgePart HiddenOf(const Vec3<double>& a, const Vec3<double>& b,
                                  const EdgePart& part) const;

  /// Whether it hides a point from all corners.
  [[nodiscard]] bool Hides(const Vec3<double>& p) const;

 private:
  /// Directions d with all normal . d > 0 meet the blocker.
  struct Cone {
    Vec3<double> apex;
    std::vector<Vec3<double>> normals;  ///< of length 1
  };

  double slack_;
  bool is_usable_ = true;
  std::vector<Cone> cones_;
};

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_OCCLUSION_H_
