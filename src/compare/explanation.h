// SPDX-License-Identifier: GPL-3.0-or-later
// Of the mistakes that explain a candidate, the one that a report names.

#ifndef TRUELUX_COMPARE_EXPLANATION_H_
#define TRUELUX_COMPARE_EXPLANATION_H_

#include <algorithm>
#include <fmt/format.h>
#include <span>

#include "truelux/comparison.h"

#include "compare/mistake_fit.h"

namespace truelux {

/// A hypothesis that explains the candidate, and how well. H: Hypothesis or
/// what has its mistake, sentence and factor, and PredictTheSame.
template <class H>
struct Explanation {
  H hypothesis;
  MistakeFit fit;
};

/// Fills in all of a diagnosis that an explanation knows: the one with the
/// least loss or, if others predict the same, the first of them. explanations:
/// not empty; one without a mistake's name says that receivers are off their
/// faces.
template <class H>
void NameExplanation(std::span<const Explanation<H>> explanations,
                     Diagnosis& diagnosis) {
  const auto best = std::ranges::min_element(
      explanations, {},
      [](const Explanation<H>& e) { return e.fit.loss_after; });
  const auto named =
      std::ranges::find_if(explanations, [&](const Explanation<H>& e) {
        return PredictTheSame(e.hypothesis, best->hypothesis);
      });
  for (const Explanation<H>& e : explanations) {
    // Receivers off their faces are nobody's mistake.
    if (named->hypothesis.mistake.empty()) break;
    if (&e != &*named && PredictTheSame(e.hypothesis, named->hypothesis))
      diagnosis.equally.push_back(e.hypothesis.sentence);
  }
  diagnosis.mistake = named->hypothesis.mistake;
  diagnosis.verdict =
      diagnosis.mistake.empty() ? Verdict::kOffFaces : Verdict::kMistake;
  diagnosis.factor = named->hypothesis.factor;
  diagnosis.fit = named->fit;
  diagnosis.text = fmt::format(
      "{}: {}; {}",
      diagnosis.mistake.empty() ? Name(diagnosis.verdict) : diagnosis.mistake,
      named->hypothesis.sentence, TextOf(named->fit));
}

}  // namespace truelux

#endif  // TRUELUX_COMPARE_EXPLANATION_H_
