// SPDX-License-Identifier: GPL-3.0-or-later
#include "truelux/receiver.h"

#include <cstddef>
#include <stdexcept>
#include <string>

namespace truelux {

ReceiverError::ReceiverError(std::size_t index, const std::string& message)
    : std::invalid_argument(message), index_(index) {}

ReceiverError::~ReceiverError() = default;

}  // namespace truelux
