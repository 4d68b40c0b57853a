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

/// "vertex", "texture vertex" or "normal".
std::string_view NameOf(IndexKind kind);

/// The indices of one corner as written, by kind. An index too large for its
/// type is the largest of the type: out of any range.
using CornerIndices = std::array<std::optional<std::int64_t>, 3>;

/// Nothing if the word has none of the four forms.
std::optional<CornerIndices> ParseCorner(std::string_view word);

}  // namespace truelux

#endif  // TRUELUX_SCENE_IO_FACE_INDEX_H_
