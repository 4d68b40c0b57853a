// SPDX-License-Identifier: GPL-3.0-or-later
// Making a cut simple: parts of facets in one piece, and where lines cross.

#ifndef TRUELUX_SURFACE_CUT_MERGE_H_
#define TRUELUX_SURFACE_CUT_MERGE_H_

#include "truelux/scene.h"

#include "surface/plane_cut.h"

namespace truelux {

/// Joins the parts of one facet on one line that meet in a point. Triangles on both sides of a line in
/// P, which is inside of their facet then, become one part that P crosses.
void MergeFacets(PlaneCut& cut);

/// Drops the points that nothing uses.
void DropPoints(PlaneCut& cut);

/// Says which parts of facets and which flat triangles are lights, and at which
/// parts strips may differ. Requires merged facets.
void MarkParts(const Scene& scene, PlaneCut& cut);

/// Adds the points above the trace in which parts of facets or sides of flat
/// triangles cross.
void AddCrossings(PlaneCut& cut);

}  // namespace truelux

#endif  // TRUELUX_SURFACE_CUT_MERGE_H_
