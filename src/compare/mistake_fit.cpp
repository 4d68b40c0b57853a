// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/mistake_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numeric>
#include <vector>

#include "text/number_text.h"
#include "text/quantile.h"

namespace truelux {
namespace {

/// Where darkness is predicted, so much of the truth passes for it.
constexpr double kDark = 1e-9;

double SquareAtMostOne(double distance) {
  return std::min(1.0, distance * distance);
}

double MeanOf(std::span<const double> values) {
  if (values.empty()) return 0;
  return std::accumulate(values.begin(), values.end(), 0.0) /
         static_cast<double>(values.size());
}

/// One channel of one receiver.
struct FitValue {
  std::size_t receiver = 0;
  double candidate = 0;
  double truth = 0;
  double predicted = 0;
  double scale = 0;  ///< what the distance from the truth is measured by
  double predicted_scale = 0;  ///< .. from the prediction

  [[nodiscard]] double FromTruth() const {
    return Distance(candidate - truth, scale);
  }

  [[nodiscard]] double FromPredicted() const {
    return Distance(candidate - predicted, predicted_scale);
  }

  static double Distance(double difference, double scale) {
    if (difference == 0) return 0;
    return scale > 0 ? std::abs(difference) / scale
                     : std::numeric_limits<double>::infinity();
  }
};

/// The values of the compared channels that are numbers.
std::vector<FitValue> ValuesOf(const CandidateData& data,
                               std::span<const Rgb> predicted,
                               std::optional<double> factor) {
  Rgb largest{};
  for (const Rgb& truth : data.truth) {
    for (std::size_t c = 0; c < truth.size(); ++c)
      largest[c] = std::max(largest[c], truth[c]);
  }
  std::vector<FitValue> values;
  for (std::size_t i = 0; i < data.values.size(); ++i) {
    for (std::size_t c = 0; c < data.channels.size(); ++c) {
      FitValue v{i, data.values[i][c], data.truth[i][c], predicted[i][c], 0, 0};
      if (!std::isfinite(v.candidate) || !std::isfinite(v.truth) ||
          !std::isfinite(v.predicted)) {
        continue;
      }
      v.scale = std::abs(v.truth);
      if (!factor) v.scale = std::max(v.scale, std::abs(v.predicted));
      if (v.scale == 0) v.scale = largest[c];
      v.predicted_scale =
          factor ? *factor * v.scale
                 : std::max(std::abs(v.predicted), kDark * v.scale);
      values.push_back(v);
    }
  }
  return values;
}

/// The median distance from the prediction, where that is not 0.
double NoiseOf(std::span<const FitValue> values) {
  std::vector<double> distances;
  for (const FitValue& v : values) {
    if (v.predicted == 0) continue;
    distances.push_back(std::abs(v.candidate - v.predicted) /
                        std::abs(v.predicted));
  }
  return distances.empty() ? 0 : Median(distances);
}

std::size_t Passing(const CandidateData& data, std::vector<Rgb> truth,
                    double tolerance) {
  CandidateData assumed = data;
  assumed.truth = std::move(truth);
  const std::vector<CandidateError> errors = ErrorsOf(assumed, tolerance);
  return static_cast<std::size_t>(
      std::ranges::count_if(errors, &CandidateError::passes));
}

/// The mean loss if every value were factor times its truth.
double LossOfFactor(std::span<const FitValue> lit, double factor) {
  double sum = 0;
  for (const FitValue& v : lit) {
    const double expected = factor * v.truth;
    sum += SquareAtMostOne(std::abs(v.candidate - expected) / expected);
  }
  return sum / static_cast<double>(lit.size());
}

}  // namespace

bool Explains(const MistakeFit& fit, bool is_factor) {
  constexpr std::size_t kFewest = 3;
  if (fit.disputed < kFewest) return false;
  if (is_factor)
    return 2 * fit.loss_after < fit.loss_before && 4 * fit.loss_after < 1;
  return 6 * fit.disputed_loss_after < fit.disputed_loss_before &&
         fit.loss_after < fit.loss_before;
}

MistakeFit FitOfDistances(std::span<const FitDistance> distances,
                          std::size_t receivers) {
  std::vector<double> before;
  std::vector<double> after;
  std::vector<double> disputed_before;
  std::vector<double> disputed_after;
  MistakeFit fit;
  std::optional<std::size_t> last;
  double disputed_loss_before = 0;
  double disputed_loss_after = 0;
  for (const FitDistance& d : distances) {
    before.push_back(SquareAtMostOne(d.from_truth));
    after.push_back(SquareAtMostOne(d.from_predicted));
    if (!d.is_disputed) continue;
    if (d.receiver != last) ++fit.disputed;
    last = d.receiver;
    disputed_before.push_back(d.from_truth);
    disputed_after.push_back(d.from_predicted);
    disputed_loss_before += before.back();
    disputed_loss_after += after.back();
  }
  fit.receivers = receivers;
  fit.loss_before = MeanOf(before);
  fit.loss_after = MeanOf(after);
  if (!disputed_before.empty()) {
    const auto count = static_cast<double>(disputed_before.size());
    fit.median_before = Median(disputed_before);
    fit.median_after = Median(disputed_after);
    fit.disputed_loss_before = disputed_loss_before / count;
    fit.disputed_loss_after = disputed_loss_after / count;
  }
  return fit;
}

std::string TextOf(const MistakeFit& fit) {
  const std::string passing =
      fit.passing_after == fit.receivers
          ? fmt::format("all {} receivers tried pass", fit.receivers)
          : fmt::format("{} of {} receivers tried pass", fit.passing_after,
                        fit.receivers);
  return fmt::format(
      "where that makes a difference ({} of {} receivers tried), the median "
      "error falls from {} to {}; with it {}, without it {}",
      fit.disputed, fit.receivers, ScientificText(fit.median_before, 1),
      ScientificText(fit.median_after, 1), passing, fit.passing_before);
}

MistakeFit FitOf(const CandidateData& data, const Hypothesis& hypothesis,
                 double tolerance) {
  const std::vector<FitValue> values =
      ValuesOf(data, hypothesis.predicted, hypothesis.factor);
  const double threshold =
      std::max(kRoundingOfSums, kNoiseTimes * NoiseOf(values));
  std::vector<FitDistance> distances;
  for (const FitValue& v : values) {
    const bool is_disputed =
        hypothesis.factor
            ? v.truth > 0
            : std::abs(v.predicted - v.truth) > threshold * v.scale;
    distances.push_back(
        {v.receiver, v.FromTruth(), v.FromPredicted(), is_disputed});
  }
  MistakeFit fit = FitOfDistances(distances, data.values.size());
  fit.passing_before = Passing(data, data.truth, tolerance);
  fit.passing_after = Passing(data, hypothesis.predicted, tolerance);
  return fit;
}

bool PredictTheSame(const Hypothesis& a, const Hypothesis& b) {
  for (std::size_t i = 0; i < a.predicted.size(); ++i) {
    for (std::size_t c = 0; c < a.predicted[i].size(); ++c) {
      const double p = a.predicted[i][c];
      const double q = b.predicted[i][c];
      if (std::abs(p - q) >
          kRoundingOfSums * std::max(std::abs(p), std::abs(q)))
        return false;
    }
  }
  return true;
}

std::optional<FactorFit> FitFactor(const CandidateData& data) {
  std::vector<FitValue> lit = ValuesOf(data, data.truth, std::nullopt);
  std::erase_if(lit, [](const FitValue& v) { return !(v.truth > 0); });
  std::size_t receivers = 0;
  for (std::size_t i = 0; i < lit.size(); ++i) {
    if (i == 0 || lit[i].receiver != lit[i - 1].receiver) ++receivers;
  }
  if (receivers < 3) return std::nullopt;
  std::vector<double> ratios;
  double sum = 0;
  double truth_sum = 0;
  for (const FitValue& v : lit) {
    ratios.push_back(v.candidate / v.truth);
    sum += v.candidate;
    truth_sum += v.truth;
  }
  std::array<double, 2> factors = {Median(ratios), sum / truth_sum};
  if (!(factors[0] > 0)) factors[0] = factors[1];
  if (!(factors[1] > 0)) factors[1] = factors[0];
  if (!(factors[0] > 0) || !std::isfinite(factors[1])) return std::nullopt;
  const double factor =
      LossOfFactor(lit, factors[0]) <= LossOfFactor(lit, factors[1])
          ? factors[0]
          : factors[1];
  // Channels of one receiver may share their noise: receivers count.
  const double spread = std::sqrt(LossOfFactor(lit, factor));
  return FactorFit{factor, spread / std::sqrt(static_cast<double>(receivers))};
}

}  // namespace truelux
