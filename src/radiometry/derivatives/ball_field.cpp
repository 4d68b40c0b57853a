// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/derivatives/ball_field.h"

#include "exact/ball_recipe.h"
#include "exact/recipe_evaluator.h"
#include "radiometry/stages/ball_terms.h"

namespace truelux {
namespace {

template <class T>
BallVector<T> Sum(const BallVector<T>& a, const BallVector<T>& b) {
  BallVector<T> sum;
  for (std::size_t k = 0; k < 3; ++k)
    sum.value[k] = a.value[k] + b.value[k];
  sum.length = LengthOf(sum.value);
  sum.error =
      RoundBoundUp(a.error + b.error + RoundingError<T>::kSum * sum.length);
  return sum;
}

template <class T>
BallVector<T> Times(const Ball<T>& s, const BallVector<T>& v) {
  BallVector<T> product;
  for (std::size_t k = 0; k < 3; ++k)
    product.value[k] = s.value * v.value[k];
  product.length = LengthOf(product.value);
  product.error = RoundBoundUp(s.error * (v.length + v.error) +
                               Magnitude(s.value) * v.error +
                               RoundingError<T>::kProduct * product.length);
  return product;
}

/// v 2^exponent.
template <class T>
BallVector<T> Shifted(const BallVector<T>& v, int exponent) {
  if (exponent < -800 || exponent > 800)
    return {v.value, v.length, std::numeric_limits<double>::infinity()};
  const double factor = PowerOfTwo(exponent);
  BallVector<T> shifted;
  for (std::size_t k = 0; k < 3; ++k)
    shifted.value[k] = TimesPowerOfTwo(v.value[k], factor);
  shifted.length = LengthOf(shifted.value);
  shifted.error = v.error * factor + kUnderflow;
  return shifted;
}

template <class T>
BallVector<T> UnitOf(const BallVector<T>& v) {
  return Times(Ball<T>(1.0) / Length(v), v);
}

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

/// What all arcs of a plane need.
template <class T>
struct FieldPlane {
  bool is_horizon = false;
  BallVector<T> unit;     ///< N / |N|
  BallVector<T> inverse;  ///< G = (L x N) / N^2, 1/rho = G . w
};

template <class T>
class FieldSummer {
 public:
  FieldSummer(const WeightedContour& contour, BallGeometry<T>& geometry)
      : contour_(contour), geometry_(geometry) {
    geometry.Evaluate(contour);
    const Contour& c = contour.contour;
    for (const DirectionId id : c.directions.ids())
      units_.push_back(UnitOf(geometry.Direction(id).scaled.vector));
    for (const PlaneId id : c.planes.ids())
      planes_.push_back(PlaneAt(id));
  }

  std::array<BallField<T>, 3> Find() const {
    std::array<BallField<T>, 3> fields{};
    const Ball<T> inverse_pi = Ball<T>(0.5) / HalfPi<T>();
    for (const SourceId source : contour_.contour.sources.ids()) {
      if (!contour_.IsLit(source)) continue;
      BallField<T> own{};
      for (const Arc& arc : contour_.ArcsOf(source))
        Add(arc, own);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const double weight = contour_.WeightOf(source)[channel];
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
  [[nodiscard]] FieldPlane<T> PlaneAt(PlaneId id) const {
    const PlaneRecipe& recipe = contour_.contour.planes[id];
    const BallPlane<T>& plane = geometry_.Plane(id);
    const BallVector<T>& n = plane.normal.vector;
    FieldPlane<T> result;
    result.unit = Times(Ball<T>(1.0) / plane.length, n);
    result.is_horizon = recipe.kind() == PlaneRecipe::Kind::kHorizon;
    if (result.is_horizon) return result;
    const ScaledVector<T> line = LineOf<T>(contour_, recipe);
    const BallVector<T> across = Cross(line.vector, n);
    result.inverse = Shifted(Times(Ball<T>(1.0) / Dot(n, n), across),
                             line.exponent - plane.normal.exponent);
    return result;
  }

  /// The sine of an arc's angle.
  [[nodiscard]] Ball<T> SineOf(const Arc& arc) const {
    const BallPlane<T>& plane = geometry_.Plane(arc.plane);
    const BallDirection<T>& d1 = geometry_.Direction(arc.from);
    const BallDirection<T>& d2 = geometry_.Direction(arc.to);
    const Ball<T> across =
        plane.length * CrossAlongAxis(plane, d1, d2, arc.positive);
    return across / (plane.along_axis * Length(d1.scaled.vector) *
                     Length(d2.scaled.vector));
  }

  /// -beta/2 m_out to V, -K m_out^T to J.
  void Add(const Arc& arc, BallField<T>& field) const {
    const FieldPlane<T>& plane = planes_[arc.plane];
    const BallVector<T>& u1 = units_[arc.from];
    const BallVector<T>& u2 = units_[arc.to];
    // Out of the visible side: -N where that is N.d > 0.
    const BallVector<T> inward = arc.positive ? plane.unit : -plane.unit;
    const Ball<T> sine = ClampToNonNegative(SineOf(arc));
    const Ball<T> cosine = Dot(u1, u2);
    const Ball<T> angle = AngleInHalfPlane(sine, cosine);
    field.vector = Sum(field.vector, Times(Ball<T>(0.5) * angle, inward));
    if (plane.is_horizon) return;
    // K = A (q1 + q2)(u1 + u2) + B (q2 - q1)(u2 - u1), q = 1/rho at the ends.
    const Ball<T> quarter(0.25);
    const Ball<T> wide = Ball<T>(1.0) + cosine;
    const Ball<T> a = quarter * (angle + sine) / wide;
    const Ball<T> b = quarter * (angle - sine) * wide / (sine * sine);
    const Ball<T> q1 = Dot(plane.inverse, u1);
    const Ball<T> q2 = Dot(plane.inverse, u2);
    const BallVector<T> k = Sum(Times(a * (q1 + q2), Sum(u1, u2)),
                                Times(b * (q2 - q1), Sum(u2, -u1)));
    for (std::size_t p = 0; p < 3; ++p) {
      field.jacobian[p] =
          Sum(field.jacobian[p], Times(Component(k, p), inward));
    }
  }

  const WeightedContour& contour_;
  const BallGeometry<T>& geometry_;
  IdVector<DirectionId, BallVector<T>> units_;
  IdVector<PlaneId, FieldPlane<T>> planes_;
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
