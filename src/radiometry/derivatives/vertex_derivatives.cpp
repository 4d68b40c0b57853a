// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/derivatives/vertex_derivatives.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "exact/exact_conversion.h"
#include "radiometry/derivatives/arb_field.h"
#include "radiometry/derivatives/certify.h"
#include "radiometry/derivatives/exact_form.h"
#include "radiometry/derivatives/kink_planes.h"
#include "radiometry/derivatives/vertex_balls.h"
#include "radiometry/derivatives/vertex_limits.h"
#include "radiometry/derivatives/vertex_suspects.h"
#include "radiometry/derivatives/vertex_terms.h"
#include "radiometry/evaluate.h"
#include "radiometry/stages/rounding.h"

namespace truelux {
namespace {

/// Vertices that double-double leaves open, and which of their numbers: nine a
/// vertex, axis by axis for each channel.
struct OpenVertices {
  std::vector<std::size_t> places;  ///< in VertexDerivatives::vertices
  std::vector<bool> numbers;
};

/// Puts the derivatives of vertices whose derivatives are sums over arcs into
/// `vertices`, as far as balls say them. suspects: are left out.
OpenVertices TakeBalls(const std::vector<VertexBall<DoubleDouble>>& balls,
                       const std::set<int>& suspects,
                       std::vector<VertexDerivative>& vertices) {
  OpenVertices open;
  for (const VertexBall<DoubleDouble>& ball : balls) {
    if (suspects.contains(ball.number)) continue;
    VertexDerivative& derivative = vertices.emplace_back();
    derivative.number = ball.number;
    std::vector<bool> left;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        VertexSlope& slope = derivative.slopes[channel][axis];
        const auto rounded =
            ball.has_cuts
                ? std::nullopt
                : RoundIfCertain(Component(ball.slopes[channel], axis));
        left.push_back(!rounded &&
                       (ball.has_cuts || !ball.is_zero[channel][axis]));
        if (!rounded || ball.is_zero[channel][axis]) continue;
        slope.left = slope.right = *rounded;
        slope.bound = HalfSpacing(std::fabs(*rounded));
      }
    }
    if (std::ranges::find(left, true) == left.end()) continue;
    open.places.push_back(vertices.size() - 1);
    open.numbers.insert(open.numbers.end(), left.begin(), left.end());
  }
  return open;
}

/// The vertices that are left, by exact arcs.
class SmoothVertices {
 public:
  SmoothVertices(const MovingContour& contour, VertexTerms& all,
                 const std::vector<Rgb>& weights, Emission emission)
      : contour_(contour), all_(all), weights_(weights), emission_(emission) {
    for (const MovingArc& arc : contour.arcs)
      rational_.emplace_back(arc);
  }

  void Find(const OpenVertices& open, VertexDerivatives& result) {
    terms_.clear();
    for (const std::size_t place : open.places)
      terms_.push_back(&all_[result.vertices[place].number]);
    const CertifiedNumbers found =
        Certify({[this](slong precision) { return At(precision); },
                 [this](std::size_t i, const ArbReal&) { return IsZero(i); }},
                open.numbers);
    for (std::size_t i = 0; i < open.numbers.size(); ++i) {
      if (!open.numbers[i]) continue;
      VertexSlope& slope =
          result.vertices[open.places[i / 9]].slopes[i / 3 % 3][i % 3];
      slope.left = slope.right = found.values[i];
      slope.bound = found.bounds[i];
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
  VertexTerms& all_;
  const std::vector<Rgb>& weights_;
  Emission emission_;
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
    const ContourEngine& engine, const SceneContacts& contacts,
    const std::function<const LooseEngine&()>& loose, ContourQuery query,
    const EvaluationQuery& evaluation, OracleWorkspace& workspace) {
  VertexDerivatives result;
  workspace.builder.StartBlock({});
  workspace.builder.Build(query, workspace.contour);
  result.irradiance = EvaluateContour(query, workspace.contour, evaluation,
                                      workspace.evaluation);
  SeenLineFinder& lines = workspace.Lines(engine);
  const SeenLines* seen = &lines.Find(query);
  const KinkCandidates candidates = FindKinkPlanes(engine, query, *seen);
  if (candidates.touched.valid()) {
    if (!candidates.touched_is_level) {
      result.smoothness = Smoothness::kDiscontinuous;
      return result;
    }
    query.receiver.on_face = candidates.touched.value();
    workspace.builder.Build(query, workspace.contour);
    seen = &lines.Find(query);
  }
  const ReceiverView view = ViewOf(query);
  std::vector<Rgb> weights;
  FindWeights(query, workspace.contour, weights);
  const std::set<int> suspects = FindSuspects(engine, contacts, query, *seen);
  const OpenVertices open = TakeBalls(
      VertexBallsOf({view, workspace.contour, weights}, query.scene,
                    evaluation.emission, workspace.evaluation.double_double),
      suspects, result.vertices);
  if (!open.places.empty()) {
    MovingContour contour = MovingContourOf(view, workspace.contour);
    SplitCuts(view, query.scene, contour);
    VertexTerms terms = VertexTermsOf(view, query.scene, contour);
    SmoothVertices(contour, terms, weights, evaluation.emission)
        .Find(open, result);
  }
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
