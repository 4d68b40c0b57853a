// SPDX-License-Identifier: GPL-3.0-or-later
// Recipes evaluated at any number type.

#ifndef TRUELUX_EXACT_RECIPE_EVALUATOR_H_
#define TRUELUX_EXACT_RECIPE_EVALUATOR_H_

#include <cassert>
#include <type_traits>

#include "base/id_vector.h"
#include "exact/displacement.h"
#include "exact/number.h"
#include "exact/recipe.h"
#include "exact/sign.h"
#include "exact/vec3.h"

namespace truelux {

/// a - b as an NT. Specialise it for a number type that knows better.
template <class NT>
struct DifferenceOf {
  static NT Of(double a, double b) { return NT(a) - NT(b); }
};

/// An exact number as an NT. Specialise it for each rounded number type.
template <class NT>
struct FromExact;

template <>
struct FromExact<Exact> {
  static const Exact& Of(const Exact& x) { return x; }
};

template <>
struct FromExact<Interval> {
  /// In any rounding mode. Mpzf::to_interval scales by std::ldexp(1, e), which
  /// under RoundUpward is the least subnormal number where it should be 0, and
  /// the interval then misses numbers below the range of binary64.
  static Interval Of(const Exact& x) {
    const CGAL::Protect_FPU_rounding<true> to_nearest(CGAL_FE_TONEAREST);
    return Interval(x.to_interval());
  }
};

/// The planes that DirectionRecipe::Kind::kCrossing refers to.
using PlaneSpan = IdSpan<PlaneId, const PlaneRecipe>;

/// The vectors that the explicit kinds of recipes refer to.
using ExplicitSpan = IdSpan<ExplicitId, const Vec3<Exact>>;

/// Evaluates recipes at the number type NT. NT needs construction from
/// double, +, - (unary, too) and *. Error: that of NT's operations.
template <class NT>
class RecipeEvaluator {
 public:
  explicit RecipeEvaluator(const ReceiverView& view) : view_(view) {}

  /// b - a, both input points.
  static Vec3<NT> Between(const Point3& a, const Point3& b) {
    return {DifferenceOf<NT>::Of(b.x, a.x), DifferenceOf<NT>::Of(b.y, a.y),
            DifferenceOf<NT>::Of(b.z, a.z)};
  }

  /// Vertex v relative to r.
  [[nodiscard]] Vec3<NT> FromReceiver(VertexId v) const {
    Vec3<NT> result = Between(view_.position, view_.vertices[v]);
    if constexpr (std::is_same_v<NT, Exact>) {
      if (view_.displacement != nullptr) {
        result = result - view_.displacement->receiver;
        if (v == view_.displacement->vertex)
          result = result + view_.displacement->of_vertex;
      }
    }
    return result;
  }

  /// Vertex b relative to vertex a.
  [[nodiscard]] Vec3<NT> FromVertex(VertexId a, VertexId b) const {
    Vec3<NT> result = Between(view_.vertices[a], view_.vertices[b]);
    if constexpr (std::is_same_v<NT, Exact>) {
      if (view_.displacement != nullptr) {
        if (b == view_.displacement->vertex)
          result = result + view_.displacement->of_vertex;
        if (a == view_.displacement->vertex)
          result = result - view_.displacement->of_vertex;
      }
    }
    return result;
  }

  [[nodiscard]] Vec3<NT> ReceiverNormal() const {
    return {NT(view_.normal.x), NT(view_.normal.y), NT(view_.normal.z)};
  }

  /// (t1 - t0) x (t2 - t0): points to the front of triangle t; degree 2.
  [[nodiscard]] Vec3<NT> TriangleNormal(TriangleId t) const {
    const auto [a, b, c] = CornersOf(view_.triangles[t]);
    return Cross(FromVertex(a, b), FromVertex(a, c));
  }

  /// h_t = N_t . (t0 - r): negative if r is in front of triangle t; degree 3.
  [[nodiscard]] NT Height(TriangleId t) const {
    return Dot(TriangleNormal(t),
               FromReceiver(CornersOf(view_.triangles[t])[0]));
  }

  /// N_t . (v - t0): positive if vertex v is in front of triangle t; degree 3,
  /// independent of r.
  [[nodiscard]] NT AboveTriangle(TriangleId t, VertexId v) const {
    return Dot(TriangleNormal(t),
               FromVertex(CornersOf(view_.triangles[t])[0], v));
  }

  /// n . (v - r): positive if vertex v is above the receiver plane; degree 2.
  [[nodiscard]] NT AboveHorizon(VertexId v) const {
    return Dot(ReceiverNormal(), FromReceiver(v));
  }

  [[nodiscard]] Vec3<NT> Plane(const PlaneRecipe& p,
                               ExplicitSpan explicit_vectors) const {
    return Signed(p.negated(), UnsignedPlane(p, explicit_vectors));
  }

  /// planes: those that kCrossing refers to.
  [[nodiscard]] Vec3<NT> Direction(const DirectionRecipe& d, PlaneSpan planes,
                                   ExplicitSpan explicit_vectors) const {
    return Signed(d.negated(), UnsignedDirection(d, planes, explicit_vectors));
  }

 private:
  static Vec3<NT> Signed(bool negated, const Vec3<NT>& v) {
    return negated ? -v : v;
  }

  /// f(a) (b - r) - f(b) (a - r), with f(a) > 0 > f(b).
  [[nodiscard]] Vec3<NT> Between(VertexId a, const NT& f_a, VertexId b,
                                 const NT& f_b) const {
    if constexpr (std::is_same_v<NT, Exact>) {
      assert(SignOf(f_a) == Sign::kPositive && SignOf(f_b) == Sign::kNegative);
    }
    return f_a * FromReceiver(b) - f_b * FromReceiver(a);
  }

  static Vec3<NT> FromExplicit(ExplicitId i, ExplicitSpan explicit_vectors) {
    const Vec3<Exact>& v = explicit_vectors[i];
    return {FromExact<NT>::Of(v.x), FromExact<NT>::Of(v.y),
            FromExact<NT>::Of(v.z)};
  }

  [[nodiscard]] Vec3<NT> UnsignedPlane(const PlaneRecipe& p,
                                       ExplicitSpan explicit_vectors) const {
    switch (p.kind()) {
      case PlaneRecipe::Kind::kEdge:
        // b - a, not b - r: the edge itself is short where the source is
        // small, and its difference keeps all bits.
        return Cross(FromReceiver(p.from()), FromVertex(p.from(), p.to()));
      case PlaneRecipe::Kind::kHorizon:
        return ReceiverNormal();
      case PlaneRecipe::Kind::kCut:
        return Height(p.second_triangle()) *
                   TriangleNormal(p.first_triangle()) -
               Height(p.first_triangle()) * TriangleNormal(p.second_triangle());
      case PlaneRecipe::Kind::kExplicit:
        break;
    }
    return FromExplicit(p.explicit_vector(), explicit_vectors);
  }

  [[nodiscard]] Vec3<NT> UnsignedDirection(
      const DirectionRecipe& d, PlaneSpan planes,
      ExplicitSpan explicit_vectors) const {
    switch (d.kind()) {
      case DirectionRecipe::Kind::kVertex:
        return FromReceiver(d.vertex());
      case DirectionRecipe::Kind::kEdgeAtHorizon:
        return Between(d.from(), AboveHorizon(d.from()), d.to(),
                       AboveHorizon(d.to()));
      case DirectionRecipe::Kind::kEdgeAtPlane:
        return Between(d.from(), AboveTriangle(d.triangle(), d.from()), d.to(),
                       AboveTriangle(d.triangle(), d.to()));
      case DirectionRecipe::Kind::kCrossing:
        return Cross(Plane(planes[d.first_plane()], explicit_vectors),
                     Plane(planes[d.second_plane()], explicit_vectors));
      case DirectionRecipe::Kind::kExplicit:
        break;
    }
    return FromExplicit(d.explicit_vector(), explicit_vectors);
  }

  ReceiverView view_;
};

}  // namespace truelux

#endif  // TRUELUX_EXACT_RECIPE_EVALUATOR_H_
