// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/level_style.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "text/results.h"

namespace truelux {

std::string LevelColour(std::size_t level, std::size_t count) {
  constexpr std::array<std::array<double, 3>, 5> kColours = {{{36, 26, 120},
                                                              {112, 24, 150},
                                                              {178, 40, 112},
                                                              {208, 74, 40},
                                                              {214, 122, 0}}};
  const double place = count < 2 ? 0
                                 : static_cast<double>(level) /
                                       static_cast<double>(count - 1) *
                                       static_cast<double>(kColours.size() - 1);
  const std::size_t below =
      std::min(static_cast<std::size_t>(place), kColours.size() - 2);
  const double t = place - static_cast<double>(below);
  std::array<int, 3> mixed{};
  for (std::size_t k = 0; k < 3; ++k) {
    mixed[k] = static_cast<int>(
        std::lround((1 - t) * kColours[below][k] + t * kColours[below + 1][k]));
  }
  return fmt::format("#{:02x}{:02x}{:02x}", mixed[0], mixed[1], mixed[2]);
}

std::vector<std::string> LevelTexts(std::span<const double> levels) {
  constexpr std::size_t kMost = 8;
  std::vector<std::string> exact;
  std::vector<std::string> rounded;
  for (const double level : levels) {
    std::string& text = exact.emplace_back();
    AppendNumber(text, level);
    rounded.push_back(text.size() > kMost ? fmt::format("{:.6g}", level)
                                          : text);
  }
  return std::ranges::adjacent_find(rounded) == rounded.end() ? rounded : exact;
}

}  // namespace truelux
