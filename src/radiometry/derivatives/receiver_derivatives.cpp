// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/derivatives/receiver_derivatives.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "exact/recipe_evaluator.h"
#include "radiometry/derivatives/components.h"
#include "radiometry/derivatives/derivative_finder.h"
#include "radiometry/derivatives/kink_planes.h"
#include "radiometry/derivatives/limits.h"
#include "radiometry/evaluate.h"
#include "radiometry/stages/rounding.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

/// The components of one channel by their names.
ChannelDerivatives Named(std::span<const double> c) {
  const auto vector = [c](std::size_t at) {
    return Vector3{c[at], c[at + 1], c[at + 2]};
  };
  const auto matrix = [c](std::size_t at) {
    Matrix3 m{};
    for (std::size_t p = 0; p < 3; ++p) {
      for (std::size_t k = 0; k < 3; ++k)
        m[p][k] = c[at + 3 * p + k];
    }
    return m;
  };
  return {vector(kGradientAt), vector(kTangentialAt),    vector(kNormalAt),
          vector(kVectorAt),   matrix(kJacobianAt),      vector(kSphereAt),
          c[kFluxAt],          matrix(kSphereJacobianAt)};
}

/// The normal of the face that the receiver lies on, else its own.
Vec3<Exact> SurfaceOf(const ContourQuery& query) {
  const RecipeEvaluator<Exact> exact(ViewOf(query));
  const FaceNumber number(query.receiver.on_face);
  if (number.valid()) {
    const Face& face = FacesOf(query.scene)[IndexOf(number)];
    for (const FacetId facet : FacetsOf(face)) {
      return exact.TriangleNormal(
          FirstTriangleOf(FacetsOf(query.scene)[facet]));
    }
  }
  return exact.ReceiverNormal();
}

void TakeKinks(const JacobianLimits& limits, const Vec3<Exact>& normal,
               Emission emission, Derivatives& result) {
  for (const JacobianJump& jump : limits.jumps) {
    Kink kink;
    bool any = false;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const slong p = limits.size[channel].precision();
      const Vec3<ArbReal> n = ArbVector(p, normal);
      ArbReal b = Dot(n, jump.height[channel]) / Sqrt(Dot(n, n));
      if (limits.IsZero(b, channel)) continue;
      if (emission == Emission::kRadiance) b = b * ArbReal::Pi(p);
      kink.size[channel] = b.Nearest();
      any = true;
    }
    if (!any) continue;
    kink.normal = {jump.normal.x.Nearest(), jump.normal.y.Nearest(),
                   jump.normal.z.Nearest()};
    for (const FaceNumber face : jump.plane->faces)
      kink.faces.push_back(face.value());
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t k = 0; k < 2; ++k)
        kink.edges[i][k] = jump.plane->edges[i][k].value();
    }
    result.kinks.push_back(std::move(kink));
  }
  if (!result.kinks.empty()) result.smoothness = Smoothness::kKink;
}

FieldRegion RegionOf(const ContourEngine& engine, const ContourQuery& query,
                     std::span<const KinkPlane> planes,
                     const Contour& contour) {
  FieldRegion region;
  region.view = ViewOf(query);
  region.contour = contour;
  FindWeights(query, contour, region.weights);
  if (!planes.empty()) region.limits = FindLimits(engine, query, planes);
  return region;
}

/// E: what was found on the way, if that is all.
Irradiance IrradianceOf(const FoundComponents& found, const ContourQuery& query,
                        const FieldRegion& hemisphere,
                        const EvaluationQuery& evaluation,
                        EvaluationWorkspace& workspace) {
  Irradiance irradiance;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    if (!hemisphere.IsLit(channel)) continue;
    const std::optional<double>& value = found.irradiance[channel];
    if (evaluation.method != Method::kCertified || !value ||
        !std::isfinite(*value)) {
      return EvaluateContour(query, hemisphere.contour, evaluation, workspace);
    }
    irradiance.value[channel] = *value;
    irradiance.bound[channel] = HalfSpacing(*value);
    irradiance.statistics.evaluated_double_double = 1;
  }
  if (irradiance.statistics.evaluated_double_double == 0)
    irradiance.statistics.evaluated_zero = 1;
  irradiance.statistics += hemisphere.contour.statistics;
  return irradiance;
}

}  // namespace

Derivatives DerivativesAt(const ContourEngine& engine, ContourQuery query,
                          const EvaluationQuery& evaluation,
                          const DerivativeOptions& options,
                          bool wants_irradiance, OracleWorkspace& workspace) {
  Derivatives result;
  workspace.builder.Build(query, workspace.contour);
  // E and its gradient have no kink in the receiver plane.
  const auto find_candidates = [&] {
    return FindKinkPlanes(
        engine, query, workspace.Lines(engine).Find(query, options.jacobian));
  };
  KinkCandidates candidates = find_candidates();
  const bool was_touched = candidates.touched.valid();
  if (was_touched) {
    if (wants_irradiance) {
      result.irradiance = EvaluateContour(query, workspace.contour, evaluation,
                                          workspace.evaluation);
    }
    if (!candidates.touched_is_level) {
      result.smoothness = Smoothness::kDiscontinuous;
      return result;
    }
    // For motions on the lit side it is as if the face were not there.
    query.receiver.on_face = candidates.touched.value();
    candidates = find_candidates();
    workspace.builder.Build(query, workspace.contour);
  }
  const Vec3<Exact> normal =
      RecipeEvaluator<Exact>(ViewOf(query)).ReceiverNormal();
  const auto planes_but = [&candidates](bool KinkPlane::*left_out) {
    std::vector<KinkPlane> planes;
    std::ranges::remove_copy_if(candidates.planes, std::back_inserter(planes),
                                left_out);
    return planes;
  };
  const std::vector<KinkPlane> planes =
      options.jacobian ? candidates.planes : planes_but(&KinkPlane::is_level);
  const FieldRegion hemisphere =
      RegionOf(engine, query, planes, workspace.contour);
  FieldRegion sphere;
  const std::vector<KinkPlane> sphere_planes =
      planes_but(&KinkPlane::is_horizon_only);
  if (options.sphere) {
    ContourQuery whole = query;
    whole.whole_sphere = true;
    workspace.builder.Build(whole, workspace.contour);
    sphere = RegionOf(engine, whole, sphere_planes, workspace.contour);
  }
  if (hemisphere.limits)
    TakeKinks(*hemisphere.limits, normal, evaluation.emission, result);
  const FoundComponents found =
      FindComponents({hemisphere, sphere, normal, SurfaceOf(query),
                      evaluation.method, evaluation.emission},
                     options, workspace.evaluation);
  const CertifiedNumbers& numbers = found.numbers;
  if (wants_irradiance && !was_touched) {
    result.irradiance = IrradianceOf(found, query, hemisphere, evaluation,
                                     workspace.evaluation);
  }
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const auto of_channel = [channel](const std::vector<double>& of_all) {
      return std::span(of_all).subspan(channel * kComponentCount,
                                       kComponentCount);
    };
    result.channels[channel] = Named(of_channel(numbers.values));
    result.bounds[channel] = Named(of_channel(numbers.bounds));
  }
  result.undecided = numbers.undecided;
  return result;
}

}  // namespace truelux
