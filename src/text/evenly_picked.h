// SPDX-License-Identifier: GPL-3.0-or-later
// Some of many, spread over all of them.

#ifndef TRUELUX_TEXT_EVENLY_PICKED_H_
#define TRUELUX_TEXT_EVENLY_PICKED_H_

#include <cstddef>
#include <vector>

namespace truelux {

/// `count` indices below `total`, evenly spread, in their order; all if there
/// are no more.
[[nodiscard]] std::vector<std::size_t> EvenlyPicked(std::size_t total,
                                                    std::size_t count);

}  // namespace truelux

#endif  // TRUELUX_TEXT_EVENLY_PICKED_H_
