// SPDX-License-Identifier: GPL-3.0-or-later
// The contours of a level, point by point.

#ifndef TRUELUX_ISOLUX_CONTOUR_LINES_H_
#define TRUELUX_ISOLUX_CONTOUR_LINES_H_

#include <cstdint>
#include <span>
#include <vector>

#include "isolux/contour_point.h"
#include "isolux/light_features.h"
#include "isolux/light_probe.h"
#include "isolux/mesh_search.h"
#include "run/watch.h"

namespace truelux {

/// A line on which E has a level, with what is larger on its left.
struct ContourLine {
  std::size_t level = 0;  ///< index into the levels
  bool is_closed = false;
  std::vector<ContourPoint> points;
  /// How far the contour may be from the chord that begins at each point, and
  /// of a closed line from that which ends it; +inf: not known.
  std::vector<double> widths;
};

/// What lines cost and how good they are to be.
struct ContourWishes {
  double half_width = 0;  ///< of transversals [length]
  double chord = 0;  ///< most distance of a contour from its chord [length]
};

/// The contours that a settled search has found. search: after Settle.
/// The result does not depend on threads. Throws Stopped.
std::vector<ContourLine> ContourLinesOf(const LightProbe& probe,
                                        const LightFeatures& features,
                                        const MeshSearch& search,
                                        std::span<const double> levels,
                                        const ContourWishes& wishes,
                                        int threads, const Watch& watch);

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_CONTOUR_LINES_H_
