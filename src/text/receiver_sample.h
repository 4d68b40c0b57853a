// SPDX-License-Identifier: GPL-3.0-or-later
// Some receivers that stand for all of a table.

#ifndef TRUELUX_TEXT_RECEIVER_SAMPLE_H_
#define TRUELUX_TEXT_RECEIVER_SAMPLE_H_

#include <cstddef>
#include <span>
#include <vector>

#include "truelux/receiver.h"

namespace truelux {

/// A few receivers of a long row of them, about evenly spread, whatever the
/// length turns out to be.
class ReceiverSample {
 public:
  static constexpr std::size_t kMost = 16;

  /// Takes the next receiver of the row into account.
  void Take(const Receiver& receiver);

  /// At most kMost of them, in their order; not none, if there were any.
  [[nodiscard]] std::span<const Receiver> kept() const { return kept_; }

 private:
  std::vector<Receiver> kept_;
  std::size_t seen_ = 0;
  std::size_t step_ = 1;  ///< every step_-th is kept
};

}  // namespace truelux

#endif  // TRUELUX_TEXT_RECEIVER_SAMPLE_H_
