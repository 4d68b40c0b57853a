// From an engine's contour to the public one: vertices told apart exactly and
// classified.

#ifndef TRUELUX_VISIBILITY_VISIBLE_CONTOUR_H_
#define TRUELUX_VISIBILITY_VISIBLE_CONTOUR_H_

#include "truelux/visibility.h"

#include "visibility/contour.h"

namespace truelux {

/// The contour as plain data. Ends that point the same way become one vertex;
/// a vertex is classified by every edge and scene vertex that could show
/// there: those of the source and of what lies in front of its plane, without
/// the inner edges of faces and of blocking meshes. Costs arcs times edges;
/// meant for looking, not for the inner loop.
VisibleContour DescribeContour(const ContourQuery& query,
                               const Contour& contour);

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_VISIBLE_CONTOUR_H_
