// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/number_text.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>

namespace truelux {

std::string ScientificText(double value, int digits) {
  if (value == 0 || !std::isfinite(value)) return fmt::format("{:g}", value);
  std::string text = fmt::format("{:.{}e}", value, digits);
  // fmt writes at least two digits of the exponent: e-05, e+00.
  const std::size_t exponent = text.find('e') + 2;
  if (text[exponent] == '0') text.erase(exponent, 1);
  if (text[exponent - 1] == '+') text.erase(exponent - 1, 1);
  if (text.ends_with("e0")) text.erase(text.size() - 2);
  return text;
}

std::string TimeText(double microseconds) {
  constexpr std::array<const char*, 4> kUnits = {"ns", "\u00b5s", "ms", "s"};
  double value = 1e3 * microseconds;
  std::size_t unit = 0;
  // 999.5 would be written as 1000.
  while (value >= 999.5 && unit + 1 < kUnits.size()) {
    value /= 1e3;
    ++unit;
  }
  const int decimals = value < 9.995 ? 2 : value < 99.95 ? 1 : 0;
  return fmt::format("{:.{}f} {}", value, decimals, kUnits[unit]);
}

}  // namespace truelux
