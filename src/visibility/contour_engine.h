// The default engine: visible contours by walking edges (docs/method.md).

#ifndef TRUELUX_VISIBILITY_CONTOUR_ENGINE_H_
#define TRUELUX_VISIBILITY_CONTOUR_ENGINE_H_

#include "visibility/contour.h"

namespace truelux {

/// The visible contours of the query's sources. Every decision is exact.
Contour ContourByEdges(const ContourQuery& query);

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_CONTOUR_ENGINE_H_
