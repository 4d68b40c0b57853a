// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/candidate_errors.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numeric>

#include "text/quantile.h"

namespace truelux {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool IsNan(double value) {
  return std::isnan(value);
}

/// The largest truth of each channel; infinite ones are left out.
Rgb LargestOf(std::span<const Rgb> truth) {
  Rgb largest{};
  for (const Rgb& e : truth) {
    for (std::size_t c = 0; c < e.size(); ++c) {
      if (std::isfinite(e[c])) largest[c] = std::max(largest[c], e[c]);
    }
  }
  return largest;
}

/// |value - truth| by what it is measured with, and whether it is allowed.
struct Measured {
  double excess = 0;
  bool passes = true;
};

Measured Measure(double value, double truth, double largest, double tolerance) {
  if (value == truth) return {};
  if (IsNan(value) || std::isinf(value) || std::isinf(truth))
    return {kInfinity, false};
  const double distance = std::abs(value - truth);
  const double scale = truth > 0 ? truth : largest;
  // Where nothing is lit any light is wrong. A quotient may leave binary64.
  return {scale > 0 ? distance / scale : kInfinity,
          distance <= tolerance * scale};
}

/// The binary64 numbers in their order as whole numbers in theirs.
std::int64_t Rank(double value) {
  const auto bits = std::bit_cast<std::int64_t>(value);
  return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
}

CandidateError ErrorAt(const Rgb& value, const Rgb& truth, const Rgb& largest,
                       double tolerance) {
  CandidateError result;
  result.error = ErrorOf(value, truth);
  result.is_dark = std::ranges::all_of(truth, [](double e) { return e == 0; });
  result.no_number = std::ranges::any_of(value, IsNan);
  result.passes = true;
  for (std::size_t c = 0; c < truth.size(); ++c) {
    const Measured measured =
        Measure(value[c], truth[c], largest[c], tolerance);
    result.excess = std::max(result.excess, measured.excess);
    result.passes = result.passes && measured.passes;
    if (truth[c] > 0 && !IsNan(value[c]))
      result.ulps = std::max(result.ulps, UlpsBetween(value[c], truth[c]));
  }
  const std::size_t worst = result.error.channel;
  if (result.error.relative.value_or(0) > 0) {
    result.signed_relative = value[worst] < truth[worst]
                                 ? -*result.error.relative
                                 : *result.error.relative;
  }
  return result;
}

}  // namespace

Rgb CandidateData::Compared(const Rgb& all_channels) const {
  return PickChannels<double>(channels, all_channels);
}

std::vector<CandidateError> ErrorsOf(const CandidateData& data,
                                     double tolerance) {
  const Rgb largest = LargestOf(data.truth);
  std::vector<CandidateError> errors;
  errors.reserve(data.values.size());
  for (std::size_t i = 0; i < data.values.size(); ++i) {
    errors.push_back(
        ErrorAt(data.values[i], data.truth[i], largest, tolerance));
  }
  return errors;
}

std::uint64_t UlpsBetween(double a, double b) {
  const std::int64_t rank_a = Rank(a);
  const std::int64_t rank_b = Rank(b);
  return static_cast<std::uint64_t>(std::max(rank_a, rank_b)) -
         static_cast<std::uint64_t>(std::min(rank_a, rank_b));
}

void CountUlps(std::uint64_t ulps, UlpHistogram& histogram) {
  const auto bin = std::ranges::lower_bound(UlpHistogram::kLast, ulps);
  ++histogram
        .counts[static_cast<std::size_t>(bin - UlpHistogram::kLast.begin())];
}

std::string UlpBinText(std::size_t bin) {
  constexpr auto& kLast = UlpHistogram::kLast;
  constexpr std::uint64_t kReadable = 1000;
  const auto number = [](std::uint64_t n) {
    return n < kReadable ? fmt::to_string(n)
                         : fmt::format("2^{}", std::countr_zero(n));
  };
  if (bin == 0) return "0";
  const std::uint64_t before = kLast[bin - 1];
  if (bin + 1 == kLast.size()) return "> " + number(before);
  if (kLast[bin] == before + 1) return number(kLast[bin]);
  return fmt::format("{}..{}", number(before < kReadable ? before + 1 : before),
                     number(kLast[bin]));
}

CandidateSummary Summarize(std::span<const CandidateError> errors) {
  CandidateSummary summary;
  summary.receivers = errors.size();
  std::vector<double> sizes;
  double signed_sum = 0;
  for (const CandidateError& e : errors) {
    if (e.no_number) {
      ++summary.no_number;
      continue;
    }
    summary.max_absolute = std::max(summary.max_absolute, e.error.absolute);
    if (e.is_dark) {
      ++summary.dark;
      summary.max_dark_absolute =
          std::max(summary.max_dark_absolute, e.error.absolute);
      if (e.error.exact) ++summary.dark_exact;
      if (!e.passes) ++summary.dark_failing;
      continue;
    }
    ++summary.lit;
    if (e.error.exact) ++summary.lit_exact;
    if (!e.passes) ++summary.lit_failing;
    sizes.push_back(*e.error.relative);
    signed_sum += e.signed_relative;
    CountUlps(e.ulps, summary.ulps);
  }
  if (sizes.empty()) return summary;
  const auto count = static_cast<double>(sizes.size());
  constexpr double kMost = 0.95;
  constexpr double kNearlyAll = 0.99;
  summary.relative = {
      .mean = std::accumulate(sizes.begin(), sizes.end(), 0.0) / count,
      .bias = signed_sum / count,
      .rms = RootMeanSquare(sizes),
      .median = Median(sizes),
      .percentile_95 = Quantile(sizes, kMost),
      .percentile_99 = Quantile(sizes, kNearlyAll),
      .max = *std::ranges::max_element(sizes)};
  return summary;
}

std::vector<std::size_t> WorstOf(std::span<const CandidateError> errors,
                                 std::size_t most) {
  std::vector<std::size_t> worst;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (!errors[i].error.exact) worst.push_back(i);
  }
  std::ranges::stable_sort(worst, [&](std::size_t a, std::size_t b) {
    return errors[a].excess > errors[b].excess;
  });
  if (worst.size() > most) worst.resize(most);
  return worst;
}

}  // namespace truelux
