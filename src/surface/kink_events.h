// SPDX-License-Identifier: GPL-3.0-or-later
// The places of a trace at which what is seen beside its plane may change.

#ifndef TRUELUX_SURFACE_KINK_EVENTS_H_
#define TRUELUX_SURFACE_KINK_EVENTS_H_

#include <vector>

#include <gmpxx.h>

#include "truelux/stop.h"

#include "surface/plane_cut.h"
#include "surface/strip_arcs.h"

namespace truelux {

/// All t from 0 to 1, ends included, rising and each once, at which the kink at
/// (t, 0) may begin, end or change its causes: where two points of the cut
/// appear in one direction in which that matters, where a line meets the trace,
/// and where contacts end. Between two neighbours nothing changes but sizes.
/// stop: may be null. Throws Stopped.
[[nodiscard]] std::vector<mpq_class> EventsOf(const PlaneCut& cut,
                                              const StripFinder& finder,
                                              const StopFlag* stop);

}  // namespace truelux

#endif  // TRUELUX_SURFACE_KINK_EVENTS_H_
