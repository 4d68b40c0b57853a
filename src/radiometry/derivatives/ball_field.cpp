// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/derivatives/ball_field.h"

#include <optional>

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

/// The sums of a field while they grow.
template <class T>
struct FieldSum {
  VectorSum<T> vector;
  std::array<VectorSum<T>, 3> jacobian;
  VectorSum<T> moment;

  [[nodiscard]] BallField<T> Get() const {
    return {vector.Get(),
            {jacobian[0].Get(), jacobian[1].Get(), jacobian[2].Get()},
            moment.Get()};
  }

  /// Adds a field times s.
  void Add(const Ball<T>& s, const BallField<T>& field) {
    vector.Add(s, field.vector);
    for (std::size_t p = 0; p < 3; ++p)
      jacobian[p].Add(s, field.jacobian[p]);
    moment.Add(s, field.moment);
  }
};

/// Sums the arcs' terms.
template <class T>
class FieldSummer {
 public:
  FieldSummer(const WeightedContour& contour, const FieldParts& parts,
              BallGeometry<T>& geometry)
      : parts_(parts), arcs_(contour, geometry) {
    if (!HasPosition()) return;
    for (const PlaneId id : contour.contour.planes.ids())
      inverses_.push_back(InverseAt(id));
    if (parts_.jacobian) return;
    for (const DirectionId id : contour.contour.directions.ids())
      rises_.push_back(Dot(arcs_.ReceiverNormal(), arcs_.Unit(id)));
  }

  [[nodiscard]] BallFields<T> Find() const {
    const WeightedContour& contour = arcs_.contour();
    const std::optional<Rgb> common = CommonWeights(contour);
    BallFields<T> fields;
    fields.has_common = common.has_value();
    fields.weights = common.value_or(Rgb{});
    const Ball<T> inverse_pi = Ball<T>(0.5) / HalfPi<T>();
    FieldSum<T> all;
    std::array<FieldSum<T>, 3> channels;
    for (const SourceId source : contour.contour.sources.ids()) {
      if (!contour.IsLit(source)) continue;
      if (fields.has_common) {
        AddSource(source, all);
        continue;
      }
      FieldSum<T> own;
      AddSource(source, own);
      const BallField<T> field = Finished(own);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const double weight = contour.WeightOf(source)[channel];
        if (weight != 0)
          channels[channel].Add(inverse_pi * Ball<T>(weight), field);
      }
    }
    if (fields.has_common) {
      FieldSum<T> scaled;
      scaled.Add(inverse_pi, Finished(all));
      fields.common = scaled.Get();
    } else {
      for (std::size_t channel = 0; channel < 3; ++channel)
        fields.channels[channel] = channels[channel].Get();
    }
    return fields;
  }

 private:
  [[nodiscard]] bool HasPosition() const {
    return parts_.jacobian || parts_.moment;
  }

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

  void AddSource(SourceId source, FieldSum<T>& sum) const {
    for (const Arc& arc : arcs_.contour().ArcsOf(source))
      AddArc(arc, sum);
  }

  /// With n.J, which J has.
  [[nodiscard]] BallField<T> Finished(const FieldSum<T>& sum) const {
    BallField<T> field = sum.Get();
    if (!parts_.jacobian) return field;
    VectorSum<T> moment;
    for (std::size_t p = 0; p < 3; ++p)
      moment.Add(Component(arcs_.ReceiverNormal(), p), field.jacobian[p]);
    field.moment = moment.Get();
    return field;
  }

  /// -beta/2 m_out to V, -K m_out^T to J.
  void AddArc(const Arc& arc, FieldSum<T>& sum) const {
    const BallArc<T> own = arcs_.At(arc);
    sum.vector.Add(Ball<T>(0.5) * own.angle, own.inward);
    if (!HasPosition() || IsHorizon(arc.plane)) return;
    // K = W G = a (u1 + u2) + b (u2 - u1). On a short arc b is known badly, but
    // what it is a factor of is short.
    const BallVector<T>& u1 = arcs_.Unit(arc.from);
    const BallVector<T>& u2 = arcs_.Unit(arc.to);
    const Ball<T> q1 = Dot(inverses_[arc.plane], u1);
    const Ball<T> q2 = Dot(inverses_[arc.plane], u2);
    const Ball<T> a = own.a * (q1 + q2);
    const Ball<T> b = own.b * (q2 - q1);
    if (!parts_.jacobian) {
      const Ball<T>& rise1 = rises_[arc.from];
      const Ball<T>& rise2 = rises_[arc.to];
      sum.moment.Add(a * (rise1 + rise2) + b * (rise2 - rise1), own.inward);
      return;
    }
    const BallVector<T> k = Combined(a, Sum(u1, u2), b, Sum(u2, -u1));
    for (std::size_t p = 0; p < 3; ++p)
      sum.jacobian[p].Add(Component(k, p), own.inward);
  }

  FieldParts parts_;
  BallArcs<T> arcs_;
  IdVector<PlaneId, BallVector<T>> inverses_;
  IdVector<DirectionId, Ball<T>> rises_;  ///< n.u, unless J is wanted
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
  return Combined(Ball<T>(1.0), v, -(Dot(v, m) / Dot(m, m)), m);
}

}  // namespace

template <class T>
BallFields<T> BallFieldsOf(const WeightedContour& contour,
                           const FieldParts& parts, BallGeometry<T>& geometry) {
  return FieldSummer<T>(contour, parts, geometry).Find();
}

template <class T>
BallComponents<T> BallComponentsOf(const BallField<T>& hemisphere,
                                   const BallField<T>& sphere,
                                   const BallVector<T>& n,
                                   const BallVector<T>& m) {
  BallComponents<T> all;
  ComponentArray<Ball<T>>& components = all.components;
  const Ball<T> inverse = Ball<T>(1.0) / Length(n);
  for (std::size_t p = 0; p < 3; ++p) {
    Put(hemisphere.jacobian[p], kJacobianAt + 3 * p, components);
    Put(sphere.jacobian[p], kSphereJacobianAt + 3 * p, components);
  }
  const BallVector<T> gradient = Times(inverse, hemisphere.moment);
  Put(gradient, kGradientAt, components);
  Put(Across(gradient, m), kTangentialAt, components);
  Put(Across(hemisphere.vector, n), kNormalAt, components);
  Put(hemisphere.vector, kVectorAt, components);
  Put(sphere.vector, kSphereAt, components);
  components[kFluxAt] = inverse * Dot(n, sphere.vector);
  all.irradiance = inverse * Dot(n, hemisphere.vector);
  return all;
}

template BallFields<double> BallFieldsOf(const WeightedContour&,
                                         const FieldParts&,
                                         BallGeometry<double>&);
template BallFields<DoubleDouble> BallFieldsOf(const WeightedContour&,
                                               const FieldParts&,
                                               BallGeometry<DoubleDouble>&);
template BallComponents<double> BallComponentsOf(const BallField<double>&,
                                                 const BallField<double>&,
                                                 const BallVector<double>&,
                                                 const BallVector<double>&);
template BallComponents<DoubleDouble> BallComponentsOf(
    const BallField<DoubleDouble>&, const BallField<DoubleDouble>&,
    const BallVector<DoubleDouble>&, const BallVector<DoubleDouble>&);

}  // namespace truelux
