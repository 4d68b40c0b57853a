// SPDX-License-Identifier: GPL-3.0-or-later
// Looking at a flag that asks a call to end.

#ifndef TRUELUX_BASE_STOP_H_
#define TRUELUX_BASE_STOP_H_

#include "truelux/stop.h"

namespace truelux {

/// Throws Stopped if there is a flag and it is set. Costs a load that no other
/// thread disturbs; for loops whose steps take a microsecond or more.
inline void StopIfAsked(const StopFlag* stop) {
  if (stop != nullptr && stop->load(std::memory_order_relaxed)) throw Stopped();
}

}  // namespace truelux

#endif  // TRUELUX_BASE_STOP_H_
