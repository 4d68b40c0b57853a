// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the gradient of irradiance, or the irradiance, jumps on the way that a
// difference takes.

#ifndef TRUELUX_COMPARE_GRADIENTS_KINK_CROSSING_H_
#define TRUELUX_COMPARE_GRADIENTS_KINK_CROSSING_H_

#include <cstddef>
#include <span>
#include <vector>

#include "truelux/receiver.h"

#include "compare/gradients/gradient_trial.h"

namespace truelux {

/// A straight way of a receiver.
struct Way {
  Receiver from;
  Receiver to;
};

enum class WayCrossing {
  kNothing,
  kKink,  ///< the gradient jumps
  kFace,  ///< the irradiance does
};

/// What is on each way, by certified values: the half is kept of which the ends
/// differ more, thirty times over; what then still differs by a thousandth of
/// the gradient, or of the irradiance, jumps. One jump a way is found; a way with
/// several, or with a jump that is smaller than what changes steadily elsewhere
/// on it, may pass for one with none.
[[nodiscard]] std::vector<WayCrossing> CrossingsOn(const GradientTrial& trial,
                                                   std::span<const Way> ways);

}  // namespace truelux

#endif  // TRUELUX_COMPARE_GRADIENTS_KINK_CROSSING_H_
