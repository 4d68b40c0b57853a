// SPDX-License-Identifier: GPL-3.0-or-later
// Why receivers get nothing although faces emit.

#ifndef TRUELUX_EXPLAIN_DARKNESS_H_
#define TRUELUX_EXPLAIN_DARKNESS_H_

#include <cstddef>
#include <span>
#include <string>

#include "truelux/receiver.h"
#include "truelux/scene.h"

namespace truelux {

/// What becomes of the emitters of a scene at receivers that get nothing. Each
/// emitter counts once, by the best that any of the receivers has of it.
struct Darkness {
  std::size_t emitters = 0;       ///< all of the following
  std::size_t edge_on = 0;        ///< in a plane with the receiver, or ignored
  std::size_t backs = 0;          ///< the receiver is behind them
  std::size_t below_horizon = 0;  ///< they show their front, but lie below
  std::size_t hidden = 0;  ///< they would be seen, but for what is before
};

/// Decided exactly. receivers: a few, of which none sees light.
[[nodiscard]] Darkness DarknessOf(const Scene& scene,
                                  std::span<const Receiver> receivers);

/// One sentence about why everything is 0; "" if nothing emits.
[[nodiscard]] std::string DarknessText(const Darkness& darkness);

}  // namespace truelux

#endif  // TRUELUX_EXPLAIN_DARKNESS_H_
