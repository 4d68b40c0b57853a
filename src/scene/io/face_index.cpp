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

std::string_view NameOf(IndexKind kind) {
  switch (kind) {
    case IndexKind::kTexture:
      return "texture vertex";
    case IndexKind::kNormal:
      return "normal";
    case IndexKind::kVertex:
      break;
  }
  return "vertex";
}

std::optional<CornerIndices> ParseCorner(std::string_view word) {
  CornerIndices indices;
  for (std::size_t part = 0; part < indices.size(); ++part) {
    const std::size_t slash = word.find('/');
    const bool is_last = slash == std::string_view::npos;
    const std::string_view digits = word.substr(0, slash);
    const bool may_be_empty = part == 1 && !is_last;
    if (!digits.empty() || !may_be_empty) {
      indices[part] = ParseInteger(digits);
      if (!indices[part]) return std::nullopt;
    }
    if (is_last) return indices;
    word.remove_prefix(slash + 1);
  }
  return std::nullopt;  // a third slash
}

}  // namespace truelux
