// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/stages/span_sum.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "exact/recipe_evaluator.h"
#include "radiometry/stages/exact_sum.h"
#include "radiometry/stages/multiprecision_answer.h"
#include "radiometry/stages/multiprecision_stage.h"

namespace truelux {
namespace {

/// The facet whose light a span shows, for terms of one weight to find
/// together; none if the span is dark.
FacetId EmitterOf(const AngularSpan& span) {
  return span.is_source ? span.facet : FacetId();
}

/// Adds up equation (9), vertex by vertex, in any order.
class SpanSum {
 public:
  explicit SpanSum(const ContourQuery& query)
      : query_(query),
        n_(RecipeEvaluator<Exact>(ViewOf(query)).ReceiverNormal()),
        n_square_(Dot(n_, n_)) {}

  void Add(const SpanVertex& vertex) {
    const AngularSpan* previous = &vertex.spans.back();
    for (const AngularSpan& span : vertex.spans) {
      AddBoundary(vertex.direction, span, *previous);
      previous = &span;
    }
  }

  /// Moves the sum out.
  ExactSum Take() { return std::move(sum_); }

 private:
  using Weight = std::array<Exact, 3>;

  /// (M(span) - M(previous)) F(v, edge between them).
  void AddBoundary(const Vec3<Exact>& v, const AngularSpan& span,
                   const AngularSpan& previous) {
    WeightedTerms* const group = Group(EmitterOf(span), EmitterOf(previous));
    if (group == nullptr) return;
    const Vec3<Exact>& normal = span.edge_plane;
    ExactPlane plane = ExactPlaneOf(n_, n_square_, normal);
    // A plane that contains n, as the cuts between charts do.
    if (plane.cosine_part.is_zero()) return;
    const bool below = SignOf(plane.cosine_part) == Sign::kNegative;
    const ExactPlaneId index = sum_.planes.end_id();
    const Vec3<Exact> ascent = Cross(n_, normal);
    if (IsZero(ascent)) {
      // |v x edge_end| |N| = N.N.
      group->terms.push_back(
          HorizonEndTerm(index, v, span.edge_end, plane.normal_square, below));
    } else {
      group->terms.push_back(EndTerm(index, n_, ascent, v, false));
    }
    sum_.planes.push_back(std::move(plane));
  }

  /// The terms that are weighted with M of one emitter minus that of another;
  /// null if that is nothing.
  WeightedTerms* Group(FacetId emitter, FacetId previous) {
    const auto [entry, is_new] =
        group_of_.try_emplace({emitter, previous}, std::nullopt);
    if (is_new) {
      Weight weight = WeightDifference(emitter, previous);
      if (std::ranges::any_of(weight,
                              [](const Exact& w) { return !w.is_zero(); })) {
        entry->second = sum_.groups.size();
        sum_.groups.push_back({std::move(weight), {}});
      }
    }
    return entry->second ? &sum_.groups[*entry->second] : nullptr;
  }

  [[nodiscard]] Weight WeightDifference(FacetId emitter,
                                        FacetId previous) const {
    const Rgb dark{};
    const Rgb m = emitter.valid() ? WeightOf(query_, emitter) : dark;
    const Rgb before = previous.valid() ? WeightOf(query_, previous) : dark;
    Weight weight;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      weight[channel] = Exact(m[channel]) - Exact(before[channel]);
    }
    return weight;
  }

  const ContourQuery& query_;
  Vec3<Exact> n_;
  Exact n_square_;
  ExactSum sum_;
  /// Index into sum_.groups; nothing where the weight is nothing.
  std::map<std::pair<FacetId, FacetId>, std::optional<std::size_t>> group_of_;
};

/// The channels in which something is seen that emits. A span has a solid
/// angle, so E is not zero in them.
Channels LitChannels(const ContourQuery& query, const AngularSpans& spans) {
  Channels lit{};
  for (const SpanVertex& vertex : spans.vertices) {
    for (const AngularSpan& span : vertex.spans) {
      if (!span.is_source) continue;
      const Rgb weight = WeightOf(query, span.facet);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        lit[channel] = lit[channel] || weight[channel] > 0;
      }
    }
  }
  return lit;
}

}  // namespace

Irradiance EvaluateSpans(const ContourQuery& query, const AngularSpans& spans,
                         const EvaluationQuery& evaluation) {
  Irradiance result;
  result.statistics = spans.statistics;
  Channels open = LitChannels(query, spans);
  if (!Any(open)) {
    result.statistics.evaluated_zero = 1;
    return result;
  }
  SpanSum sum(query);
  for (const SpanVertex& vertex : spans.vertices)
    sum.Add(vertex);
  // A form factor is E with M = 1, however the scene's emission is read.
  const Emission emission =
      query.only_source.valid() ? Emission::kExitance : evaluation.emission;
  AnswerInMultiprecision(MultiprecisionStage(sum.Take(), emission), open,
                         result);
  result.statistics.evaluated_multiprecision = 1;
  return result;
}

}  // namespace truelux
