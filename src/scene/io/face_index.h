// SPDX-License-Identifier: GPL-3.0-or-later
// The corners of an f statement: v, v/vt, v//vn or v/vt/vn.

#ifndef TRUELUX_SCENE_IO_FACE_INDEX_H_
#define TRUELUX_SCENE_IO_FACE_INDEX_H_

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace truelux {

/// What an index of an OBJ file counts, in the order within a corner.
enum class IndexKind { kVertex, kTexture, kNormal };

inline constexpr std::array kIndexKinds{IndexKind::kVertex, IndexKind::kTexture,
                                        IndexKind::kNormal};

/// The indices of one corner as written. An index too large for its type is the
/// largest of the type: out of any range.
struct Corner {
  std::int64_t vertex = 0;
  /// By kind; that of the vertex is none. Nobody uses these, so that none of
  /// them is required to be there or to be a number.
  std::array<std::optional<std::int64_t>, 3> unused;
  /// Whether the word is v, v/vt, v//vn or v/vt/vn.
  bool is_regular = true;
};

/// Nothing if the word does not begin with an integer and then ends or goes on
/// with a slash.
std::optional<Corner> ParseCorner(std::string_view word);

}  // namespace truelux

#endif  // TRUELUX_SCENE_IO_FACE_INDEX_H_
