// SPDX-License-Identifier: GPL-3.0-or-later
// On which side of a triangle's plane a point is: from intervals, or, where
// they do not know, from exact numbers.

#ifndef TRUELUX_VISIBILITY_VIEW_TRIANGLE_SIDES_H_
#define TRUELUX_VISIBILITY_VIEW_TRIANGLE_SIDES_H_

#include "exact/recipe_evaluator.h"

namespace truelux {

/// The planes of triangles, the receiver r, and the vertices of a scene.
class TriangleSides {
 public:
  /// What the view refers to must outlive the object.
  explicit TriangleSides(const ReceiverView& view)
      : interval_(view), exact_(view) {}

  /// Sign of h = N . (t_0 - r): negative if r is in front of triangle t, zero
  /// exactly if r is in its plane.
  [[nodiscard]] Sign OfReceiver(TriangleId t) const {
    {
      const RoundUpward rounding;
      if (const auto sign = TrySign(interval_.Height(t))) return *sign;
    }
    return SignOf(exact_.Height(t));
  }

  /// Sign of N . (v - t_0): positive if vertex v is in front of triangle t,
  /// zero exactly if v is in its plane. Does not depend on r.
  [[nodiscard]] Sign OfVertex(TriangleId t, VertexId v) const {
    {
      const RoundUpward rounding;
      if (const auto sign = TrySign(interval_.AboveTriangle(t, v)))
        return *sign;
    }
    return SignOf(exact_.AboveTriangle(t, v));
  }

  [[nodiscard]] const RecipeEvaluator<Exact>& exact() const { return exact_; }

 private:
  RecipeEvaluator<Interval> interval_;
  RecipeEvaluator<Exact> exact_;
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_VIEW_TRIANGLE_SIDES_H_
