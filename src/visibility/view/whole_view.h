// SPDX-License-Identifier: GPL-3.0-or-later
// The whole view of a receiver, found by the arrangement engine.

#ifndef TRUELUX_VISIBILITY_VIEW_WHOLE_VIEW_H_
#define TRUELUX_VISIBILITY_VIEW_WHOLE_VIEW_H_

#include <functional>

#include "visibility/contour.h"
#include "visibility/view/view_data.h"

namespace truelux {

/// The view of the query's receiver. Faces that the receiver ignores are not
/// there. Slow: see the arrangement engine. on_step is called with the number of
/// steps done, 0 to kWholeViewSteps - 1; what it throws ends it.
WholeView WholeViewOf(const ContourQuery& query,
                      const std::function<void(int)>& on_step = {});

inline constexpr int kWholeViewSteps = 5;

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_VIEW_WHOLE_VIEW_H_
