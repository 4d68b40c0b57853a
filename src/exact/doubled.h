// SPDX-License-Identifier: GPL-3.0-or-later
// The stage of predicates between intervals and exact numbers: double-double
// with a running bound. It tells near-ties from ties, whose bound always holds
// zero: those stay open.
//
// All functions may be called in any rounding mode, and leave it as it is. What
// over- or underflows has a bound that is not finite, or larger than the value
// (ball.h, kUnderflow), and stays open.

#ifndef TRUELUX_EXACT_DOUBLED_H_
#define TRUELUX_EXACT_DOUBLED_H_

#include <optional>

#include "exact/ball.h"
#include "exact/double_double.h"
#include "exact/recipe.h"
#include "exact/sign.h"
#include "exact/vec3.h"

namespace truelux {

/// A plane or a direction through r, of every component a bound.
using DoubledVector = Vec3<Ball<DoubleDouble>>;

/// No kExplicit recipe; displacements are ignored.
[[nodiscard]] DoubledVector DoubledPlane(const ReceiverView& view,
                                         const PlaneRecipe& plane);

/// No kCrossing and no kExplicit recipe; displacements are ignored.
[[nodiscard]] DoubledVector DoubledDirection(const ReceiverView& view,
                                             const DirectionRecipe& direction);

/// The sign of a . b; nothing where the bound cannot tell.
[[nodiscard]] std::optional<Sign> DoubledDot(const DoubledVector& a,
                                             const DoubledVector& b);

/// The sign of det(a, b, c); nothing where the bound cannot tell.
[[nodiscard]] std::optional<Sign> DoubledDeterminant(const DoubledVector& a,
                                                     const DoubledVector& b,
                                                     const DoubledVector& c);

/// The sign of RecipeEvaluator::Height; nothing where the bound cannot tell.
[[nodiscard]] std::optional<Sign> DoubledHeight(const ReceiverView& view,
                                                TriangleId triangle);

/// The sign of RecipeEvaluator::AboveTriangle; nothing where the bound cannot
/// tell.
[[nodiscard]] std::optional<Sign> DoubledAbove(const ReceiverView& view,
                                               TriangleId triangle,
                                               VertexId vertex);

}  // namespace truelux

#endif  // TRUELUX_EXACT_DOUBLED_H_
