// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "base/vector_math.h"
#include "compare/gradients/gradient_errors.h"
#include "compare/gradients/gradient_trial.h"
#include "text/quantile.h"

namespace truelux {
namespace {

/// Where a flat place is predicted, so much of the truth passes for it.
constexpr double kFlat = 1e-9;

bool IsNumber(const Vector3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// One channel of one receiver.
struct FitVector {
  std::size_t receiver = 0;
  Vector3 candidate;
  Vector3 truth;
  Vector3 predicted;
  double scale = 0;  ///< what the distance from the truth is measured by
  double predicted_scale = 0;  ///< .. from the prediction

  static double Relative(const Vector3& a, const Vector3& b, double scale) {
    const double distance = LengthOf(Difference(a, b));
    if (distance == 0) return 0;
    return scale > 0 ? distance / scale
                     : std::numeric_limits<double>::infinity();
  }
};

/// The vectors of the compared channels that are numbers.
std::vector<FitVector> VectorsOf(const GradientData& data,
                                 std::span<const GradientRow> predicted,
                                 std::optional<double> factor) {
  std::array<double, 3> longest{};
  for (const GradientTruth& truth : data.truth) {
    for (std::size_t c = 0; c < longest.size(); ++c) {
      if (truth.smoothness != Smoothness::kDiscontinuous)
        longest[c] = std::max(longest[c], LengthOf(truth.gradient[c]));
    }
  }
  std::vector<FitVector> vectors;
  for (std::size_t i = 0; i < data.values.size(); ++i) {
    if (data.truth[i].smoothness == Smoothness::kDiscontinuous) continue;
    for (std::size_t c = 0; c < data.channels.size(); ++c) {
      FitVector v{i, data.values[i][c], data.truth[i].gradient[c],
                  predicted[i][c]};
      if (!IsNumber(v.candidate) || !IsNumber(v.truth) ||
          !IsNumber(v.predicted)) {
        continue;
      }
      v.scale = LengthOf(v.truth);
      const double length = LengthOf(v.predicted);
      if (!factor) v.scale = std::max(v.scale, length);
      if (v.scale == 0) v.scale = longest[c];
      v.predicted_scale = factor ? std::abs(*factor) * v.scale
                                 : std::max(length, kFlat * v.scale);
      vectors.push_back(v);
    }
  }
  return vectors;
}

/// The median distance from the prediction, where that is not 0.
double NoiseOf(std::span<const FitVector> vectors) {
  std::vector<double> distances;
  for (const FitVector& v : vectors) {
    const double length = LengthOf(v.predicted);
    if (length > 0)
      distances.push_back(
          FitVector::Relative(v.candidate, v.predicted, length));
  }
  return distances.empty() ? 0 : Median(distances);
}

std::size_t Passing(const GradientData& data, double tolerance) {
  const std::vector<GradientError> errors = ErrorsOf(data, tolerance);
  return static_cast<std::size_t>(
      std::ranges::count_if(errors, &GradientError::passes));
}

/// The candidate as if a prediction were the truth, where it says something.
GradientData Assuming(const GradientData& data,
                      std::span<const GradientRow> predicted) {
  GradientData assumed = data;
  for (std::size_t i = 0; i < predicted.size(); ++i) {
    if (std::ranges::all_of(predicted[i], IsNumber))
      assumed.truth[i].gradient = predicted[i];
  }
  return assumed;
}

/// The mean loss if every vector were factor times its truth.
double LossOfFactor(std::span<const FitVector> sloping, double factor) {
  double sum = 0;
  for (const FitVector& v : sloping) {
    const Vector3 expected = Times(factor, v.truth);
    const double distance =
        FitVector::Relative(v.candidate, expected, LengthOf(expected));
    sum += std::min(1.0, distance * distance);
  }
  return sum / static_cast<double>(sloping.size());
}

std::vector<GradientRow> GradientsOf(const GradientData& data) {
  std::vector<GradientRow> rows;
  rows.reserve(data.truth.size());
  for (const GradientTruth& truth : data.truth)
    rows.push_back(truth.gradient);
  return rows;
}

}  // namespace

MistakeFit FitOf(const GradientData& data, const GradientHypothesis& hypothesis,
                 double tolerance) {
  const std::vector<FitVector> vectors =
      VectorsOf(data, hypothesis.predicted, hypothesis.factor);
  const double threshold =
      std::max(kRoundingOfSums, kNoiseTimes * NoiseOf(vectors));
  std::vector<FitDistance> distances;
  for (const FitVector& v : vectors) {
    const bool is_disputed =
        hypothesis.factor
            ? LengthOf(v.truth) > 0
            : LengthOf(Difference(v.predicted, v.truth)) > threshold * v.scale;
    distances.push_back(
        {v.receiver, FitVector::Relative(v.candidate, v.truth, v.scale),
         FitVector::Relative(v.candidate, v.predicted, v.predicted_scale),
         is_disputed});
  }
  MistakeFit fit = FitOfDistances(distances, data.values.size());
  fit.passing_before = Passing(data, tolerance);
  fit.passing_after = Passing(Assuming(data, hypothesis.predicted), tolerance);
  return fit;
}

bool PredictTheSame(const GradientHypothesis& a, const GradientHypothesis& b) {
  for (std::size_t i = 0; i < a.predicted.size(); ++i) {
    for (std::size_t c = 0; c < a.predicted[i].size(); ++c) {
      const Vector3& p = a.predicted[i][c];
      const Vector3& q = b.predicted[i][c];
      if (IsNumber(p) != IsNumber(q)) return false;
      if (IsNumber(p) &&
          LengthOf(Difference(p, q)) >
              kRoundingOfSums * std::max(LengthOf(p), LengthOf(q)))
        return false;
    }
  }
  return true;
}

std::optional<FactorFit> FitFactor(const GradientData& data) {
  std::vector<FitVector> sloping =
      VectorsOf(data, GradientsOf(data), std::nullopt);
  std::erase_if(sloping,
                [](const FitVector& v) { return !(LengthOf(v.truth) > 0); });
  std::size_t receivers = 0;
  std::vector<double> ratios;
  double sum = 0;
  double truth_sum = 0;
  for (std::size_t i = 0; i < sloping.size(); ++i) {
    const FitVector& v = sloping[i];
    if (i == 0 || v.receiver != sloping[i - 1].receiver) ++receivers;
    const double length = LengthOf(v.truth);
    const double along = Dot(v.candidate, Times(1 / length, v.truth));
    ratios.push_back(along / length);
    sum += along;
    truth_sum += length;
  }
  if (receivers < 3) return std::nullopt;
  double factor = Median(ratios);
  const double mean = sum / truth_sum;
  if (!std::isfinite(factor) || !std::isfinite(mean)) return std::nullopt;
  if (factor == 0 || (mean != 0 && LossOfFactor(sloping, mean) <
                                       LossOfFactor(sloping, factor)))
    factor = mean;
  if (factor == 0) return std::nullopt;
  // Channels of one receiver may share their noise: receivers count.
  const double spread = std::sqrt(LossOfFactor(sloping, factor));
  return FactorFit{factor, spread / std::sqrt(static_cast<double>(receivers))};
}

}  // namespace truelux
