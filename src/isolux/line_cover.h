// SPDX-License-Identifier: GPL-3.0-or-later
// Which facets meet along one line of space.

#ifndef TRUELUX_ISOLUX_LINE_COVER_H_
#define TRUELUX_ISOLUX_LINE_COVER_H_

#include <array>
#include <span>
#include <vector>

#include "truelux/scene.h"

namespace truelux {

/// A side of a facet's outline.
struct FacetSide {
  int facet = 0;
  bool is_forward = false;  ///< runs from the lower to the higher vertex
};

/// A part of a line along which the same facets end.
struct LinePiece {
  std::array<int, 2> ends{};      ///< indices into Scene::vertices()
  std::vector<FacetSide> facets;  ///< forward: from the first end to the second
};

/// Cuts the edges on a line where others of them end, so that facets that meet
/// along a part of an edge are seen to do so.
class LineCover {
 public:
  explicit LineCover(const Scene& scene) : scene_(scene) {}

  /// An edge on the line, with the facets that it bounds.
  void Add(const std::array<int, 2>& ends, std::span<const FacetSide> facets);

  /// In their order along the line. Neighbours with the same facets are one.
  [[nodiscard]] std::vector<LinePiece> Pieces() const;

 private:
  struct Edge {
    std::array<int, 2> ends;
    std::vector<FacetSide> facets;
  };

  /// Along the axis on which the line is longest; exact.
  [[nodiscard]] double PlaceOf(int vertex) const;

  const Scene& scene_;
  int axis_ = -1;
  std::vector<Edge> edges_;
};

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_LINE_COVER_H_
