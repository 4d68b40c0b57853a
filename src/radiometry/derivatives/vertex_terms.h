// SPDX-License-Identifier: GPL-3.0-or-later
// What the corners of a visible contour's lines add to dE/dv.

#ifndef TRUELUX_RADIOMETRY_DERIVATIVES_VERTEX_TERMS_H_
#define TRUELUX_RADIOMETRY_DERIVATIVES_VERTEX_TERMS_H_

#include <cstddef>
#include <map>
#include <vector>

#include "exact/number.h"
#include "exact/vec3.h"
#include "radiometry/derivatives/moving_contour.h"

namespace truelux {

/// factor * direction * (n.W y) / |N| of an arc, factor = above / below: what
/// the arc adds to pi |n| dE/dv if its source has M = 1
/// [docs/derivatives.md (4)].
struct VertexTerm {
  std::size_t arc = 0;  ///< index into MovingContour::arcs
  Exact above;
  Exact below;
  Vec3<Exact> direction;
  Vec3<Exact> y;
};

/// By the numbers of vertices in the input.
using VertexTerms = std::map<int, std::vector<VertexTerm>>;

/// The terms of all vertices. contour: of the view, its cuts split. An edge is
/// that of the face that the contour names as its own.
VertexTerms VertexTermsOf(const ReceiverView& view, const Scene& scene,
                          const MovingContour& contour);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_DERIVATIVES_VERTEX_TERMS_H_
