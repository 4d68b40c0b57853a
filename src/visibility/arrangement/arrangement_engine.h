// The twin: the whole view as an exact lower envelope (docs/method.md).

#ifndef TRUELUX_VISIBILITY_ARRANGEMENT_ARRANGEMENT_ENGINE_H_
#define TRUELUX_VISIBILITY_ARRANGEMENT_ARRANGEMENT_ENGINE_H_

#include "visibility/contour.h"

namespace truelux {

/// The visible contours of the query's sources, found without any of the
/// contour engine's code. Slow. Planes and directions are explicit.
Contour ContourByArrangement(const ContourQuery& query);

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_ARRANGEMENT_ARRANGEMENT_ENGINE_H_
