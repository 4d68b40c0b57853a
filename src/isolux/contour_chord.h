// SPDX-License-Identifier: GPL-3.0-or-later
// How far a contour is from the chord between two of its points, and points in
// between where that is too far.

#ifndef TRUELUX_ISOLUX_CONTOUR_CHORD_H_
#define TRUELUX_ISOLUX_CONTOUR_CHORD_H_

#include <vector>

#include "isolux/contour_point.h"
#include "isolux/light_features.h"
#include "isolux/light_probe.h"
#include "isolux/mesh_search.h"
#include "isolux/plan_frame.h"

namespace truelux {

/// A contour between two points: further points, and for each chord, one more,
/// how far the contour may be from it [length]; +inf: not known.
struct ContourPiece {
  std::vector<ContourPoint> points;
  std::vector<double> widths;
};

/// What is known of the gradient over a convex polygon.
struct ChordRegion {
  std::vector<PlanPoint> corners;
  LightSample sample;
  PlanPoint at;  ///< of the sample, in the polygon
  GradientChange change;
  std::shared_ptr<const Sight> sight;

  /// By how much the gradient may differ from the sample's.
  [[nodiscard]] double Change() const;
};

/// Divides chords.
///
/// Let the gradient differ by less than G from g in a region, and |g| > G. Then
/// in axes along and across g the contour is a graph whose slope is at most
/// s = G / sqrt(|g|^2 - G^2): between two of its points it stays in the
/// parallelogram with sides of that slope. A chord of length d along the axis and
/// slope m is at most d (s^2 - m^2) / (2 s) away.
class ChordDivider {
 public:
  /// longest: the most that a contour may be away from a chord [length].
  ChordDivider(const LightProbe& probe, const LightFeatures& features,
               const ContourPointFinder& finder, double longest)
      : probe_(probe),
        features_(features),
        finder_(finder),
        longest_(longest) {}

  /// Of a contour that runs in the region from `from` to `to`, once.
  [[nodiscard]] ContourPiece Divide(const ChordRegion& region,
                                    const ContourPoint& from,
                                    const ContourPoint& to, double level) const;

 private:
  void Add(const ChordRegion& region, const ContourPoint& from,
           const ContourPoint& to, double level, int depth,
           ContourPiece& piece) const;

  const LightProbe& probe_;
  const LightFeatures& features_;
  const ContourPointFinder& finder_;
  double longest_;
};

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_CONTOUR_CHORD_H_
