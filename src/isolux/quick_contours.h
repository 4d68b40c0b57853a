// SPDX-License-Identifier: GPL-3.0-or-later
// Contours for pictures: each vertex certified, but without a proof that none is
// missing.

#ifndef TRUELUX_ISOLUX_QUICK_CONTOURS_H_
#define TRUELUX_ISOLUX_QUICK_CONTOURS_H_

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "truelux/isolux.h"

#include "run/watch.h"

namespace truelux {

/// Contours of a surface, as IsoluxOf has them, found by values at points that
/// are about `spacing` apart near the lines and three times as far elsewhere
/// [length]: what is smaller may be missed. Vertices are certified within a
/// sixteenth of the spacing. Lines end at faces that stand on the surface. Costs
/// as much as so many values, whatever the scene. levels: ascending, above 0.
/// Throws as IsoluxOf does.
std::vector<IsoluxContour> QuickContoursOf(const Oracle& oracle,
                                           const std::string& surface,
                                           std::span<const double> levels,
                                           std::optional<ScalarChannel> channel,
                                           double spacing, int threads,
                                           const Watch& watch);

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_QUICK_CONTOURS_H_
