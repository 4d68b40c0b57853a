#include "radiometry/evaluate.h"

#include <vector>

#include "radiometry/weighted_contour.h"

namespace truelux {
namespace {

/// The emission of every source of the contour.
std::vector<Rgb> WeightsOf(const ContourQuery& query, const Contour& contour) {
  std::vector<Rgb> weights;
  weights.reserve(contour.sources.size());
  for (const SourceArcs& source : contour.sources) {
    if (query.only_source != 0) {
      weights.push_back({1, 1, 1});
      continue;
    }
    const Facet& facet =
        query.scene.facets()[static_cast<std::size_t>(source.facet)];
    weights.push_back(
        query.scene.faces()[static_cast<std::size_t>(facet.face)].emission);
  }
  return weights;
}

}  // namespace

Irradiance EvaluateContour(const ContourQuery& query, const Contour& contour,
                           const EvaluationQuery& evaluation) {
  const std::vector<Rgb> weights = WeightsOf(query, contour);
  EvaluationQuery used = evaluation;
  // A form factor is E with M = 1, however the scene's emission is read.
  if (query.only_source != 0) used.emission = Emission::kExitance;
  Irradiance result = EvaluateWeighted({ViewOf(query), contour, weights}, used);
  result.statistics += contour.statistics;
  return result;
}

}  // namespace truelux
