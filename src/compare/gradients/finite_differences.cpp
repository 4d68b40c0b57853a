// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/gradients/finite_differences.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <string>
#include <utility>
#include <vector>

#include "base/vector_math.h"
#include "compare/gradients/gradient_errors.h"

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
double SizeOf(const Scene& scene) {
  double size = 0;
  for (const auto axis : kPositions) {
    const auto [least, greatest] = std::ranges::minmax(
        scene.vertices(), {}, [axis](const Point3& p) { return p.*axis; });
    size = std::max(size, greatest.*axis - least.*axis);
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

/// The best of a row of steps, each 10^(-1/4) of the one before.
Step BestOnGrid(const Differences& differences, double greatest) {
  constexpr int kSteps = 21;
  Step best;
  for (int k = 0; k < kSteps; ++k) {
    const double size = greatest * std::pow(10, -k / 4.0);
    const auto predicted = differences.With(size);
    for (std::size_t s = 0; s < predicted.size(); ++s) {
      const double loss = LossOf(differences.data(), predicted[s]);
      if (loss < best.loss) best = {size, s, loss};
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

/// Where a difference is wrong, and whether a kink is to blame.
struct Crossings {
  std::size_t wrong = 0;
  std::size_t crossing = 0;
  double loss = 0;           ///< sum of the squares of relative errors
  double crossing_loss = 0;  ///< its part at crossings
};

Crossings CrossingsOf(const GradientData& data, std::size_t stencil,
                      std::span<const GradientRow> with,
                      std::span<const GradientRow> with_quarter) {
  // Where E is smooth, the error falls to 1/16, or 1/4 of one-sided ones.
  const double smooth =
      kStencils[stencil] == Stencil::kCentral ? 1.0 / 16 : 1.0 / 4;
  constexpr double kNear = 1.5;
  constexpr double kWrong = 1e-9;
  Crossings crossings;
  for (std::size_t i = 0; i < with.size(); ++i) {
    if (data.truth[i].smoothness == Smoothness::kDiscontinuous) continue;
    double loss = 0;
    bool crosses = false;
    for (std::size_t c = 0; c < data.channels.size(); ++c) {
      const Vector3& g = data.truth[i].gradient[c];
      const double error = LengthOf(Difference(with[i][c], g));
      const double quarter = LengthOf(Difference(with_quarter[i][c], g));
      const double scale = std::max(LengthOf(g), LengthOf(with[i][c]));
      if (error <= kWrong * scale) continue;
      loss += std::pow(error / scale, 2);
      const double ratio = quarter / error;
      crosses = crosses || ratio > kNear * smooth || ratio < smooth / kNear;
    }
    if (loss == 0) continue;
    ++crossings.wrong;
    crossings.loss += loss;
    if (!crosses) continue;
    ++crossings.crossing;
    crossings.crossing_loss += loss;
  }
  return crossings;
}

}  // namespace

std::optional<GradientHypothesis> FiniteDifferences(GradientTrial& trial) {
  constexpr std::size_t kMostWorst = 24;
  constexpr double kGreatest = 0.1;
  const GradientData& data = trial.data();
  std::vector<std::size_t> worst;
  const std::vector<GradientError> errors = ErrorsOf(data, 0);
  for (const std::size_t i : WorstOf(errors, data.receivers.size())) {
    if (!errors[i].no_number && worst.size() < kMostWorst) worst.push_back(i);
  }
  const double size = SizeOf(trial.scene());
  if (worst.empty() || !(size > 0) || !std::isfinite(size)) return std::nullopt;
  const GradientData some = SomeOf(data, worst);
  const Differences few(trial, some);
  const Step step = Refined(few, BestOnGrid(few, kGreatest * size));

  const Differences all(trial, data);
  auto predicted = all.With(step.size)[step.stencil];
  const auto quarter = all.With(step.size / 4)[step.stencil];
  const Crossings crossings =
      CrossingsOf(data, step.stencil, predicted, quarter);
  const bool by_kinks = 2 * crossings.crossing_loss >= crossings.loss;
  GradientHypothesis hypothesis;
  hypothesis.mistake = by_kinks ? kDifferencesAcrossKinks : kLongDifferences;
  hypothesis.sentence = fmt::format(
      "the candidate's gradients are {} differences of E with the step {:.6g}",
      Name(kStencils[step.stencil]), step.size);
  if (by_kinks) {
    hypothesis.sentence += fmt::format(
        "; at {} of the {} receivers where these are wrong the step crosses a "
        "kink, across which E has different slopes",
        crossings.crossing, crossings.wrong);
  }
  hypothesis.predicted = std::move(predicted);
  return hypothesis;
}

}  // namespace truelux
