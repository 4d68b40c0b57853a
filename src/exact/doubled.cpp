// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/doubled.h"

#include "exact/ball_recipe.h"
#include "exact/number.h"
#include "exact/recipe_evaluator.h"

namespace truelux {
namespace {

using Doubled = Ball<DoubleDouble>;
using Evaluator = RecipeEvaluator<Doubled>;

/// f() in round-to-nearest, which double-double needs. Not looked into: the
/// compiler may move arithmetic past a change of the mode, but no call.
template <class F>
auto Nearest(const F& f) {
  const CGAL::Protect_FPU_rounding<true> rounding(CGAL_FE_TONEAREST);
  return f();
}

/// Nothing also for a bound that is not a number.
std::optional<Sign> SignIn(const Doubled& x) {
  if (!(LowerMagnitude(x.value) > x.error)) return std::nullopt;
  return SignOf(Leading(x.value));
}

[[gnu::noipa]] DoubledVector PlaneOf(const ReceiverView& view,
                                     const PlaneRecipe& plane) {
  return Evaluator(view).Plane(plane, {});
}

[[gnu::noipa]] DoubledVector DirectionOf(const ReceiverView& view,
                                         const DirectionRecipe& direction) {
  return Evaluator(view).Direction(direction, {}, {});
}

[[gnu::noipa]] std::optional<Sign> SignOfDot(const DoubledVector& a,
                                             const DoubledVector& b) {
  return SignIn(Dot(a, b));
}

[[gnu::noipa]] std::optional<Sign> SignOfDeterminant(const DoubledVector& a,
                                                     const DoubledVector& b,
                                                     const DoubledVector& c) {
  return SignIn(Determinant(a, b, c));
}

[[gnu::noipa]] std::optional<Sign> SignOfHeight(const ReceiverView& view,
                                                TriangleId triangle) {
  return SignIn(Evaluator(view).Height(triangle));
}

[[gnu::noipa]] std::optional<Sign> SignOfAbove(const ReceiverView& view,
                                               TriangleId triangle,
                                               VertexId vertex) {
  return SignIn(Evaluator(view).AboveTriangle(triangle, vertex));
}

}  // namespace

DoubledVector DoubledPlane(const ReceiverView& view, const PlaneRecipe& plane) {
  return Nearest([&] { return PlaneOf(view, plane); });
}

DoubledVector DoubledDirection(const ReceiverView& view,
                               const DirectionRecipe& direction) {
  return Nearest([&] { return DirectionOf(view, direction); });
}

std::optional<Sign> DoubledDot(const DoubledVector& a, const DoubledVector& b) {
  return Nearest([&] { return SignOfDot(a, b); });
}

std::optional<Sign> DoubledDeterminant(const DoubledVector& a,
                                       const DoubledVector& b,
                                       const DoubledVector& c) {
  return Nearest([&] { return SignOfDeterminant(a, b, c); });
}

std::optional<Sign> DoubledHeight(const ReceiverView& view,
                                  TriangleId triangle) {
  return Nearest([&] { return SignOfHeight(view, triangle); });
}

std::optional<Sign> DoubledAbove(const ReceiverView& view, TriangleId triangle,
                                 VertexId vertex) {
  return Nearest([&] { return SignOfAbove(view, triangle, vertex); });
}

}  // namespace truelux
