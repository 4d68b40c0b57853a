// SPDX-License-Identifier: GPL-3.0-or-later
// What regions, arcs and vertices of a view are, in words: as names or of any
// length, for those who point at them.

#ifndef TRUELUX_INSPECT_VIEW_TITLES_H_
#define TRUELUX_INSPECT_VIEW_TITLES_H_

#include <cstddef>
#include <string>

#include "inspect/inspected_view.h"

namespace truelux {

/// "(0.5, -0.25, 1)", 17 digits each.
[[nodiscard]] std::string DigitsOf(const Vector3& v);

/// "source face 12 (line 40, Room/lamp)"; "nothing".
[[nodiscard]] std::string TitleOfRegion(const InspectedView& inspected,
                                        std::size_t region);

/// Its kind, its edge, what is on both sides, its plane, its share of the
/// gradient.
[[nodiscard]] std::string TitleOfArc(const InspectedView& inspected,
                                     std::size_t arc);

/// Its kind, its direction, the scene vertex, and the edges through it, on
/// lines of their own, not more than ten.
[[nodiscard]] std::string TitleOfVertex(const InspectedView& inspected,
                                        std::size_t vertex);

/// V of each channel [W/m^2], 17 digits.
[[nodiscard]] std::string TitleOfVectorIrradiance(
    const InspectedView& inspected);

}  // namespace truelux

#endif  // TRUELUX_INSPECT_VIEW_TITLES_H_
