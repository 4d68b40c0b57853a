// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces of facets that a chart shows.

#ifndef TRUELUX_VISIBILITY_ARRANGEMENT_ARRANGEMENT_TYPES_H_
#define TRUELUX_VISIBILITY_ARRANGEMENT_ARRANGEMENT_TYPES_H_

#include <array>

#include "base/ids.h"
#include "visibility/arrangement/arrangement_chart.h"

namespace truelux {

/// A piece of a facet in the image frame of one chart; not degenerate, and
/// not seen edge-on.
struct ImageTriangle {
  std::array<ImagePoint, 3> corners;
  FacetId facet;
  int coplanar_class = 0;  ///< of the facet (scene/coplanar_order.h)
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_ARRANGEMENT_ARRANGEMENT_TYPES_H_
