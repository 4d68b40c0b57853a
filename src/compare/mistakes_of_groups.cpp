// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "compare/mistake_fit.h"
#include "compare/mistakes.h"
#include "scene/emitters.h"
#include "scene/io/quoted.h"
#include "scene/scene_variants.h"
#include "text/evenly_picked.h"

namespace truelux {
namespace {

/// What may be left out together.
struct Leavable {
  std::string name;
  std::vector<int> faces;  ///< indices
  bool emits = false;
};

/// Every group with faces, and every object with several such groups. A group
/// that contains every face cannot be left out on its own.
std::vector<Leavable> LeavablesOf(const Scene& scene) {
  const auto names = scene.group_names();
  std::vector<std::vector<int>> faces_of(names.size());
  for (std::size_t i = 0; i < scene.faces().size(); ++i) {
    const Face& face = scene.faces()[i];
    if (face.facet_count == 0) continue;
    faces_of[static_cast<std::size_t>(face.group)].push_back(
        static_cast<int>(i));
  }
  std::map<std::string, std::vector<std::size_t>> groups_of_objects;
  std::vector<std::pair<std::string, std::vector<std::size_t>>> choices;
  for (std::size_t g = 0; g < names.size(); ++g) {
    choices.push_back({names[g], {g}});
    groups_of_objects[names[g].substr(0, names[g].find('/'))].push_back(g);
  }
  for (const auto& [object, groups] : groups_of_objects) {
    if (groups.size() > 1) choices.push_back({object, groups});
  }
  std::vector<Leavable> leavables;
  for (auto& [name, groups] : choices) {
    Leavable leavable{std::move(name), {}, false};
    for (const std::size_t group : groups) {
      leavable.faces.insert(leavable.faces.end(), faces_of[group].begin(),
                            faces_of[group].end());
    }
    std::ranges::sort(leavable.faces);
    if (leavable.faces.empty()) continue;
    if (leavable.faces.size() == scene.faces().size()) continue;
    leavable.emits = std::ranges::any_of(leavable.faces, [&](int face) {
      return Emits(scene.faces()[static_cast<std::size_t>(face)]);
    });
    leavables.push_back(std::move(leavable));
  }
  return leavables;
}

std::vector<Hypothesis> HypothesesOf(const Leavable& leavable,
                                     MistakeTrial& trial) {
  const std::string name = leavable.name.empty()
                               ? "what has no object or group name"
                               : Quoted(leavable.name);
  const std::vector<Rgb> without = trial.ValuesWithout(leavable.faces);
  if (!leavable.emits) {
    return {{.sentence =
                 fmt::format("the candidate leaves out {}, a blocker", name),
             .predicted = without}};
  }
  const std::vector<Rgb> black =
      trial.ValuesOf(WithBlackFaces(trial.scene(), leavable.faces));
  const std::vector<Rgb> own = Combined(trial.data().truth, -1, black);
  const auto left_out = [&](const char* how, std::vector<Rgb> predicted) {
    return Hypothesis{
        .sentence = fmt::format("the candidate leaves out {} {}", name, how),
        .predicted = std::move(predicted)};
  };
  const Hypothesis source = left_out("as a source", black);
  const Hypothesis both = left_out("as a source and as a blocker", without);
  if (PredictTheSame(source, both))
    return {left_out("as a source; it hides nothing here", black)};
  return {both, source, left_out("as a blocker", Combined(without, 1, own))};
}

/// The smallest loss that any way of leaving it out has.
double LossOf(const Leavable& leavable, MistakeTrial& trial) {
  double least = 1;
  for (const Hypothesis& hypothesis : HypothesesOf(leavable, trial))
    least = std::min(least, FitOf(trial.data(), hypothesis, 0).loss_after);
  return least;
}

/// Those that explain a small trial best.
std::vector<Leavable> BestOf(std::vector<Leavable> leavables,
                             MistakeTrial& trial, std::size_t most) {
  std::vector<std::pair<double, std::size_t>> losses;
  for (std::size_t i = 0; i < leavables.size(); ++i)
    losses.emplace_back(LossOf(leavables[i], trial), i);
  std::ranges::sort(losses);
  std::vector<Leavable> best;
  for (std::size_t i = 0; i < std::min(most, losses.size()); ++i)
    best.push_back(std::move(leavables[losses[i].second]));
  return best;
}

}  // namespace

// At most 64 objects and groups are tried, of large scenes fewer: a variant of
// a scene costs what reading it costs. Where many are tried, all are tried on
// a few receivers first and the best four on all.
std::vector<Hypothesis> LeftOutGroups(MistakeTrial& trial) {
  constexpr std::size_t kMostTried = 64;
  constexpr std::size_t kFewestTried = 4;
  constexpr std::size_t kMostTriangles = 20'000'000;
  constexpr std::size_t kMostEvaluations = 4'000;
  constexpr std::size_t kFewestReceivers = 32;
  constexpr std::size_t kFinalists = 4;
  std::vector<Leavable> leavables = LeavablesOf(trial.scene());
  if (leavables.empty()) return {};
  const std::size_t triangles =
      std::max<std::size_t>(trial.scene().triangles().size(), 1);
  const std::size_t most =
      std::clamp(kMostTriangles / triangles, kFewestTried, kMostTried);
  if (leavables.size() > most) {
    trial.notes.push_back(
        fmt::format("left-out object: {} of {} objects and groups were tried",
                    most, leavables.size()));
    leavables.resize(most);
  }
  const std::size_t receivers = trial.data().receivers.size();
  const std::size_t few =
      std::max(kFewestReceivers, kMostEvaluations / leavables.size());
  if (few < receivers) {
    const CandidateData some =
        SomeOf(trial.data(), EvenlyPicked(receivers, few));
    MistakeTrial small = trial.On(some);
    leavables = BestOf(std::move(leavables), small, kFinalists);
  }
  std::vector<Hypothesis> hypotheses;
  for (const Leavable& leavable : leavables) {
    for (Hypothesis& hypothesis : HypothesesOf(leavable, trial))
      hypotheses.push_back(std::move(hypothesis));
  }
  return hypotheses;
}

}  // namespace truelux
