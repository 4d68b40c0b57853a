// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/receiver_sample.h"

namespace truelux {

void ReceiverSample::Take(const Receiver& receiver) {
  if (seen_ % step_ == 0 && kept_.size() == kMost) {
    for (std::size_t i = 0; 2 * i < kMost; ++i)
      kept_[i] = kept_[2 * i];
    kept_.resize(kMost / 2);
    step_ *= 2;
  }
  if (seen_ % step_ == 0) kept_.push_back(receiver);
  ++seen_;
}

}  // namespace truelux
