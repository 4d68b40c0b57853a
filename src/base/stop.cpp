// SPDX-License-Identifier: GPL-3.0-or-later
#include "truelux/stop.h"

namespace truelux {

Stopped::Stopped() : std::runtime_error("stopped on request") {}

Stopped::~Stopped() = default;

}  // namespace truelux
