// SPDX-License-Identifier: GPL-3.0-or-later
// A point of a contour, with what proves that the contour is there.

#ifndef TRUELUX_ISOLUX_CONTOUR_POINT_H_
#define TRUELUX_ISOLUX_CONTOUR_POINT_H_

#include <functional>

#include "isolux/light_probe.h"
#include "isolux/plan_frame.h"
#include "isolux/plan_mesh.h"

namespace truelux {

/// A vertex of a contour. Its transversal is the segment from at - half_width
/// across to at + half_width across: if it is certified, E is below the level at
/// the first end and above it at the second, so that the contour passes between
/// them.
struct ContourPoint {
  PlanPoint at;
  PlanPoint across;       ///< of length 1, to where E is larger
  double half_width = 0;  ///< [length]
  bool is_certified = false;
  SideKind on = SideKind::kInner;
  int seam = -1;  ///< PlanTriangle::seams of the side that it is on
};

/// Where a level is passed along a segment.
struct LevelCrossing {
  PlanPoint below;  ///< where E is below the level
  PlanPoint above;  ///< where it is not
  LightValue at_below;
  LightValue at_above;
  /// The gradient somewhere near, for the first guess.
  PlanPoint hint_at;
  PlanPoint hint;
  SideKind on = SideKind::kInner;
  int seam = -1;
};

/// Whether a point is in the region that is looked at, beyond which E may jump.
using InRegion = std::function<bool(const PlanPoint&)>;

/// Finds points of contours by Newton's method, kept within brackets.
class ContourPointFinder {
 public:
  /// half_width: of transversals [length].
  ContourPointFinder(const LightProbe& probe, double half_width)
      : probe_(probe), half_width_(half_width) {}

  /// The point of a level on a crossing: its bracket is narrowed along the
  /// segment. The transversal is along the gradient if that keeps it in the
  /// region and the point is inside; else along the segment.
  [[nodiscard]] ContourPoint OnCrossing(const LevelCrossing& crossing,
                                        double level,
                                        const InRegion& in_region) const;

  /// The point of a level near a sample, along its gradient, which changes over
  /// lengths like `scale`. Not certified if it is not found in the region.
  [[nodiscard]] ContourPoint Near(const PlanPoint& at,
                                  const LightSample& sample, double level,
                                  double scale,
                                  const InRegion& in_region) const;

 private:
  [[nodiscard]] double GoodStep(double scale) const;

  /// Lays the transversal along a direction and certifies it.
  bool CertifyAt(ContourPoint& point, const PlanPoint& along, double level,
                 const InRegion& in_region) const;

  /// Asks at both ends of the transversal.
  [[nodiscard]] bool Certify(const ContourPoint& point, double level) const;

  const LightProbe& probe_;
  double half_width_;
};

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_CONTOUR_POINT_H_
