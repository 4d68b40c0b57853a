// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/gradients/gradient_errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/vector_math.h"
#include "text/quantile.h"

namespace truelux {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool IsNoNumber(const Vector3& v) {
  return !std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z);
}

bool IsZero(const Vector3& v) {
  return v.x == 0 && v.y == 0 && v.z == 0;
}

bool AreSame(const Vector3& a, const Vector3& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

/// The greatest length of a gradient in each channel; infinite ones are left
/// out.
std::array<double, 3> LongestOf(std::span<const GradientTruth> truth) {
  std::array<double, 3> longest{};
  for (const GradientTruth& t : truth) {
    if (t.smoothness == Smoothness::kDiscontinuous) continue;
    for (std::size_t c = 0; c < longest.size(); ++c) {
      const double length = LengthOf(t.gradient[c]);
      if (std::isfinite(length)) longest[c] = std::max(longest[c], length);
    }
  }
  return longest;
}

/// One channel.
struct Measured {
  double excess = 0;
  double absolute = 0;
  bool passes = true;
};

Measured Measure(const Vector3& value, const Vector3& truth, double longest,
                 double tolerance) {
  if (AreSame(value, truth)) return {};
  const double distance = LengthOf(Difference(value, truth));
  if (!std::isfinite(distance)) return {kInfinity, kInfinity, false};
  const double scale = IsZero(truth) ? longest : LengthOf(truth);
  return {scale > 0 ? distance / scale : kInfinity, distance,
          distance <= tolerance * scale};
}

GradientError ErrorAt(const GradientRow& value, const GradientTruth& truth,
                      const std::array<double, 3>& longest, double tolerance) {
  GradientError error;
  error.has_gradient = truth.smoothness != Smoothness::kDiscontinuous;
  error.passes = true;
  if (!error.has_gradient) return error;
  error.at_kink = truth.smoothness == Smoothness::kKink;
  error.is_flat = std::ranges::all_of(truth.gradient, IsZero);
  error.no_number = std::ranges::any_of(value, IsNoNumber);
  error.exact = true;
  std::size_t worst = 0;
  for (std::size_t c = 0; c < value.size(); ++c) {
    const Measured measured =
        Measure(value[c], truth.gradient[c], longest[c], tolerance);
    if (measured.excess > error.excess) worst = c;
    error.excess = std::max(error.excess, measured.excess);
    error.absolute = std::max(error.absolute, measured.absolute);
    error.passes = error.passes && measured.passes;
    error.exact = error.exact && measured.excess == 0;
  }
  const Vector3& g = truth.gradient[worst];
  if (!error.no_number && !IsZero(g) && !IsNoNumber(g)) {
    error.angle = AngleBetween(UnitOf(value[worst]), UnitOf(g));
    const double length = LengthOf(g);
    error.lengthening = (LengthOf(value[worst]) - length) / length;
  }
  return error;
}

GradientErrorSummary::Quantiles QuantilesOf(const std::vector<double>& sizes) {
  constexpr double kMost = 0.95;
  constexpr double kNearlyAll = 0.99;
  return {Median(sizes), Quantile(sizes, kMost), Quantile(sizes, kNearlyAll),
          *std::ranges::max_element(sizes)};
}

}  // namespace

std::vector<GradientError> ErrorsOf(const GradientData& data,
                                    double tolerance) {
  const std::array<double, 3> longest = LongestOf(data.truth);
  std::vector<GradientError> errors;
  errors.reserve(data.values.size());
  for (std::size_t i = 0; i < data.values.size(); ++i) {
    errors.push_back(
        ErrorAt(data.values[i], data.truth[i], longest, tolerance));
  }
  return errors;
}

GradientErrorSummary Summarize(std::span<const GradientError> errors) {
  GradientErrorSummary summary;
  summary.receivers = errors.size();
  std::vector<double> relative;
  std::vector<double> angles;
  std::vector<double> lengthenings;
  double sum = 0;
  for (const GradientError& e : errors) {
    if (!e.has_gradient) {
      ++summary.discontinuous;
      continue;
    }
    if (e.no_number) {
      ++summary.no_number;
      continue;
    }
    if (e.at_kink) ++summary.kinks;
    summary.max_absolute = std::max(summary.max_absolute, e.absolute);
    if (e.is_flat) {
      ++summary.flat;
      summary.max_flat_absolute =
          std::max(summary.max_flat_absolute, e.absolute);
      if (e.exact) ++summary.flat_exact;
      if (!e.passes) ++summary.flat_failing;
      continue;
    }
    ++summary.sloping;
    if (e.exact) ++summary.sloping_exact;
    if (!e.passes) ++summary.sloping_failing;
    relative.push_back(e.excess);
    angles.push_back(e.angle);
    lengthenings.push_back(std::abs(e.lengthening));
    sum += e.lengthening;
  }
  if (relative.empty()) return summary;
  summary.relative = QuantilesOf(relative);
  summary.angle = QuantilesOf(angles);
  summary.lengthening = QuantilesOf(lengthenings);
  summary.mean_lengthening = sum / static_cast<double>(relative.size());
  return summary;
}

std::vector<std::size_t> WorstOf(std::span<const GradientError> errors,
                                 std::size_t most) {
  std::vector<std::size_t> worst;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (errors[i].has_gradient && !errors[i].exact) worst.push_back(i);
  }
  std::ranges::stable_sort(worst, [&](std::size_t a, std::size_t b) {
    return errors[a].excess > errors[b].excess;
  });
  if (worst.size() > most) worst.resize(most);
  return worst;
}

}  // namespace truelux
