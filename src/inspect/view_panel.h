// SPDX-License-Identifier: GPL-3.0-or-later
// What stands beside the picture of a view: the receiver, what it receives, a
// legend, the sources.

#ifndef TRUELUX_INSPECT_VIEW_PANEL_H_
#define TRUELUX_INSPECT_VIEW_PANEL_H_

#include <string>

#include "inspect/inspected_view.h"

namespace truelux {

/// The width that the panel takes [px].
inline constexpr double kViewPanelWidth = 372;

/// The height that it needs for all but the sources, and some of them [px].
inline constexpr double kViewPanelHeight = 744;

/// SVG of the panel: its left upper corner, and where it must end [px]. What
/// of the sources has no room is summed up.
std::string ViewPanel(const InspectedView& inspected, ViewProjection projection,
                      PicturePoint corner, double bottom);

}  // namespace truelux

#endif  // TRUELUX_INSPECT_VIEW_PANEL_H_
