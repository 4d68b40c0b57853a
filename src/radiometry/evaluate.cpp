#include "radiometry/evaluate.h"

#include <vector>

#include "radiometry/evaluate_weighted.h"
#include "radiometry/evaluation_workspace.h"
#include "radiometry/weighted_contour.h"

namespace truelux {
Rgb WeightOf(const ContourQuery& query, int facet) {
  if (query.only_source != 0) return {1, 1, 1};
  const int face = query.scene.facets()[static_cast<std::size_t>(facet)].face;
  return query.scene.faces()[static_cast<std::size_t>(face)].emission;
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
  if (query.only_source != 0) used.emission = Emission::kExitance;
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
