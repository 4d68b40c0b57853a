// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/level_choice.h"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>

namespace truelux {

std::vector<double> EvenLevels(double least, double most, int count) {
  if (!(least < most)) return {};
  std::vector<double> levels;
  for (int digits = 3; digits <= 17; ++digits) {
    levels.clear();
    for (int i = 0; i < count; ++i) {
      const double level = least + (most - least) * (i + 0.5) / count;
      const std::string text = fmt::format("{:.{}g}", level, digits);
      levels.push_back(std::strtod(text.c_str(), nullptr));
    }
    const bool ascends = std::ranges::adjacent_find(
                             levels, std::greater_equal<>()) == levels.end();
    if (ascends && levels.front() > least && levels.back() < most) break;
  }
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

}  // namespace truelux
