// SPDX-License-Identifier: GPL-3.0-or-later
// From the arcs that an engine happened to make to those that a reader
// expects: an engine may split an arc anywhere, and may add pairs of equal
// opposite arcs.

#ifndef TRUELUX_VISIBILITY_ARC_CLEANUP_H_
#define TRUELUX_VISIBILITY_ARC_CLEANUP_H_

#include <span>
#include <vector>

#include "truelux/visibility.h"

#include "exact/primitive.h"

namespace truelux {

/// A public arc with the exact normal of its plane, to the visible side.
struct ExactArc {
  ContourArc arc;
  PrimitiveVector plane;
};

/// Takes away what two arcs of one source run through in opposite directions
/// (the cuts between the arrangement's charts, the edges between triangles of
/// a face that is not planar). directions: entry v is that of vertex v.
std::vector<ExactArc> WithoutOppositeArcs(
    const std::vector<ExactArc>& arcs,
    std::span<const PrimitiveVector> directions);

/// Joins two arcs where nothing but they meet and one goes on as the other.
/// Scene vertices stay. vertices: those that the arcs refer to.
std::vector<ExactArc> JoinedArcs(std::vector<ExactArc> arcs,
                                 std::span<const ContourVertex> vertices);

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_ARC_CLEANUP_H_
