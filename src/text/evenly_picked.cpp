// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/evenly_picked.h"

#include <algorithm>

namespace truelux {

std::vector<std::size_t> EvenlyPicked(std::size_t total, std::size_t count) {
  std::vector<std::size_t> picked(std::min(total, count));
  const double step =
      static_cast<double>(total) / static_cast<double>(picked.size());
  for (std::size_t i = 0; i < picked.size(); ++i) {
    // The middle of the i-th of equal shares.
    const double middle = (static_cast<double>(i) + 0.5) * step;
    picked[i] = std::min(static_cast<std::size_t>(middle), total - 1);
  }
  return picked;
}

}  // namespace truelux
