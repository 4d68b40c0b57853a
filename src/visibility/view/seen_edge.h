// SPDX-License-Identifier: GPL-3.0-or-later
// An edge of a view, by where it comes from.

#ifndef TRUELUX_VISIBILITY_VIEW_SEEN_EDGE_H_
#define TRUELUX_VISIBILITY_VIEW_SEEN_EDGE_H_

#include <compare>

namespace truelux {

/// An edge of a face, or the line where one face passes through another's
/// plane.
struct SeenEdge {
  int face = 0;  ///< number (1-based) of the first face that has the edge
  /// Its ends as indices into Scene::vertices(), a < b; -1, -1: a line.
  int a = -1;
  int b = -1;
  int other_face = 0;  ///< of a line: the face whose plane `face` meets there

  friend auto operator<=>(const SeenEdge&, const SeenEdge&) = default;
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_VIEW_SEEN_EDGE_H_
