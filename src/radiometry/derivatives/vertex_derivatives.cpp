// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/derivatives/vertex_derivatives.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "exact/exact_conversion.h"
#include "radiometry/derivatives/arb_field.h"
#include "radiometry/derivatives/certify.h"
#include "radiometry/derivatives/exact_form.h"
#include "radiometry/derivatives/kink_planes.h"
#include "radiometry/derivatives/vertex_limits.h"
#include "radiometry/derivatives/vertex_suspects.h"
#include "radiometry/derivatives/vertex_terms.h"
#include "radiometry/evaluate.h"

namespace truelux {
namespace {

/// The vertices of one contour whose derivatives are sums over its arcs.
class SmoothVertices {
 public:
  SmoothVertices(const MovingContour& contour, const VertexTerms& terms,
                 const std::vector<Rgb>& weights, Emission emission)
      : contour_(contour), weights_(weights), emission_(emission) {
    for (const auto& [number, own] : terms) {
      numbers_.push_back(number);
      terms_.push_back(&own);
    }
    for (const MovingArc& arc : contour.arcs)
      rational_.emplace_back(arc);
  }

  void Find(VertexDerivatives& result) const {
    const CertifiedNumbers found =
        Certify({[this](slong precision) { return At(precision); },
                 [this](std::size_t i, const ArbReal&) { return IsZero(i); }},
                std::vector<bool>(9 * numbers_.size(), true));
    for (std::size_t v = 0; v < numbers_.size(); ++v) {
      VertexDerivative derivative;
      derivative.number = numbers_[v];
      for (std::size_t channel = 0; channel < 3; ++channel) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const std::size_t i = 9 * v + 3 * channel + axis;
          VertexSlope& slope = derivative.slopes[channel][axis];
          slope.left = slope.right = found.values[i];
          slope.bound = found.bounds[i];
        }
      }
      result.vertices.push_back(derivative);
    }
    result.undecided += found.undecided;
  }

 private:
  [[nodiscard]] std::vector<ArbReal> At(slong precision) const {
    std::vector<ArbReal> all;
    for (const std::vector<VertexTerm>* terms : terms_) {
      for (const Vec3<ArbReal>& v :
           VertexSums(contour_, *terms, weights_, emission_, precision)) {
        all.insert(all.end(), {v.x, v.y, v.z});
      }
    }
    return all;
  }

  [[nodiscard]] bool IsZero(std::size_t number) const {
    const std::size_t channel = number / 3 % 3;
    const RationalVector n = RationalVectorOf(contour_.receiver_normal);
    ExactForm form(rational_);
    for (const VertexTerm& term : *terms_[number / 9]) {
      const double weight =
          weights_[contour_.arcs[term.arc].source.index()][channel];
      const RationalVector direction = RationalVectorOf(term.direction);
      const std::array<const mpq_class*, 3> axes = {&direction.x, &direction.y,
                                                    &direction.z};
      form.AddMoment(term.arc,
                     mpq_class(weight) * RationalOf(term.above) /
                         RationalOf(term.below) * *axes[number % 3],
                     n, RationalVectorOf(term.y));
    }
    return form.IsZero();
  }

  const MovingContour& contour_;
  const std::vector<Rgb>& weights_;
  Emission emission_;
  std::vector<int> numbers_;
  std::vector<const std::vector<VertexTerm>*> terms_;
  std::vector<RationalArc> rational_;
};

bool IsNothing(const VertexDerivative& derivative) {
  return std::ranges::all_of(derivative.slopes, [](const auto& channel) {
    return std::ranges::all_of(channel, [](const VertexSlope& slope) {
      return slope.IsSmooth() && slope.left == 0 && slope.bound == 0;
    });
  });
}

}  // namespace

VertexDerivatives VertexDerivativesAt(
    const ContourEngine& engine,
    const std::function<const LooseEngine&()>& loose, ContourQuery query,
    const EvaluationQuery& evaluation, OracleWorkspace& workspace) {
  VertexDerivatives result;
  workspace.builder.StartBlock({});
  workspace.builder.Build(query, workspace.contour);
  result.irradiance = EvaluateContour(query, workspace.contour, evaluation,
                                      workspace.evaluation);
  SeenLineFinder& lines = workspace.Lines(engine);
  const KinkCandidates candidates =
      FindKinkPlanes(engine, query, lines.Find(query));
  if (candidates.touched.valid()) {
    if (!candidates.touched_is_level) {
      result.smoothness = Smoothness::kDiscontinuous;
      return result;
    }
    query.receiver.on_face = candidates.touched.value();
    workspace.builder.Build(query, workspace.contour);
  }
  const ReceiverView view = ViewOf(query);
  MovingContour contour = MovingContourOf(view, workspace.contour);
  SplitCuts(view, query.scene, contour);
  VertexTerms terms = VertexTermsOf(view, query.scene, contour);
  std::vector<Rgb> weights;
  FindWeights(query, workspace.contour, weights);
  const std::set<int> suspects = FindSuspects(engine, query, lines.Find(query));
  for (const int suspect : suspects)
    terms.erase(suspect);
  SmoothVertices(contour, terms, weights, evaluation.emission).Find(result);
  if (!suspects.empty()) {
    VertexLimits limits(loose(), query, evaluation.emission);
    for (const int suspect : suspects)
      result.vertices.push_back(limits.At(suspect));
  }
  std::erase_if(result.vertices, IsNothing);
  std::ranges::sort(result.vertices, {}, &VertexDerivative::number);
  return result;
}

}  // namespace truelux
