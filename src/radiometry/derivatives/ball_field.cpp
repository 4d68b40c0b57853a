// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/derivatives/ball_field.h"

#include "exact/angle_sum.h"
#include "exact/ball_recipe.h"
#include "exact/recipe_evaluator.h"
#include "radiometry/derivatives/ball_arcs.h"

namespace truelux {
namespace {

/// The direction of a plane's line, L with N = a x L, scaled.
template <class T>
ScaledVector<T> LineOf(const WeightedContour& contour,
                       const PlaneRecipe& plane) {
  ScaledVector<T> line;
  if (plane.kind() == PlaneRecipe::Kind::kEdge) {
    const auto along = Difference<T>(contour.view.vertices[plane.from()],
                                     contour.view.vertices[plane.to()]);
    const Components<T> value =
        plane.negated() ? Negated(along.value) : along.value;
    if (ScaleToUnit(value, along.error, line)) return line;
  }
  const RecipeEvaluator<Exact> exact(contour.view);
  Vec3<Exact> along =
      plane.kind() == PlaneRecipe::Kind::kEdge
          ? exact.FromVertex(plane.from(), plane.to())
          : Cross(exact.TriangleNormal(plane.first_triangle()),
                  exact.TriangleNormal(plane.second_triangle()));
  return ScaleToUnit<T>(plane.negated() ? -along : along);
}

/// Sums the arcs' terms.
template <class T>
class FieldSummer {
 public:
  FieldSummer(const WeightedContour& contour, BallGeometry<T>& geometry)
      : arcs_(contour, geometry) {
    for (const PlaneId id : contour.contour.planes.ids())
      inverses_.push_back(InverseAt(id));
  }

  std::array<BallField<T>, 3> Find() const {
    std::array<BallField<T>, 3> fields{};
    const WeightedContour& contour = arcs_.contour();
    const Ball<T> inverse_pi = Ball<T>(0.5) / HalfPi<T>();
    for (const SourceId source : contour.contour.sources.ids()) {
      if (!contour.IsLit(source)) continue;
      BallField<T> own{};
      for (const Arc& arc : contour.ArcsOf(source))
        Add(arc, own);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const double weight = contour.WeightOf(source)[channel];
        if (weight == 0) continue;
        const Ball<T> factor = inverse_pi * Ball<T>(weight);
        BallField<T>& field = fields[channel];
        field.vector = Sum(field.vector, Times(factor, own.vector));
        for (std::size_t p = 0; p < 3; ++p) {
          field.jacobian[p] =
              Sum(field.jacobian[p], Times(factor, own.jacobian[p]));
        }
      }
    }
    return fields;
  }

 private:
  [[nodiscard]] bool IsHorizon(PlaneId id) const {
    return arcs_.contour().contour.planes[id].kind() ==
           PlaneRecipe::Kind::kHorizon;
  }

  /// G = (L x N) / N^2, 1/rho = G . w; none for the horizon.
  [[nodiscard]] BallVector<T> InverseAt(PlaneId id) const {
    if (IsHorizon(id)) return {};
    const ScaledVector<T>& n = arcs_.Normal(id);
    const ScaledVector<T> line =
        LineOf<T>(arcs_.contour(), arcs_.contour().contour.planes[id]);
    const BallVector<T> across = Cross(line.vector, n.vector);
    return Shifted(Times(Ball<T>(1.0) / Dot(n.vector, n.vector), across),
                   line.exponent - n.exponent);
  }

  /// -beta/2 m_out to V, -K m_out^T to J.
  void Add(const Arc& arc, BallField<T>& field) const {
    const BallArc<T> own = arcs_.At(arc);
    field.vector =
        Sum(field.vector, Times(Ball<T>(0.5) * own.angle, own.inward));
    if (IsHorizon(arc.plane)) return;
    // K = W G.
    const BallVector<T>& u1 = arcs_.Unit(arc.from);
    const BallVector<T>& u2 = arcs_.Unit(arc.to);
    const Ball<T> q1 = Dot(inverses_[arc.plane], u1);
    const Ball<T> q2 = Dot(inverses_[arc.plane], u2);
    const BallVector<T> k = Sum(Times(own.a * (q1 + q2), Sum(u1, u2)),
                                Times(own.b * (q2 - q1), Sum(u2, -u1)));
    for (std::size_t p = 0; p < 3; ++p) {
      field.jacobian[p] =
          Sum(field.jacobian[p], Times(Component(k, p), own.inward));
    }
  }

  BallArcs<T> arcs_;
  IdVector<PlaneId, BallVector<T>> inverses_;
};

template <class T>
void Put(const BallVector<T>& v, std::size_t at,
         ComponentArray<Ball<T>>& components) {
  for (std::size_t k = 0; k < 3; ++k)
    components[at + k] = Component(v, k);
}

/// v less what it has along m.
template <class T>
BallVector<T> Across(const BallVector<T>& v, const BallVector<T>& m) {
  return Sum(v, -Times(Dot(v, m) / Dot(m, m), m));
}

}  // namespace

template <class T>
std::array<BallField<T>, 3> BallFieldsOf(const WeightedContour& contour,
                                         BallGeometry<T>& geometry) {
  return FieldSummer<T>(contour, geometry).Find();
}

template <class T>
ComponentArray<Ball<T>> BallComponentsOf(const BallField<T>& hemisphere,
                                         const BallField<T>& sphere,
                                         const BallVector<T>& n,
                                         const BallVector<T>& m,
                                         const Ball<T>& scale) {
  ComponentArray<Ball<T>> components;
  const Ball<T> inverse = Ball<T>(1.0) / Length(n);
  BallVector<T> gradient{};
  for (std::size_t p = 0; p < 3; ++p) {
    gradient = Sum(gradient, Times(Component(n, p), hemisphere.jacobian[p]));
    Put(hemisphere.jacobian[p], kJacobianAt + 3 * p, components);
    Put(sphere.jacobian[p], kSphereJacobianAt + 3 * p, components);
  }
  gradient = Times(inverse, gradient);
  Put(gradient, kGradientAt, components);
  Put(Across(gradient, m), kTangentialAt, components);
  Put(Across(hemisphere.vector, n), kNormalAt, components);
  Put(hemisphere.vector, kVectorAt, components);
  Put(sphere.vector, kSphereAt, components);
  components[kFluxAt] = inverse * Dot(n, sphere.vector);
  for (Ball<T>& x : components)
    x = scale * x;
  return components;
}

template std::array<BallField<double>, 3> BallFieldsOf(const WeightedContour&,
                                                       BallGeometry<double>&);
template std::array<BallField<DoubleDouble>, 3> BallFieldsOf(
    const WeightedContour&, BallGeometry<DoubleDouble>&);
template ComponentArray<Ball<double>> BallComponentsOf(
    const BallField<double>&, const BallField<double>&,
    const BallVector<double>&, const BallVector<double>&, const Ball<double>&);
template ComponentArray<Ball<DoubleDouble>> BallComponentsOf(
    const BallField<DoubleDouble>&, const BallField<DoubleDouble>&,
    const BallVector<DoubleDouble>&, const BallVector<DoubleDouble>&,
    const Ball<DoubleDouble>&);

}  // namespace truelux
