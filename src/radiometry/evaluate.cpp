// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/evaluate.h"

#include <vector>

#include "radiometry/evaluate_weighted.h"
#include "radiometry/evaluation_workspace.h"
#include "radiometry/weighted_contour.h"
#include "scene/scene_access.h"

namespace truelux {

Rgb WeightOf(const ContourQuery& query, FacetId facet) {
  if (query.only_source.valid()) return {1, 1, 1};
  return FacesOf(query.scene)[FaceOf(query.scene, facet)].emission;
}

void FindWeights(const ContourQuery& query, const Contour& contour,
                 std::vector<Rgb>& weights) {
  weights.clear();
  for (const SourceArcs& source : contour.sources) {
    weights.push_back(WeightOf(query, source.facet));
  }
}

Irradiance EvaluateContour(const ContourQuery& query, const Contour& contour,
                           const EvaluationQuery& evaluation,
                           EvaluationWorkspace& workspace) {
  FindWeights(query, contour, workspace.weights);
  EvaluationQuery used = evaluation;
  // A form factor is E with M = 1, however the scene's emission is read.
  if (query.only_source.valid()) used.emission = Emission::kExitance;
  Irradiance result = EvaluateWeighted(
      {ViewOf(query), contour, workspace.weights}, used, workspace);
  result.statistics += contour.statistics;
  return result;
}

Irradiance EvaluateContour(const ContourQuery& query, const Contour& contour,
                           const EvaluationQuery& evaluation) {
  EvaluationWorkspace workspace;
  return EvaluateContour(query, contour, evaluation, workspace);
}

}  // namespace truelux
