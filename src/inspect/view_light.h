// SPDX-License-Identifier: GPL-3.0-or-later
// What a view's picture shows of V and of the gradient: arrows, and bands under
// the arcs.

#ifndef TRUELUX_INSPECT_VIEW_LIGHT_H_
#define TRUELUX_INSPECT_VIEW_LIGHT_H_

#include <cstddef>
#include <string>

#include "inspect/inspected_view.h"
#include "inspect/projection.h"

namespace truelux {

/// The colours of the bands: of arcs that carry gradient, and of arcs that work
/// against the others.
inline constexpr const char* kWithGradientColour = "#d6008f";
inline constexpr const char* kAgainstGradientColour = "#0090a8";

/// The width of the band under an arc whose share of the gradient is 1 [px];
/// bands are never wider.
inline constexpr double kWholeGradientWidth = 16;

/// Of the shares of an arc in all channels the one that is largest in absolute
/// value; 0 where none is given.
[[nodiscard]] double LargestShareOf(const ArcGradients& gradients,
                                    std::size_t arc);

/// SVG of bands under the arcs that carry more than a hundredth of the gradient
/// of a channel, as wide as the largest share; "" if there are none.
[[nodiscard]] std::string GradientBands(const InspectedView& inspected,
                                        const ProjectedDisc& disc);

/// SVG of the arrows from the middle of the disc to where V points to: one, or
/// one for each channel where they differ by a pixel; "" without light. Its
/// title has V of all channels. middle: of the disc.
[[nodiscard]] std::string VectorArrows(const InspectedView& inspected,
                                       const ProjectedDisc& disc,
                                       PicturePoint middle);

}  // namespace truelux

#endif  // TRUELUX_INSPECT_VIEW_LIGHT_H_
