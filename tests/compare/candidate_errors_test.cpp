// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/candidate_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace truelux {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

CandidateData Table(const std::vector<Rgb>& values,
                    const std::vector<Rgb>& truth) {
  CandidateData data;
  data.channels = {0, 1, 2};
  data.value_names = {"E_r", "E_g", "E_b"};
  data.receivers.resize(values.size());
  data.lines.resize(values.size());
  data.values = values;
  data.truth = truth;
  return data;
}

bool Passes(const Rgb& value, const Rgb& truth, double tolerance,
            const Rgb& brightest = {8, 0, 2}) {
  // The second receiver gives the table its largest values.
  const auto errors =
      ErrorsOf(Table({value, brightest}, {truth, brightest}), tolerance);
  EXPECT_TRUE(errors[1].passes);
  return errors[0].passes;
}

TEST(CandidateErrors, ToleranceIsRelativeInEveryChannel) {
  EXPECT_TRUE(Passes({1.25, 1, 1}, {1, 1, 1}, 0.25));
  EXPECT_TRUE(Passes({0.75, 1, 1}, {1, 1, 1}, 0.25));
  EXPECT_FALSE(Passes({1.2500001, 1, 1}, {1, 1, 1}, 0.25));
  EXPECT_FALSE(Passes({1, 1, 0.7}, {1, 1, 1}, 0.25));
  EXPECT_FALSE(Passes({1, std::nextafter(1, 2), 1}, {1, 1, 1}, 0));
  EXPECT_TRUE(Passes({1, 1, 1}, {1, 1, 1}, 0));
}

TEST(CandidateErrors, WhereNothingIsSeenTheTablesLargestValueCounts) {
  EXPECT_TRUE(Passes({2, 0, 0.5}, {0, 0, 0}, 0.25));
  EXPECT_TRUE(Passes({-2, 0, 0.5}, {0, 0, 0}, 0.25));
  EXPECT_FALSE(Passes({2.001, 0, 0}, {0, 0, 0}, 0.25));
  EXPECT_FALSE(Passes({0, 0, 0.501}, {0, 0, 0}, 0.25));
  // A channel that is dark everywhere allows nothing.
  EXPECT_FALSE(Passes({0, 1e-300, 0}, {0, 0, 0}, 0.25));
  EXPECT_TRUE(Passes({0, -0.0, 0}, {0, 0, 0}, 0.25));
  // A dark channel beside a lit one.
  EXPECT_FALSE(Passes({1, 0, 1}, {1, 0, 0}, 0.25));
}

TEST(CandidateErrors, NumbersThatAreNotFinite) {
  EXPECT_FALSE(Passes({kNan, 1, 1}, {1, 1, 1}, 1e9));
  EXPECT_FALSE(Passes({kInf, 1, 1}, {1, 1, 1}, 1e9));
  EXPECT_FALSE(Passes({1, 1, 1}, {kInf, 1, 1}, 1e9));
  EXPECT_TRUE(Passes({kInf, 1, 1}, {kInf, 1, 1}, 0));
  EXPECT_FALSE(Passes({kInf, 0, 0}, {0, 0, 0}, 1e9));
}

TEST(CandidateErrors, UlpsAreCountedAcrossZeroAndPowersOfTwo) {
  EXPECT_EQ(UlpsBetween(1, 1), 0U);
  EXPECT_EQ(UlpsBetween(0.0, -0.0), 0U);
  EXPECT_EQ(UlpsBetween(1, std::nextafter(1, 0)), 1U);
  EXPECT_EQ(UlpsBetween(std::nextafter(1, 0), std::nextafter(1, 2)), 2U);
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(UlpsBetween(-tiny, tiny), 2U);
  EXPECT_EQ(UlpsBetween(1, 2), std::uint64_t{1} << 52U);
  EXPECT_EQ(UlpsBetween(std::numeric_limits<double>::max(), kInf), 1U);
  // By steps.
  double x = 0.999;
  for (int i = 0; i < 300; ++i)
    x = std::nextafter(x, 2);
  EXPECT_EQ(UlpsBetween(x, 0.999), 300U);
}

TEST(CandidateErrors, UlpBinsHoldWhatTheySay) {
  UlpHistogram h;
  for (const std::uint64_t u : {0U, 1U, 2U, 3U, 4U, 5U, 16U, 17U, 256U, 257U})
    CountUlps(u, h);
  CountUlps(std::uint64_t{1} << 32U, h);
  CountUlps((std::uint64_t{1} << 52U) + 1, h);
  CountUlps(~std::uint64_t{0}, h);
  EXPECT_EQ(h.counts,
            (std::array<std::size_t, 10>{1, 1, 1, 2, 2, 2, 1, 1, 0, 2}));
  EXPECT_EQ(UlpBinText(0), "0");
  EXPECT_EQ(UlpBinText(2), "2");
  EXPECT_EQ(UlpBinText(3), "3..4");
  EXPECT_EQ(UlpBinText(5), "17..256");
  EXPECT_EQ(UlpBinText(6), "257..2^16");
  EXPECT_EQ(UlpBinText(7), "2^16..2^32");
  EXPECT_EQ(UlpBinText(9), "> 2^52");
}

TEST(CandidateErrors, SummaryAgreesWithBruteForce) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.5, 1.5);
  std::vector<Rgb> truth;
  std::vector<Rgb> values;
  std::vector<double> worst;  // with sign
  double max_absolute = 0;
  for (int i = 0; i < 200; ++i) {
    const Rgb t = {uniform(random), uniform(random), uniform(random)};
    Rgb v = t;
    double largest = 0;
    if (i % 10 != 0) {
      for (std::size_t c = 0; c < 3; ++c) {
        v[c] *= uniform(random);
        const double relative = (v[c] - t[c]) / t[c];
        if (std::abs(relative) > std::abs(largest)) largest = relative;
        max_absolute = std::max(max_absolute, std::abs(v[c] - t[c]));
      }
    }
    truth.push_back(t);
    values.push_back(v);
    worst.push_back(largest);
  }
  // Dark ones, right and wrong, and no numbers.
  truth.insert(truth.end(), 3, Rgb{});
  values.insert(values.end(), {Rgb{}, Rgb{0, 1e-9, 0}, Rgb{0.3, 0, 0}});
  truth.insert(truth.end(), 2, Rgb{1, 1, 1});
  values.insert(values.end(), {Rgb{kNan, 9, 9}, Rgb{1, 1, -kNan}});

  const double tolerance = 0.2;
  const CandidateData data = Table(values, truth);
  const CandidateSummary s = Summarize(ErrorsOf(data, tolerance));
  EXPECT_EQ(s.receivers, 205U);
  EXPECT_EQ(s.lit, 200U);
  EXPECT_EQ(s.lit_exact, 20U);
  EXPECT_EQ(s.dark, 3U);
  EXPECT_EQ(s.dark_exact, 1U);
  EXPECT_EQ(s.dark_failing, 1U);
  EXPECT_EQ(s.no_number, 2U);
  EXPECT_EQ(s.max_dark_absolute, 0.3);
  EXPECT_EQ(s.max_absolute, max_absolute);
  double sum = 0;
  double sizes = 0;
  double squares = 0;
  std::size_t failing = 0;
  std::vector<double> sorted;
  for (const double e : worst) {
    sum += e;
    sizes += std::abs(e);
    squares += e * e;
    if (std::abs(e) > tolerance) ++failing;
    sorted.push_back(std::abs(e));
  }
  std::ranges::sort(sorted);
  EXPECT_EQ(s.lit_failing, failing);
  EXPECT_EQ(s.failing(), failing + 1 + 2);
  ASSERT_TRUE(s.relative.has_value());
  EXPECT_NEAR(s.relative->mean, sizes / 200, 1e-12);
  EXPECT_NEAR(s.relative->bias, sum / 200, 1e-12);
  EXPECT_NEAR(s.relative->rms, std::sqrt(squares / 200), 1e-12);
  EXPECT_NEAR(s.relative->median, (sorted[99] + sorted[100]) / 2, 1e-15);
  EXPECT_NEAR(s.relative->percentile_95, sorted[189], 1e-15);
  EXPECT_NEAR(s.relative->percentile_99, sorted[197], 1e-15);
  EXPECT_NEAR(s.relative->max, sorted[199], 1e-15);
  std::size_t in_bins = 0;
  for (const std::size_t count : s.ulps.counts)
    in_bins += count;
  EXPECT_EQ(in_bins, s.lit);
  EXPECT_EQ(s.ulps.counts[0], s.lit_exact);
}

TEST(CandidateErrors, TheWorstComeFirstAndExactOnesDoNotCome) {
  const CandidateData data =
      Table({{1, 1, 1}, {1.5, 1, 1}, {kNan, 1, 1}, {0, 0, 1.75}, {1, 0.2, 1}},
            {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {0, 0, 0}, {1, 1, 1}});
  const auto errors = ErrorsOf(data, 1e-6);
  EXPECT_EQ(WorstOf(errors, 10), (std::vector<std::size_t>{2, 3, 4, 1}));
  EXPECT_EQ(WorstOf(errors, 2), (std::vector<std::size_t>{2, 3}));
  EXPECT_TRUE(std::isinf(errors[2].excess));
  EXPECT_EQ(errors[3].excess, 1.75);
  EXPECT_DOUBLE_EQ(errors[4].signed_relative, -0.8);
}

}  // namespace
}  // namespace truelux
