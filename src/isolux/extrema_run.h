// SPDX-License-Identifier: GPL-3.0-or-later
// The search for critical points, for whoever watches.

#ifndef TRUELUX_ISOLUX_EXTREMA_RUN_H_
#define TRUELUX_ISOLUX_EXTREMA_RUN_H_

#include <string>

#include "truelux/isolux.h"

#include "run/watch.h"

namespace truelux {

/// ExtremaOf, with the watch in place of the options' hook and the oracle's stop
/// flag.
SurfaceExtrema FindExtrema(const Oracle& oracle, const std::string& surface,
                           const ExtremaOptions& options, const Watch& watch);

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_EXTREMA_RUN_H_
