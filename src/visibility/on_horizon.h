// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a vertex of a visible contour lies on the receiver's horizon.

#ifndef TRUELUX_VISIBILITY_ON_HORIZON_H_
#define TRUELUX_VISIBILITY_ON_HORIZON_H_

#include "truelux/receiver.h"
#include "truelux/scene.h"
#include "truelux/visibility.h"

namespace truelux {

/// Exact: a vertex that is only near the horizon is told apart. vertex: of a
/// visible contour of the receiver in the scene.
[[nodiscard]] bool IsOnHorizon(const Scene& scene, const Receiver& receiver,
                               const ContourVertex& vertex);

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_ON_HORIZON_H_
