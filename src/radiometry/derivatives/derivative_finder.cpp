// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/derivatives/derivative_finder.h"

#include <array>
#include <cmath>
#include <type_traits>

#include "exact/angle_sum.h"
#include "exact/ball_recipe.h"
#include "radiometry/derivatives/ball_arcs.h"
#include "radiometry/derivatives/ball_field.h"
#include "radiometry/derivatives/components.h"
#include "radiometry/derivatives/field.h"
#include "radiometry/stages/rounding.h"

namespace truelux {
namespace {

RationalVector Axis(std::size_t k) {
  return {mpq_class(k == 0 ? 1 : 0), mpq_class(k == 1 ? 1 : 0),
          mpq_class(k == 2 ? 1 : 0)};
}

/// v^2 e_k - v v_k: times a vector, v^2 times component k of what is across v.
RationalVector Across(const RationalVector& v, std::size_t k) {
  const RationalVector axis = Axis(k);
  const mpq_class along = Dot(v, axis);
  const mpq_class square = Dot(v, v);
  return square * axis - along * v;
}

/// Per channel the sum over the sources.
std::array<Field<ArbReal>, 3> FieldsAt(const FieldRegion& region,
                                       slong precision) {
  const auto fields =
      ArbFieldsOf(region.Moving(), region.weights.size(), precision);
  std::array<Field<ArbReal>, 3> sums;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    sums[channel] = NoField(precision);
    for (std::size_t s = 0; s < region.weights.size(); ++s) {
      const double weight = region.weights[s][channel];
      if (weight == 0) continue;
      AddTimes(fields[s], ArbReal(precision, Exact(weight)), sums[channel]);
    }
    if (!region.limits) continue;
    const ArbReal error = region.limits->size[channel].TimesTwoTo(-500);
    for (std::size_t p = 0; p < 3; ++p) {
      const Vec3<ArbReal>& row = region.limits->mean[channel][p];
      sums[channel].jacobian[p] = {row.x.WidenedBy(error),
                                   row.y.WidenedBy(error),
                                   row.z.WidenedBy(error)};
    }
  }
  return sums;
}

/// The answer that a ball gives, if it gives one: certified by double-double, or
/// whatever is bounded in double.
bool TakeAnswer(const Ball<DoubleDouble>& ball, double& value, double& bound) {
  const auto rounded = RoundIfCertain(ball);
  if (!rounded) return false;
  value = *rounded;
  bound = HalfSpacing(std::fabs(value));
  return true;
}

bool TakeAnswer(const Ball<double>& ball, double& value, double& bound) {
  if (!IsBounded(ball)) return false;
  value = ball.value;
  bound = ball.error;
  return true;
}

class DerivativeFinder {
 public:
  explicit DerivativeFinder(const FinderQuery& query) : query_(query) {}

  FoundComponents Find(const DerivativeOptions& options,
                       EvaluationWorkspace& workspace) const {
    std::vector<bool> open;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      for (std::size_t k = 0; k < kComponentCount; ++k)
        open.push_back(IsAsked(k, options) && MayDiffer(channel, k));
    }
    FoundComponents found;
    CertifiedNumbers& numbers = found.numbers;
    numbers.values.resize(open.size());
    numbers.bounds.resize(open.size());
    // With limits there is more than the arcs at r.
    if (!query_.hemisphere.limits) {
      if (query_.method == Method::kDouble)
        AnswerInBalls(options, workspace.plain, open, found);
      AnswerInBalls(options, workspace.double_double, open, found);
    }
    if (!IsAny(open)) return found;
    const CertifiedNumbers rest =
        Certify({[this](slong precision) { return At(precision); },
                 [this](std::size_t number, const ArbReal& enclosure) {
                   return IsZero(number / kComponentCount,
                                 number % kComponentCount, enclosure);
                 }},
                open);
    for (std::size_t i = 0; i < open.size(); ++i) {
      if (!open[i]) continue;
      numbers.values[i] = rest.values[i];
      numbers.bounds[i] = rest.bounds[i];
    }
    numbers.undecided = rest.undecided;
    return found;
  }

 private:
  static bool IsAny(const std::vector<bool>& flags) {
    return std::find(flags.begin(), flags.end(), true) != flags.end();
  }

  static bool IsAsked(std::size_t component, const DerivativeOptions& options) {
    const bool is_jacobian =
        (component >= kJacobianAt && component < kSphereAt) ||
        component >= kSphereJacobianAt;
    return (options.sphere || !IsOfSphere(component)) &&
           (options.jacobian || !is_jacobian);
  }

  /// False where a component is known to be 0: without light, also beside the
  /// receiver; or what is across a normal, along an axis in which that normal
  /// points.
  [[nodiscard]] bool MayDiffer(std::size_t channel,
                               std::size_t component) const {
    const FieldRegion& region =
        IsOfSphere(component) ? query_.sphere : query_.hemisphere;
    if (!region.IsLit(channel) && !(IsByPosition(component) && region.limits))
      return false;
    const auto is_along = [](const Vec3<Exact>& v, std::size_t k) {
      return (k == 0 || v.x.is_zero()) && (k == 1 || v.y.is_zero()) &&
             (k == 2 || v.z.is_zero());
    };
    if (component >= kTangentialAt && component < kNormalAt)
      return !is_along(query_.surface, component - kTangentialAt);
    return component < kNormalAt || component >= kVectorAt ||
           !is_along(query_.normal, component - kNormalAt);
  }

  /// Answers what balls bound well enough, and closes it.
  template <class T>
  void AnswerInBalls(const DerivativeOptions& options,
                     BallGeometry<T>& geometry, std::vector<bool>& open,
                     FoundComponents& found) const {
    if (!IsAny(open)) return;
    const auto fields = [&geometry](const FieldRegion& region,
                                    const FieldParts& parts) {
      if (region.contour.sources.empty()) return BallFields<T>{};
      return BallFieldsOf<T>({region.view, region.contour, region.weights},
                             parts, geometry);
    };
    const BallFields<T> hemisphere =
        fields(query_.hemisphere, {options.jacobian, true});
    const BallFields<T> sphere =
        fields(query_.sphere, {options.jacobian, false});
    const BallVector<T>& n = geometry.receiver_normal();
    const auto m = ScaleToUnit<T>(query_.surface).vector;
    std::optional<BallComponents<T>> common;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      if (!query_.hemisphere.IsLit(channel) && !query_.sphere.IsLit(channel))
        continue;
      if (IsOneField(hemisphere, sphere)) {
        if (!common)
          common = BallComponentsOf(hemisphere.common, sphere.common, n, m);
        const Rgb& weights = query_.hemisphere.contour.sources.empty()
                                 ? sphere.weights
                                 : hemisphere.weights;
        Take(*common, weights[channel], channel, open, found);
      } else {
        Take(BallComponentsOf(FieldOf(hemisphere, channel),
                              FieldOf(sphere, channel), n, m),
             1, channel, open, found);
      }
    }
  }

  /// Whether the channels differ by their weights alone.
  template <class T>
  [[nodiscard]] bool IsOneField(const BallFields<T>& hemisphere,
                                const BallFields<T>& sphere) const {
    if (!hemisphere.has_common || !sphere.has_common) return false;
    return query_.hemisphere.contour.sources.empty() ||
           query_.sphere.contour.sources.empty() ||
           hemisphere.weights == sphere.weights;
  }

  template <class T>
  static BallField<T> FieldOf(const BallFields<T>& fields,
                              std::size_t channel) {
    if (!fields.has_common) return fields.channels[channel];
    const Ball<T> weight(fields.weights[channel]);
    const BallField<T>& own = fields.common;
    BallField<T> field{
        Times(weight, own.vector), {}, Times(weight, own.moment)};
    for (std::size_t p = 0; p < 3; ++p)
      field.jacobian[p] = Times(weight, own.jacobian[p]);
    return field;
  }

  /// Takes the answers of one channel, the weight times the components.
  template <class T>
  void Take(const BallComponents<T>& all, double weight, std::size_t channel,
            std::vector<bool>& open, FoundComponents& found) const {
    Ball<T> scale(weight);
    if (query_.emission == Emission::kRadiance)
      scale = scale * (Ball<T>(2.0) * HalfPi<T>());
    CertifiedNumbers& numbers = found.numbers;
    for (std::size_t k = 0; k < kComponentCount; ++k) {
      const std::size_t i = channel * kComponentCount + k;
      if (open[i] && TakeAnswer(scale * all.components[k], numbers.values[i],
                                numbers.bounds[i])) {
        open[i] = false;
      }
    }
    if constexpr (std::is_same_v<T, DoubleDouble>) {
      if (query_.hemisphere.IsLit(channel))
        found.irradiance[channel] = RoundIfCertain(scale * all.irradiance);
    }
  }

  [[nodiscard]] std::vector<ArbReal> At(slong precision) const {
    std::vector<ArbReal> all;
    const auto hemisphere = FieldsAt(query_.hemisphere, precision);
    const auto sphere = FieldsAt(query_.sphere, precision);
    const Vec3<ArbReal> n = ArbVector(precision, query_.normal);
    const Vec3<ArbReal> m = ArbVector(precision, query_.surface);
    const bool is_radiance = query_.emission == Emission::kRadiance;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      for (const ArbReal& x :
           ComponentsOf(hemisphere[channel], sphere[channel], n, m)) {
        all.push_back(is_radiance ? x * ArbReal::Pi(precision) : x);
      }
    }
    return all;
  }

  [[nodiscard]] bool IsZero(std::size_t channel, std::size_t component,
                            const ArbReal& enclosure) const {
    const FieldRegion& region =
        IsOfSphere(component) ? query_.sphere : query_.hemisphere;
    if (IsByPosition(component)) {
      if (region.limits) return region.limits->IsZero(enclosure, channel);
      return IsZeroByPosition(region, channel, component);
    }
    const RationalVector n = RationalVectorOf(query_.normal);
    const RationalVector x =
        component < kVectorAt     ? Across(n, component - kNormalAt)
        : component < kJacobianAt ? Axis(component - kVectorAt)
        : component < kFluxAt     ? Axis(component - kSphereAt)
                                  : n;
    const auto& arcs = region.Rational();
    ExactForm form(arcs);
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      const double weight = WeightOf(region, i, channel);
      if (weight == 0) continue;
      const mpq_class along = Dot(x, arcs[i].normal);
      form.AddAngle(i, -arcs[i].outward * along * mpq_class(weight) / 2);
    }
    return form.IsZero();
  }

  [[nodiscard]] bool IsZeroByPosition(const FieldRegion& region,
                                      std::size_t channel,
                                      std::size_t component) const {
    RationalVector x = RationalVectorOf(query_.normal);
    RationalVector along = Axis(component % 3);
    if (component >= kSphereJacobianAt) {
      x = Axis((component - kSphereJacobianAt) / 3);
      along = Axis((component - kSphereJacobianAt) % 3);
    } else if (component >= kJacobianAt) {
      x = Axis((component - kJacobianAt) / 3);
      along = Axis((component - kJacobianAt) % 3);
    } else if (component >= kTangentialAt) {
      along =
          Across(RationalVectorOf(query_.surface), component - kTangentialAt);
    }
    const auto& arcs = region.Rational();
    ExactForm form(arcs);
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      const double weight = WeightOf(region, i, channel);
      if (weight == 0 || region.Moving().arcs[i].kind == ArcLine::kHorizon)
        continue;
      const RationalArc& arc = arcs[i];
      const mpq_class moved = Dot(arc.normal, along);
      form.AddMoment(i, -arc.outward * mpq_class(weight) * moved / arc.square,
                     x, Cross(arc.line, arc.normal));
    }
    return form.IsZero();
  }

  static double WeightOf(const FieldRegion& region, std::size_t arc,
                         std::size_t channel) {
    return region.weights[region.Moving().arcs[arc].source.index()][channel];
  }

  const FinderQuery& query_;
};

}  // namespace

FoundComponents FindComponents(const FinderQuery& query,
                               const DerivativeOptions& options,
                               EvaluationWorkspace& workspace) {
  return DerivativeFinder(query).Find(options, workspace);
}

}  // namespace truelux
