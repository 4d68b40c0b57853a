// SPDX-License-Identifier: GPL-3.0-or-later
// What is front-most in one chart, as an exact planar map.

#ifndef TRUELUX_VISIBILITY_ARRANGEMENT_ARRANGEMENT_MAP_H_
#define TRUELUX_VISIBILITY_ARRANGEMENT_ARRANGEMENT_MAP_H_

#include <span>
#include <vector>

#include "base/id_vector.h"
#include "base/ids.h"
#include "visibility/arrangement/arrangement_chart.h"
#include "visibility/arrangement/arrangement_types.h"

namespace truelux {

/// Index into ViewMap::vertices.
using MapVertexId = Id<struct MapVertexTag>;
/// Index into ViewMap::edges.
using MapEdgeId = Id<struct MapEdgeTag>;

/// An edge between two parts of the view; from and to are different points.
struct MapEdge {
  MapVertexId from;
  MapVertexId to;
  FacetId left;   ///< seen on the left of from -> to; or none
  FacetId right;  ///< another one, or none
  /// The connected parts of the view on both sides, numbered from 0 in each
  /// map: two edges have the same number where they bound the same part.
  int left_part = -1;
  int right_part = -1;
};

/// What is seen, as far as a chart goes.
enum class MapWalls {
  kOpen,    ///< the chart's walls are edges only where a facet ends there
  kClosed,  ///< the walls are edges all along; outside of them is kOutside
};

/// Stands for a facet beyond the walls of a chart.
inline constexpr FacetId kOutside{-2};

/// The view in one chart. Edges between parts with the same facet are left
/// out.
struct ViewMap {
  IdVector<MapVertexId, ImageDirection> vertices;
  IdVector<MapEdgeId, MapEdge> edges;
  /// The edges that end at each vertex, counter-clockwise in the chart.
  IdVector<MapVertexId, std::vector<MapEdgeId>> edges_around;
  int part_count = 0;
};

/// The map of the front-most facets (the smallest z/w). Where several are at
/// the same place over a region, the one with the smallest index is in front.
/// Triangles of one facet do not overlap.
ViewMap FrontMost(std::span<const ImageTriangle> triangles,
                  MapWalls walls = MapWalls::kOpen);

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_ARRANGEMENT_ARRANGEMENT_MAP_H_
