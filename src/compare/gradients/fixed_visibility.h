// SPDX-License-Identifier: GPL-3.0-or-later
// Gradients of programs that forget how shadows move.

#ifndef TRUELUX_COMPARE_GRADIENTS_FIXED_VISIBILITY_H_
#define TRUELUX_COMPARE_GRADIENTS_FIXED_VISIBILITY_H_

#include <optional>
#include <span>
#include <vector>

#include "truelux/irradiance.h"
#include "truelux/receiver.h"

#include "compare/candidates.h"

namespace truelux {

/// What becomes of the gradient of all channels, one entry per receiver.
struct FixedVisibility {
  /// Every arc of a visible contour moves as if it lay on its source: the
  /// integral over what is visible of the gradient of the integrand.
  std::vector<GradientRow> at_source_depth;
  /// Arcs that do not lie on an edge of their source do not move at all: what
  /// is visible in a direction stays so.
  std::vector<GradientRow> own_edges_only;
};

/// In binary64, from the certified contours; a few 1e-16 of the sum of the
/// arcs' terms. Nothing if a face that emits is not planar: the arcs do not
/// say which of its facets they bound.
[[nodiscard]] std::optional<FixedVisibility> FixedVisibilityOf(
    const Oracle& oracle, std::span<const Receiver> receivers);

}  // namespace truelux

#endif  // TRUELUX_COMPARE_GRADIENTS_FIXED_VISIBILITY_H_
