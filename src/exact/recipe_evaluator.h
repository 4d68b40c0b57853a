// Recipes evaluated at any number type.

#ifndef TRUELUX_EXACT_RECIPE_EVALUATOR_H_
#define TRUELUX_EXACT_RECIPE_EVALUATOR_H_

#include <cstddef>
#include <span>

#include "exact/number.h"
#include "exact/recipe.h"
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
  static Interval Of(const Exact& x) { return Interval(x.to_interval()); }
};

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
  Vec3<NT> FromReceiver(int v) const {
    return Between(view_.position, Vertex(v));
  }

  Vec3<NT> ReceiverNormal() const {
    return {NT(view_.normal.x), NT(view_.normal.y), NT(view_.normal.z)};
  }

  /// (t1 - t0) x (t2 - t0): points to the front of triangle t; degree 2.
  Vec3<NT> TriangleNormal(int t) const {
    return Cross(Between(Corner(t, 0), Corner(t, 1)),
                 Between(Corner(t, 0), Corner(t, 2)));
  }

  /// h_t = N_t . (t0 - r): negative if r is in front of triangle t; degree 3.
  NT Height(int t) const {
    return Dot(TriangleNormal(t), Between(view_.position, Corner(t, 0)));
  }

  /// N_t . (v - t0): positive if vertex v is in front of triangle t; degree 3,
  /// independent of r.
  NT AboveTriangle(int t, int v) const {
    return Dot(TriangleNormal(t), Between(Corner(t, 0), Vertex(v)));
  }

  /// n . (v - r): positive if vertex v is above the receiver plane; degree 2.
  NT AboveHorizon(int v) const {
    return Dot(ReceiverNormal(), FromReceiver(v));
  }

  Vec3<NT> Plane(const PlaneRecipe& p,
                 std::span<const Vec3<Exact>> explicit_vectors) const {
    return Signed(p.negated, UnsignedPlane(p, explicit_vectors));
  }

  /// planes: those that kCrossing refers to.
  Vec3<NT> Direction(const DirectionRecipe& d,
                     std::span<const PlaneRecipe> planes,
                     std::span<const Vec3<Exact>> explicit_vectors) const {
    return Signed(d.negated, UnsignedDirection(d, planes, explicit_vectors));
  }

 private:
  const Point3& Vertex(int v) const {
    return view_.vertices[static_cast<std::size_t>(v)];
  }

  const Point3& Corner(int t, std::size_t k) const {
    return Vertex(view_.triangles[static_cast<std::size_t>(t)].vertices[k]);
  }

  static Vec3<NT> Signed(bool negated, const Vec3<NT>& v) {
    return negated ? -v : v;
  }

  /// f(a) (b - r) - f(b) (a - r), with f(a) > 0 > f(b).
  Vec3<NT> Between(int a, const NT& f_a, int b, const NT& f_b) const {
    return f_a * FromReceiver(b) - f_b * FromReceiver(a);
  }

  static Vec3<NT> FromExplicit(int i,
                               std::span<const Vec3<Exact>> explicit_vectors) {
    const Vec3<Exact>& v = explicit_vectors[static_cast<std::size_t>(i)];
    return {FromExact<NT>::Of(v.x), FromExact<NT>::Of(v.y),
            FromExact<NT>::Of(v.z)};
  }

  Vec3<NT> UnsignedPlane(const PlaneRecipe& p,
                         std::span<const Vec3<Exact>> explicit_vectors) const {
    switch (p.kind) {
      case PlaneRecipe::Kind::kEdge:
        // b - a, not b - r: the edge itself is short where the source is
        // small, and its difference keeps all bits.
        return Cross(FromReceiver(p.a), Between(Vertex(p.a), Vertex(p.b)));
      case PlaneRecipe::Kind::kHorizon:
        return ReceiverNormal();
      case PlaneRecipe::Kind::kCut:
        return Height(p.b) * TriangleNormal(p.a) -
               Height(p.a) * TriangleNormal(p.b);
      case PlaneRecipe::Kind::kExplicit:
        break;
    }
    return FromExplicit(p.a, explicit_vectors);
  }

  Vec3<NT> UnsignedDirection(
      const DirectionRecipe& d, std::span<const PlaneRecipe> planes,
      std::span<const Vec3<Exact>> explicit_vectors) const {
    switch (d.kind) {
      case DirectionRecipe::Kind::kVertex:
        return FromReceiver(d.a);
      case DirectionRecipe::Kind::kEdgeAtHorizon:
        return Between(d.a, AboveHorizon(d.a), d.b, AboveHorizon(d.b));
      case DirectionRecipe::Kind::kEdgeAtPlane:
        return Between(d.a, AboveTriangle(d.c, d.a), d.b,
                       AboveTriangle(d.c, d.b));
      case DirectionRecipe::Kind::kCrossing:
        return Cross(
            Plane(planes[static_cast<std::size_t>(d.a)], explicit_vectors),
            Plane(planes[static_cast<std::size_t>(d.b)], explicit_vectors));
      case DirectionRecipe::Kind::kExplicit:
        break;
    }
    return FromExplicit(d.a, explicit_vectors);
  }

  ReceiverView view_;
};

}  // namespace truelux

#endif  // TRUELUX_EXACT_RECIPE_EVALUATOR_H_
