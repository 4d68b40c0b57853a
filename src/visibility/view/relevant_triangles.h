// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles whose edges count in a view.

#ifndef TRUELUX_VISIBILITY_VIEW_RELEVANT_TRIANGLES_H_
#define TRUELUX_VISIBILITY_VIEW_RELEVANT_TRIANGLES_H_

#include <vector>

#include "base/ids.h"
#include "visibility/contour.h"
#include "visibility/view/facet_front.h"

namespace truelux {

/// The triangles that take part in a query's view: all but those of ignored
/// facets and those whose plane holds the receiver. Ascending.
std::vector<TriangleId> RelevantTriangles(const ContourQuery& query);

/// Triangles farther than this from a source are left out [rad]. No vertex of
/// the source's contour has an edge of those.
inline constexpr double kBesideSource = 0.01;

/// Those among them that matter for what is visible of one source: its own,
/// and those that can hide some of it, without the ones that are more than
/// kBesideSource away from every direction to the source. source: its front;
/// its facet takes part in the view.
std::vector<TriangleId> TrianglesOfSource(const ContourQuery& query,
                                          const FacetFront& source);

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_VIEW_RELEVANT_TRIANGLES_H_
