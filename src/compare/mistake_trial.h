// SPDX-License-Identifier: GPL-3.0-or-later
// The receivers on which it is tried whether a known mistake explains a
// candidate, and scenes like the compared one evaluated there.

#ifndef TRUELUX_COMPARE_MISTAKE_TRIAL_H_
#define TRUELUX_COMPARE_MISTAKE_TRIAL_H_

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "truelux/geometry.h"
#include "truelux/irradiance.h"
#include "truelux/receiver.h"
#include "truelux/scene.h"

#include "compare/candidate_errors.h"
#include "compare/candidates.h"
#include "compare/receivers_without.h"

namespace truelux {

/// The irradiances of a scene at some receivers, one entry each, all channels,
/// with Ke read as it is in the comparison. May throw to end everything.
using SceneEvaluator =
    std::function<std::vector<Rgb>(const Scene&, std::span<const Receiver>)>;

/// How the truth was found.
struct TruthOptions {
  Quantity quantity = Quantity::kIrradiance;
  Emission emission = Emission::kExitance;
};

/// What a mistake would make of the receivers of a trial.
struct Hypothesis {
  std::string mistake{};       ///< the mistake's name, as in Mistakes()
  std::string sentence;        ///< what the candidate does, without a full stop
  std::vector<Rgb> predicted;  ///< one per receiver, compared channels
  std::optional<double> factor{};  ///< predicted = factor * truth, if so
};

/// Values are those of the compared channels, as in CandidateData.
class MistakeTrial {
 public:
  /// scene: the compared one, with unit exitances if form factors are compared.
  /// data: the receivers of the trial. All must outlive the object.
  MistakeTrial(const Scene& scene, const CandidateData& data,
               const TruthOptions& options, const SceneEvaluator& evaluate);

  [[nodiscard]] const Scene& scene() const { return scene_; }

  [[nodiscard]] const CandidateData& data() const { return data_; }

  [[nodiscard]] const TruthOptions& options() const { return options_; }

  /// A scene at the receivers of the trial.
  [[nodiscard]] std::vector<Rgb> ValuesOf(const Scene& variant) const;

  /// The same with all normals turned round.
  [[nodiscard]] std::vector<Rgb> FlippedValuesOf(const Scene& variant) const;

  /// The scene itself with all normals turned round; found once.
  const std::vector<Rgb>& Flipped();

  /// The scene with every face emitting from its other side; found once.
  const std::vector<Rgb>& Reversed();

  /// The scene without some faces (indices). A receiver that names one of them
  /// by on_face names another face in the same plane instead, if there is one.
  [[nodiscard]] std::vector<Rgb> ValuesWithout(std::span<const int> faces);

  /// The scene at receivers that lie on their faces, as Scene::FaceNear finds
  /// them where on_face names none; nothing if it finds no face.
  [[nodiscard]] std::optional<std::vector<Rgb>> ValuesOnFaces() const;

  /// The same trial on some of its receivers. `some` must outlive it.
  [[nodiscard]] MistakeTrial On(const CandidateData& some) const;

  /// What was left out to save time, for the reader; added by mistakes.
  std::vector<std::string> notes;

 private:
  [[nodiscard]] std::vector<Rgb> Evaluate(
      const Scene& variant, std::span<const Receiver> receivers) const;

  const Scene& scene_;
  const CandidateData& data_;
  TruthOptions options_;
  const SceneEvaluator& evaluate_;
  std::vector<Receiver> flipped_receivers_;
  ReceiversWithout receivers_without_;
  std::optional<std::vector<Rgb>> flipped_;
  std::optional<std::vector<Rgb>> reversed_;
};

/// Some receivers of a candidate, by their indices.
[[nodiscard]] CandidateData SomeOf(const CandidateData& data,
                                   std::span<const std::size_t> indices);

/// Where a mistake is tried: at most `most` receivers, as many failing as
/// passing ones if there are, each kind spread evenly. In their order.
[[nodiscard]] std::vector<std::size_t> TrialReceivers(
    std::span<const CandidateError> errors, std::size_t most);

/// a + factor * b, entry by entry.
[[nodiscard]] std::vector<Rgb> Combined(std::span<const Rgb> a, double factor,
                                        std::span<const Rgb> b);

/// Each value through f.
[[nodiscard]] std::vector<Rgb> Mapped(std::span<const Rgb> values,
                                      const std::function<double(double)>& f);

}  // namespace truelux

#endif  // TRUELUX_COMPARE_MISTAKE_TRIAL_H_
