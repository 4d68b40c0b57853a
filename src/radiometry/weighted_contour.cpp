// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/weighted_contour.h"

#include "exact/ball_recipe.h"
#include "exact/recipe_evaluator.h"

namespace truelux {
namespace {

bool MayBeZero(const Ball<double>& x) {
  // Written so that a NaN bound answers yes.
  return !(LowerMagnitude(x.value) > x.error);
}

bool IsParallel(const WeightedContour& contour, const PlaneRecipe& plane) {
  if (plane.kind() == PlaneRecipe::Kind::kHorizon) return true;
  const auto explicit_vectors = contour.contour.explicit_vectors.All();
  const RecipeEvaluator<Ball<double>> rounded(contour.view);
  const Vec3<Ball<double>> w =
      Cross(rounded.ReceiverNormal(), rounded.Plane(plane, explicit_vectors));
  if (!MayBeZero(w.x) || !MayBeZero(w.y) || !MayBeZero(w.z)) return false;
  const RecipeEvaluator<Exact> exact(contour.view);
  return IsZero(
      Cross(exact.ReceiverNormal(), exact.Plane(plane, explicit_vectors)));
}

}  // namespace

bool WeightedContour::IsLit(SourceId source) const {
  return IsLit(source, 0) || IsLit(source, 1) || IsLit(source, 2);
}

std::optional<Rgb> CommonWeights(const WeightedContour& contour) {
  std::optional<Rgb> common;
  for (const SourceId source : contour.contour.sources.ids()) {
    if (!contour.IsLit(source)) continue;
    if (common && contour.WeightOf(source) != *common) return std::nullopt;
    common = contour.WeightOf(source);
  }
  return common;
}

HorizonPlanes PlanesOnHorizon(const WeightedContour& contour) {
  HorizonPlanes result;
  result.reserve(contour.contour.planes.size());
  for (const PlaneRecipe& plane : contour.contour.planes) {
    result.push_back(IsParallel(contour, plane));
  }
  return result;
}

}  // namespace truelux
