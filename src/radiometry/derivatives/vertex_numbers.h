// SPDX-License-Identifier: GPL-3.0-or-later
// What vertices are called in the input.

#ifndef TRUELUX_RADIOMETRY_DERIVATIVES_VERTEX_NUMBERS_H_
#define TRUELUX_RADIOMETRY_DERIVATIVES_VERTEX_NUMBERS_H_

#include <cstddef>
#include <span>

#include "truelux/scene.h"

#include "base/ids.h"

namespace truelux {

/// Finds the input's numbers of vertices.
class VertexNumbers {
 public:
  explicit VertexNumbers(const Scene& scene)
      : scene_(scene), numbers_(scene.corner_numbers()) {}

  /// The number of a vertex as a corner of a face; of the edge from there to
  /// `next`, in either direction, if the face has the vertex more than once.
  [[nodiscard]] int Of(const Face& face, VertexId vertex, VertexId next) const {
    const auto first = static_cast<std::size_t>(face.first_corner);
    const auto count = static_cast<std::size_t>(face.corner_count);
    const auto ring = scene_.corners().subspan(first, count);
    int found = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (ring[i] != vertex.value()) continue;
      const bool is_end = ring[(i + 1) % count] == next.value() ||
                          ring[(i + count - 1) % count] == next.value();
      if (found == 0 || is_end) found = numbers_[first + i];
      if (is_end) break;
    }
    return found;
  }

 private:
  const Scene& scene_;
  std::span<const int> numbers_;
};

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_DERIVATIVES_VERTEX_NUMBERS_H_
