// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of truelux/isolux.h, for whoever watches.

#ifndef TRUELUX_ISOLUX_ISOLUX_RUN_H_
#define TRUELUX_ISOLUX_ISOLUX_RUN_H_

#include <span>
#include <string>
#include <vector>

#include "truelux/isolux.h"

#include "isolux/contour_lines.h"
#include "isolux/plan_frame.h"
#include "isolux/prepared_surface.h"
#include "run/watch.h"

namespace truelux {

/// SurfaceLinesOf and IsoluxOf, with the watch in place of the options' hook and
/// the oracle's stop flag.
SurfaceLines FindSurfaceLines(const Oracle& oracle, const std::string& surface,
                              const Watch& watch);
Isolux FindIsolux(const Oracle& oracle, const std::string& surface,
                  const IsoluxOptions& options, const Watch& watch);

/// A contour in the scene's frame.
IsoluxContour ContourOf(const PlanFrame& plan, const ContourLine& line,
                        std::span<const double> levels);

/// A surface and its contours, for who goes on from there.
struct TracedSurface {
  PreparedSurface prepared;
  /// For each side: its contours, as in `isolux`, on its plan.
  std::vector<std::vector<ContourLine>> lines;
  Isolux isolux;
};

/// FindIsolux with what it knew.
TracedSurface TraceSurface(const Oracle& oracle, const std::string& surface,
                           const IsoluxOptions& options, const Watch& watch);

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_ISOLUX_RUN_H_
