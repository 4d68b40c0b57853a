// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/io/face_index.h"

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>

namespace truelux {
namespace {

/// [sign] digits, the whole word.
std::optional<std::int64_t> ParseInteger(std::string_view word) {
  if (word.starts_with('+')) {
    word.remove_prefix(1);
    if (word.starts_with('-')) return std::nullopt;
  }
  std::int64_t value = 0;
  const char* const word_end = word.data() + word.size();
  const auto [end, error] = std::from_chars(word.data(), word_end, value);
  if (error == std::errc::invalid_argument || end != word_end) {
    return std::nullopt;
  }
  if (error == std::errc::result_out_of_range) {
    using Limits = std::numeric_limits<std::int64_t>;
    return word.starts_with('-') ? Limits::min() : Limits::max();
  }
  return value;
}

}  // namespace

std::optional<Corner> ParseCorner(std::string_view word) {
  const auto take_part = [&word] {
    const std::string_view part = word.substr(0, word.find('/'));
    word.remove_prefix(part.size());
    return part;
  };
  Corner corner;
  const std::optional<std::int64_t> vertex = ParseInteger(take_part());
  if (!vertex) return std::nullopt;
  corner.vertex = *vertex;
  for (std::size_t kind = 1; kind < kIndexKinds.size() && !word.empty();
       ++kind) {
    word.remove_prefix(1);  // the slash
    const std::string_view part = take_part();
    corner.unused[kind] = ParseInteger(part);
    const bool may_be_empty = kind == 1 && word.size() > 1;
    corner.is_regular =
        corner.is_regular &&
        (part.empty() ? may_be_empty : corner.unused[kind].has_value());
  }
  corner.is_regular = corner.is_regular && word.empty();
  return corner;
}

}  // namespace truelux
