// SPDX-License-Identifier: GPL-3.0-or-later
// What each arc of a view carries of the gradient of irradiance.

#ifndef TRUELUX_INSPECT_ARC_GRADIENTS_H_
#define TRUELUX_INSPECT_ARC_GRADIENTS_H_

#include <array>
#include <vector>

#include "truelux/derivatives.h"
#include "truelux/geometry.h"
#include "truelux/irradiance.h"
#include "truelux/receiver.h"
#include "truelux/scene.h"

#include "visibility/view/whole_view.h"

namespace truelux {

/// Whether the arcs of a view have shares of the gradient of a channel.
enum class GradientShares {
  kGiven,
  kNoGradient,     ///< the gradient is exactly 0
  kDoNotAddUp,     ///< the arcs miss the gradient by more than kShareError
  kKink,           ///< there is more than one gradient
  kDiscontinuous,  ///< there is none
};

/// The shares of a channel add up to 1 within this, or none are given.
inline constexpr double kShareError = 1e-6;

/// What one arc adds to the gradient dE/dr with the normal fixed.
struct ArcGradient {
  /// Per channel [W/m^3]; along the normal of the arc's plane.
  std::array<Vector3, 3> vector{};
  /// Per channel: vector . g / g.g, with the certified gradient g. Less than 0
  /// if the arc works against the others. Without meaning unless the channel's
  /// shares are given.
  Rgb share{};
};

/// Of all arcs of a view.
struct ArcGradients {
  std::array<GradientShares, 3> shares{};  ///< per channel
  /// In the order of WholeView::arcs; empty at kinks and discontinuities, where
  /// what an arc carries depends on the side to which the receiver moves.
  std::vector<ArcGradient> arcs;

  /// The length of an arc's vector in a channel [W/m^3].
  [[nodiscard]] double LengthOf(std::size_t arc, std::size_t channel) const;
};

/// The terms of docs/derivatives.md (3) in the form (6), one for each arc: what
/// lies to its left counts with its exitance, what lies to its right with that
/// times -1. In double: of each vector the absolute error is some 1e-15 M / d,
/// M the larger exitance beside the arc and d the distance of its line, and
/// 1e-16 times the distance of the edge's nearer end by d, relatively.
/// derivatives: of the receiver in the scene.
ArcGradients ArcGradientsOf(const Scene& scene, const Receiver& receiver,
                            Emission emission, const WholeView& view,
                            const Derivatives& derivatives);

}  // namespace truelux

#endif  // TRUELUX_INSPECT_ARC_GRADIENTS_H_
