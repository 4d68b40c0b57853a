// SPDX-License-Identifier: GPL-3.0-or-later
// A receiver's view as JSON.

#ifndef TRUELUX_INSPECT_VIEW_JSON_H_
#define TRUELUX_INSPECT_VIEW_JSON_H_

#include <string>

#include "inspect/inspected_view.h"

namespace truelux {

/// One object: scene, receiver, irradiance, sources, regions, arcs, vertices,
/// in this order; docs/inspect.md explains every key. Numbers are the shortest
/// that read back; one that is not finite is null.
std::string ViewJson(const InspectedView& inspected);

}  // namespace truelux

#endif  // TRUELUX_INSPECT_VIEW_JSON_H_
