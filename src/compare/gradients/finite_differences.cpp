// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/gradients/finite_differences.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/vector_math.h"
#include "compare/gradients/gradient_errors.h"
#include "compare/gradients/kink_crossing.h"

namespace truelux {
namespace {

constexpr std::array kAxes = {&Vector3::x, &Vector3::y, &Vector3::z};
constexpr std::array kPositions = {&Point3::x, &Point3::y, &Point3::z};

enum class Stencil { kCentral, kForward, kBackward };

constexpr std::array kStencils = {Stencil::kCentral, Stencil::kForward,
                                  Stencil::kBackward};

std::string_view Name(Stencil stencil) {
  switch (stencil) {
    case Stencil::kCentral:
      return "central";
    case Stencil::kForward:
      return "forward";
    case Stencil::kBackward:
      break;
  }
  return "backward";
}

/// The greatest distance between two coordinates of one axis.
double SizeOf(const Scene& scene, std::span<const Receiver> receivers) {
  double size = 0;
  for (const auto axis : kPositions) {
    double least = HUGE_VAL;
    double greatest = -HUGE_VAL;
    const auto include = [&](const Point3& p) {
      least = std::min(least, p.*axis);
      greatest = std::max(greatest, p.*axis);
    };
    std::ranges::for_each(scene.vertices(), include);
    std::ranges::for_each(receivers, include, &Receiver::position);
    size = std::max(size, greatest - least);
  }
  return size;
}

/// The gradients of one trial by differences.
class Differences {
 public:
  /// data: some receivers of the trial; must outlive the object.
  Differences(const GradientTrial& trial, const GradientData& data)
      : trial_(trial), data_(data), here_(ValuesAt(data.receivers)) {}

  [[nodiscard]] const GradientData& data() const { return data_; }

  /// For each stencil, the gradients with one step.
  [[nodiscard]] std::array<std::vector<GradientRow>, kStencils.size()> With(
      double step) const {
    std::array<std::vector<GradientRow>, kStencils.size()> result;
    result.fill(std::vector<GradientRow>(data_.receivers.size()));
    for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
      const Displaced above = DisplacedBy(axis, step);
      const Displaced below = DisplacedBy(axis, -step);
      for (std::size_t i = 0; i < data_.receivers.size(); ++i) {
        for (std::size_t c = 0; c < data_.channels.size(); ++c) {
          const std::size_t channel = data_.channels[c];
          const auto slope = [&](double to, double from, double distance) {
            return (to - from) / distance;
          };
          const double up = above.values[i][channel];
          const double down = below.values[i][channel];
          const double mid = here_[i][channel];
          result[0][i][c].*kAxes[axis] =
              slope(up, down, above.offsets[i] - below.offsets[i]);
          result[1][i][c].*kAxes[axis] = slope(up, mid, above.offsets[i]);
          result[2][i][c].*kAxes[axis] = slope(mid, down, -below.offsets[i]);
        }
      }
    }
    return result;
  }

 private:
  struct Displaced {
    std::vector<Rgb> values;
    std::vector<double> offsets;  ///< as rounded
  };

  [[nodiscard]] std::vector<Rgb> ValuesAt(
      std::span<const Receiver> receivers) const {
    return trial_.evaluate().irradiances(trial_.scene(), receivers);
  }

  [[nodiscard]] Displaced DisplacedBy(std::size_t axis, double step) const {
    std::vector<Receiver> receivers = data_.receivers;
    Displaced displaced;
    for (std::size_t i = 0; i < receivers.size(); ++i) {
      double& coordinate = receivers[i].position.*kPositions[axis];
      coordinate += step;
      displaced.offsets.push_back(coordinate - data_.receivers[i].position.*
                                                   kPositions[axis]);
    }
    displaced.values = ValuesAt(receivers);
    return displaced;
  }

  const GradientTrial& trial_;
  const GradientData& data_;
  std::vector<Rgb> here_;
};

/// The mean square of the relative distance to the candidate, each at most 1.
double LossOf(const GradientData& data,
              std::span<const GradientRow> predicted) {
  double sum = 0;
  for (std::size_t i = 0; i < predicted.size(); ++i) {
    for (std::size_t c = 0; c < data.channels.size(); ++c) {
      const double distance =
          LengthOf(Difference(data.values[i][c], predicted[i][c]));
      if (distance == 0) continue;
      const double square = std::pow(distance / LengthOf(predicted[i][c]), 2);
      sum += square < 1 ? square : 1;
    }
  }
  return sum;
}

/// A step, its kind, and how far its differences are from the candidate.
struct Step {
  double size = 0;
  std::size_t stencil = 0;
  double loss = HUGE_VAL;
};

/// Steps on a grid, each 10^(-1/4) of the one before.
constexpr int kGridSteps = 29;

/// The best of them for each stencil; nothing where it is the first or the last.
std::vector<Step> BestOnGrid(const Differences& differences, double greatest) {
  std::array<std::array<double, kGridSteps>, kStencils.size()> losses{};
  for (int k = 0; k < kGridSteps; ++k) {
    const auto predicted = differences.With(greatest * std::pow(10, -k / 4.0));
    for (std::size_t s = 0; s < predicted.size(); ++s)
      losses[s][static_cast<std::size_t>(k)] =
          LossOf(differences.data(), predicted[s]);
  }
  std::vector<Step> best;
  for (std::size_t s = 0; s < losses.size(); ++s) {
    const auto least = std::ranges::min_element(losses[s]);
    const auto k = least - losses[s].begin();
    if (k > 0 && k + 1 < kGridSteps) {
      best.push_back(
          {greatest * std::pow(10, -static_cast<double>(k) / 4), s, *least});
    }
  }
  return best;
}

/// Between the neighbours on the grid, by golden sections of the logarithm.
Step Refined(const Differences& differences, const Step& coarse) {
  constexpr int kRounds = 44;
  const double golden = (std::sqrt(5.0) - 1) / 2;
  const double reach = std::log(10.0) / 4;
  const auto at = [&](double logarithm) {
    const double size = std::exp(logarithm);
    return Step{
        size, coarse.stencil,
        LossOf(differences.data(), differences.With(size)[coarse.stencil])};
  };
  double low = std::log(coarse.size) - reach;
  double high = std::log(coarse.size) + reach;
  Step left = at(high - golden * (high - low));
  Step right = at(low + golden * (high - low));
  Step best = coarse;
  for (int round = 0; round < kRounds; ++round) {
    if (left.loss < right.loss) {
      high = std::log(right.size);
      right = left;
      left = at(high - golden * (high - low));
    } else {
      low = std::log(left.size);
      left = right;
      right = at(low + golden * (high - low));
    }
    for (const Step& step : {left, right})
      if (step.loss < best.loss) best = step;
  }
  // People write steps with one or two digits.
  for (const int digits : {1, 2}) {
    const Step round =
        at(std::log(std::stod(fmt::format("{:.{}e}", best.size, digits - 1))));
    constexpr double kAsGood = 1.01;
    constexpr double kExact = 1e-20;
    if (round.loss <= kAsGood * best.loss + kExact) return round;
  }
  return best;
}

/// Where a difference is wrong, and whether a jump is to blame.
struct Wrong {
  std::size_t receivers = 0;  ///< of those looked at
  std::size_t kinks = 0;
  std::size_t faces = 0;
  double loss = 0;       ///< sum of the squares of relative errors
  double jump_loss = 0;  ///< its part where there are jumps
};

/// The squares of the relative errors of a difference, at most 1 each; 0 where
/// it is right.
double ErrorAt(const GradientData& data, std::size_t i,
               const GradientRow& row) {
  constexpr double kRight = 1e-9;
  double loss = 0;
  if (data.truth[i].smoothness == Smoothness::kDiscontinuous) return loss;
  for (std::size_t c = 0; c < data.channels.size(); ++c) {
    const Vector3& g = data.truth[i].gradient[c];
    const double error = LengthOf(Difference(row[c], g));
    const double scale = std::max(LengthOf(g), LengthOf(row[c]));
    if (error > kRight * scale) loss += std::pow(error / scale, 2);
  }
  return loss;
}

Wrong WrongWith(const GradientTrial& trial, const Step& step,
                std::span<const GradientRow> differences) {
  constexpr std::size_t kMost = 48;
  const GradientData& data = trial.data();
  std::vector<std::pair<double, std::size_t>> errors;
  for (std::size_t i = 0; i < differences.size(); ++i) {
    const double loss = ErrorAt(data, i, differences[i]);
    if (loss > 0) errors.emplace_back(loss, i);
  }
  std::ranges::sort(errors, std::greater{});
  if (errors.size() > kMost) errors.resize(kMost);
  const Stencil stencil = kStencils[step.stencil];
  std::vector<Way> ways;
  for (const auto& [loss, i] : errors) {
    for (const auto axis : kPositions) {
      Way way{data.receivers[i], data.receivers[i]};
      if (stencil != Stencil::kForward) way.from.position.*axis -= step.size;
      if (stencil != Stencil::kBackward) way.to.position.*axis += step.size;
      ways.push_back(way);
    }
  }
  const std::vector<WayCrossing> crossings = CrossingsOn(trial, ways);
  Wrong wrong;
  for (std::size_t k = 0; k < errors.size(); ++k) {
    const auto of_receiver = std::span(crossings).subspan(3 * k, 3);
    const bool has_face =
        std::ranges::find(of_receiver, WayCrossing::kFace) != of_receiver.end();
    const bool has_kink =
        std::ranges::find(of_receiver, WayCrossing::kKink) != of_receiver.end();
    ++wrong.receivers;
    wrong.loss += errors[k].first;
    if (has_face) ++wrong.faces;
    if (has_kink && !has_face) ++wrong.kinks;
    if (has_face || has_kink) wrong.jump_loss += errors[k].first;
  }
  return wrong;
}

std::string JumpText(const Wrong& wrong) {
  std::string text = fmt::format(
      "; of the {} receivers where these are most "
      "wrong, the step crosses ",
      wrong.receivers);
  if (wrong.kinks > 0)
    text +=
        fmt::format("a kink, where the slope of E jumps, at {}", wrong.kinks);
  if (wrong.kinks > 0 && wrong.faces > 0) text += ", and ";
  if (wrong.faces > 0)
    text += fmt::format("a face, where E jumps, at {}", wrong.faces);
  return text;
}

}  // namespace

std::optional<GradientHypothesis> FiniteDifferences(GradientTrial& trial) {
  constexpr std::size_t kMostTriangles = 50'000;
  constexpr std::size_t kMostWork = 100'000;
  constexpr std::size_t kFewest = 6;
  constexpr std::size_t kMostWorst = 24;
  const std::size_t triangles = trial.scene().triangles().size();
  if (triangles > kMostTriangles) {
    trial.notes.push_back(fmt::format(
        "finite differences: not tried with {} triangles", triangles));
    return std::nullopt;
  }
  const GradientData& data = trial.data();
  const std::size_t most = std::clamp(
      kMostWork / std::max<std::size_t>(triangles, 1), kFewest, kMostWorst);
  std::vector<std::size_t> worst;
  const std::vector<GradientError> errors = ErrorsOf(data, 0);
  for (const std::size_t i : WorstOf(errors, data.receivers.size())) {
    if (!errors[i].no_number && worst.size() < most) worst.push_back(i);
  }
  const double size = SizeOf(trial.scene(), data.receivers);
  if (worst.empty() || !(size > 0) || !std::isfinite(size)) return std::nullopt;
  const GradientData some = SomeOf(data, worst);
  const Differences few(trial, some);
  Step step;
  for (const Step& coarse : BestOnGrid(few, size)) {
    const Step fine = Refined(few, coarse);
    if (fine.loss < step.loss) step = fine;
  }
  if (!(step.size > 0)) return std::nullopt;

  auto predicted = Differences(trial, data).With(step.size)[step.stencil];
  const Wrong wrong = WrongWith(trial, step, predicted);
  const bool by_jumps =
      wrong.jump_loss > 0 && 2 * wrong.jump_loss >= wrong.loss;
  GradientHypothesis hypothesis;
  hypothesis.mistake = by_jumps ? kDifferencesAcrossKinks : kLongDifferences;
  hypothesis.sentence = fmt::format(
      "the candidate's gradients are {} differences of E with the step {:.6g}",
      Name(kStencils[step.stencil]), step.size);
  if (by_jumps) hypothesis.sentence += JumpText(wrong);
  hypothesis.predicted = std::move(predicted);
  return hypothesis;
}

}  // namespace truelux
