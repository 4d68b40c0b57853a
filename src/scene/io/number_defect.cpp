// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/io/number_defect.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "truelux/io.h"

#include "scene/io/quoted.h"

namespace truelux {
namespace {

constexpr std::string_view kCommasBetween =
    "commas between numbers, expected blanks";
constexpr std::string_view kDecimalCommas =
    "decimal commas, expected decimal points: write 1.5, not 1,5 (and no "
    "thousands separators)";
constexpr std::string_view kThousands =
    "thousands separators, expected none: write 1234.5, not 1,234.5";
constexpr std::string_view kThousandsInFace =
    "thousands separators or commas in a face, expected none: write 1001 for "
    "the vertex, not 1,001";

/// The word with its commas replaced, or left out if `with` is 0.
std::string ReplaceCommas(std::string_view word, char with) {
  std::string result;
  for (const char c : word) {
    if (c != ',') {
      result += c;
    } else if (with != 0) {
      result += with;
    }
  }
  return result;
}

/// Whether a word is a number if some of its characters are not looked at.
bool IsNumber(const std::string& word) {
  return ParseNumber(word).has_value();
}

/// Whether the commas of a word group the digits before its point by three.
bool IsGrouped(std::string_view word) {
  if (!IsNumber(ReplaceCommas(word, '\0'))) return false;
  std::string_view whole = word.substr(0, word.find_first_of(".eE"));
  if (word.substr(whole.size()).find(',') != std::string_view::npos) {
    return false;
  }
  for (std::size_t comma = whole.find(','); comma != std::string_view::npos;
       comma = whole.find(',')) {
    whole.remove_prefix(comma + 1);
    if (std::min(whole.find(','), whole.size()) != 3) return false;
  }
  return true;
}

/// Whether a word is a decimal number beyond the range of binary64: one
/// of more than 300 digits, or a number with an exponent.
bool IsTooLarge(std::string_view word) {
  const std::string_view mantissa = word.substr(0, word.find_first_of("eE"));
  const bool has_exponent = mantissa.size() < word.size();
  const std::string_view exponent = word.substr(mantissa.size());
  return mantissa.find_first_not_of("+-.0123456789") ==
             std::string_view::npos &&
         (has_exponent ? IsNumber(std::string(mantissa)) &&
                             IsNumber("0" + std::string(exponent))
                       : word.size() > 300);
}

}  // namespace

void NumberDefect::Report(int line, DiagnosticList& diagnostics) const {
  if (is_habit) {
    diagnostics.CountError(line, text);
  } else {
    diagnostics.Error(line, text);
  }
}

NumberDefect DefectOfNumber(std::string_view word) {
  const auto commas = std::ranges::count(word, ',');
  if (commas > 0 && word.ends_with(',') &&
      IsNumber(ReplaceCommas(word, '\0'))) {
    return {std::string(kCommasBetween), true};
  }
  if (commas == 1 && IsNumber(ReplaceCommas(word, '.'))) {
    return {std::string(kDecimalCommas), true};
  }
  if (commas > 0 && IsGrouped(word)) return {std::string(kThousands), true};
  if (commas > 0 && IsNumber(ReplaceCommas(word, '\0'))) {
    return {std::string(kCommasBetween), true};
  }
  if (IsTooLarge(word)) {
    return {Quoted(word) +
                " is too large, expected a number within binary64's "
                "range, at most 1.79e308",
            false};
  }
  return {Quoted(word) +
              " is no number, expected a finite decimal number such as 1.5 or "
              "-2e-3",
          false};
}

bool IsHabit(std::string_view text) {
  return text == kCommasBetween || text == kDecimalCommas ||
         text == kThousands || text == kThousandsInFace;
}

NumberDefect DefectOfCorner(std::string_view word) {
  const std::string_view vertex = word.substr(0, word.find('/'));
  if (vertex.find(',') != std::string_view::npos &&
      IsNumber(ReplaceCommas(vertex, '\0'))) {
    return {std::string(kThousandsInFace), true};
  }
  return {Quoted(word) +
              " is no vertex of a face, expected integers as v, v/vt, v//vn "
              "or v/vt/vn",
          false};
}

}  // namespace truelux
