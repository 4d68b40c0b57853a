// SPDX-License-Identifier: GPL-3.0-or-later
// A receiver's view as a picture.

#ifndef TRUELUX_INSPECT_VIEW_SVG_H_
#define TRUELUX_INSPECT_VIEW_SVG_H_

#include <string>

#include "inspect/inspected_view.h"

namespace truelux {

/// The narrowest picture [px].
inline constexpr int kSmallestViewWidth = 640;

struct ViewPicture {
  ViewProjection projection = ViewProjection::kNusselt;
  int width = 1200;  ///< of the whole picture [px], >= kSmallestViewWidth
};

/// An SVG that stands alone: the view in a disc, and beside it the receiver,
/// what it receives, a legend and the sources. Regions, arcs and vertices have
/// titles, which browsers show under the pointer. docs/inspect.md explains it.
std::string ViewSvg(const InspectedView& inspected, const ViewPicture& picture);

}  // namespace truelux

#endif  // TRUELUX_INSPECT_VIEW_SVG_H_
