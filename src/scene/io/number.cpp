// SPDX-License-Identifier: GPL-3.0-or-later
// Decimal text -> the nearest binary64.
//
// std::from_chars rounds correctly, but it accepts inf and nan, refuses '+',
// and does not tell underflow from overflow. So the text is taken apart here
// first.

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>

#include "truelux/io.h"

namespace truelux {
namespace {

/// [sign] whole [. fraction] [e exponent], without the separators.
struct Decimal {
  bool negative = false;
  std::string_view unsigned_text;
  std::string_view whole;
  std::string_view fraction;
  std::int64_t exponent = 0;  ///< at most kHugeExponent in absolute value
};

// Larger than the number of digits of any text, small enough to be added to
// one. An exponent at this limit stands for all beyond it.
constexpr std::int64_t kHugeExponent = std::int64_t{1} << 61;

bool IsDigit(char c) {
  return c >= '0' && c <= '9';
}

std::string_view TakeDigits(std::string_view& text) {
  std::size_t count = 0;
  while (count < text.size() && IsDigit(text[count]))
    ++count;
  const std::string_view digits = text.substr(0, count);
  text.remove_prefix(count);
  return digits;
}

/// Removes a leading sign. Returns true if it was a minus.
bool TakeSign(std::string_view& text) {
  if (text.empty() || (text[0] != '+' && text[0] != '-')) return false;
  const bool negative = text[0] == '-';
  text.remove_prefix(1);
  return negative;
}

std::optional<std::int64_t> TakeExponent(std::string_view& text) {
  if (text.empty()) return 0;
  if (text[0] != 'e' && text[0] != 'E') return std::nullopt;
  text.remove_prefix(1);
  const bool negative = TakeSign(text);
  const std::string_view digits = TakeDigits(text);
  if (digits.empty()) return std::nullopt;
  std::int64_t value = 0;
  for (const char c : digits) {
    value = std::min(kHugeExponent,
                     10 * std::min(value, kHugeExponent / 10) + (c - '0'));
  }
  return negative ? -value : value;
}

std::optional<Decimal> Dissect(std::string_view text) {
  Decimal decimal;
  decimal.negative = TakeSign(text);
  decimal.unsigned_text = text;
  decimal.whole = TakeDigits(text);
  if (!text.empty() && text[0] == '.') {
    text.remove_prefix(1);
    decimal.fraction = TakeDigits(text);
  }
  if (decimal.whole.empty() && decimal.fraction.empty()) return std::nullopt;
  const std::optional<std::int64_t> exponent = TakeExponent(text);
  if (!exponent || !text.empty()) return std::nullopt;
  decimal.exponent = *exponent;
  return decimal;
}

/// e so that the number, which is not zero, is 0.ddd * 10^e with d > 0 first.
std::int64_t DecimalExponent(const Decimal& decimal) {
  std::size_t zeros = decimal.whole.find_first_not_of('0');
  if (zeros != std::string_view::npos) {
    return decimal.exponent +
           static_cast<std::int64_t>(decimal.whole.size() - zeros);
  }
  zeros = decimal.fraction.find_first_not_of('0');
  return decimal.exponent - static_cast<std::int64_t>(zeros);
}

/// The absolute value; nothing if it is too large.
std::optional<double> Magnitude(const Decimal& decimal) {
  double value = 0;
  const std::string_view text = decimal.unsigned_text;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc()) return value;
  // Out of range: beyond 10^308, or so small that it rounds to zero.
  if (DecimalExponent(decimal) > 0) return std::nullopt;
  return 0.0;
}

}  // namespace

std::optional<double> ParseNumber(std::string_view text) {
  const std::optional<Decimal> decimal = Dissect(text);
  if (!decimal) return std::nullopt;
  const std::optional<double> magnitude = Magnitude(*decimal);
  if (!magnitude) return std::nullopt;
  return decimal->negative ? -*magnitude : *magnitude;
}

}  // namespace truelux
