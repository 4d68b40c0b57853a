// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/comparison_summary.h"

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "study/report_view.h"
#include "study/worst_receivers.h"
#include "text/quantile.h"

namespace truelux {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const double kNaN = std::nan("");

Rgb Grey(double e) {
  return {e, e, e};
}

/// Receivers with these truths, all channels alike.
Comparison WithTruth(const std::vector<double>& truth) {
  Comparison comparison;
  comparison.receivers.resize(truth.size());
  comparison.reasons.resize(truth.size());
  for (const double e : truth)
    comparison.truth.push_back(Grey(e));
  return comparison;
}

MethodResult Method(const std::vector<std::optional<double>>& values,
                    double microseconds = 1) {
  MethodResult method;
  method.name = "m";
  method.group = "g";
  method.microseconds = microseconds;
  for (const auto& value : values) {
    method.values.push_back(value ? std::optional(Grey(*value)) : std::nullopt);
  }
  return method;
}

TEST(Quantiles, ByHand) {
  EXPECT_EQ(Median({3}), 3);
  EXPECT_EQ(Median({4, 1, 2}), 2);
  EXPECT_EQ(Median({1, 9, 3, 5}), 4);
  EXPECT_EQ(Quantile({7}, 0.95), 7);
  std::vector<double> hundred;
  for (int i = 100; i > 0; --i)
    hundred.push_back(i);
  EXPECT_EQ(Quantile(hundred, 0.95), 95);
  EXPECT_EQ(Quantile(hundred, 1), 100);
  EXPECT_EQ(Quantile({1, 2, 3}, 0.5), 2);
}

TEST(ReceiverErrors, AreThoseOfTheWorstLitChannel) {
  const ValueError error = ErrorOf({1.5, 8, 0}, {1, 10, 0});
  EXPECT_EQ(error.relative, 0.5);
  EXPECT_EQ(error.channel, 0U);
  EXPECT_EQ(error.absolute, 2);
  EXPECT_FALSE(error.exact);
  EXPECT_FALSE(error.false_light);
}

TEST(ReceiverErrors, ExactMeansAllChannels) {
  EXPECT_TRUE(ErrorOf({1, 2, 0}, {1, 2, 0}).exact);
  const ValueError ulp = ErrorOf({1, std::nextafter(2, 3), 0}, {1, 2, 0});
  EXPECT_FALSE(ulp.exact);
  EXPECT_EQ(ulp.relative, 0x1p-52);
  EXPECT_EQ(ulp.channel, 1U);
}

TEST(ReceiverErrors, LightWhereThereIsNoneIsNoRelativeError) {
  const ValueError dark = ErrorOf(Grey(1e-9), Grey(0));
  EXPECT_TRUE(dark.false_light);
  EXPECT_FALSE(dark.relative.has_value());
  EXPECT_EQ(dark.absolute, 1e-9);
  const ValueError mixed = ErrorOf({1, 0, 0.25}, {1, 0, 0});
  EXPECT_TRUE(mixed.false_light);
  EXPECT_EQ(mixed.relative, 0);
  EXPECT_EQ(mixed.channel, 2U);
}

TEST(ReceiverErrors, WhatIsNoNumberIsInfinitelyFar) {
  EXPECT_EQ(ErrorOf(Grey(kNaN), Grey(1)).relative, kInfinity);
  EXPECT_EQ(ErrorOf(Grey(kInfinity), Grey(1)).relative, kInfinity);
  EXPECT_TRUE(ErrorOf(Grey(kNaN), Grey(0)).false_light);
  EXPECT_TRUE(ErrorOf(Grey(kInfinity), Grey(kInfinity)).exact);
}

TEST(Decades, HoldTheirLowerEnd) {
  EXPECT_EQ(DecadeOf(1e-17), 0U);
  EXPECT_EQ(DecadeOf(5e-324), 0U);
  EXPECT_EQ(DecadeOf(9.99e-17), 0U);
  EXPECT_EQ(DecadeOf(0x1p-53), 1U);  // 1.1e-16
  EXPECT_EQ(DecadeOf(2e-4), 13U);
  EXPECT_EQ(DecadeOf(0.1), 16U);
  EXPECT_EQ(DecadeOf(0.999), 16U);
  EXPECT_EQ(DecadeOf(1), 17U);
  EXPECT_EQ(DecadeOf(kInfinity), 17U);
}

TEST(Summary, OfSixReceiversByHand) {
  const Comparison comparison = WithTruth({1, 1, 2, 4, 0, 0});
  const MethodSummary s =
      Summarize(comparison, Method({1, 1.25, 1, std::nullopt, 0, 0.5}));
  EXPECT_EQ(s.answered, 5U);
  EXPECT_EQ(s.lit, 3U);
  EXPECT_EQ(s.exact, 2U);
  EXPECT_EQ(s.false_light, 1U);
  ASSERT_TRUE(s.relative.has_value());
  EXPECT_EQ(s.relative->median, 0.25);
  EXPECT_EQ(s.relative->percentile_95, 0.5);
  EXPECT_EQ(s.relative->max, 0.5);
  EXPECT_DOUBLE_EQ(s.relative->rms, std::sqrt((0.0625 + 0.25) / 3));
  EXPECT_EQ(s.max_absolute, 1);
  EXPECT_FALSE(s.AnswersAll(comparison));
  EXPECT_EQ(s.histogram.exact, 2U);
  EXPECT_EQ(s.histogram.decades[16], 2U);
  EXPECT_EQ(s.histogram.HighestDecade(), 2U);
  EXPECT_EQ(s.histogram.false_light, 1U);
  EXPECT_EQ(s.histogram.no_value, 1U);
}

TEST(Summary, HistogramCountsEveryReceiverOnce) {
  const Comparison comparison = WithTruth({1, 1, 1, 1, 0, 0, 3});
  const ErrorHistogram h =
      Summarize(comparison, Method({1, 2, kNaN, 1 + 1e-9, 1, std::nullopt, 3}))
          .histogram;
  std::size_t sum = h.exact + h.false_light + h.no_value;
  for (const std::size_t count : h.decades)
    sum += count;
  EXPECT_EQ(sum, 7U);
  EXPECT_EQ(h.decades[17], 2U);
}

TEST(Summary, OfTheDarkHasNoRelativeErrors) {
  const Comparison comparison = WithTruth({0, 0});
  EXPECT_FALSE(Summarize(comparison, Method({0, 0})).relative.has_value());
  EXPECT_EQ(Summarize(comparison, Method({0, 0})).exact, 2U);
}

TEST(Summary, TheMeanSquareOfTinyAndHugeErrorsKeepsItsRange) {
  const Comparison comparison = WithTruth({1, 1});
  const auto rms = [&](double e) {
    return Summarize(comparison, Method({1 + e, 1 + e})).relative->rms;
  };
  EXPECT_DOUBLE_EQ(rms(1e200), 1e200);
  EXPECT_EQ(rms(kInfinity), kInfinity);
}

TEST(Front, HasWhatNoOtherBeats) {
  const std::vector<CostAndError> points = {
      {5, 0}, {1, 0.5}, {2, 0.5}, {3, 0.1}, {4, 0.2}, {9, 0}, {1, 0.6}};
  EXPECT_EQ(ParetoFront(points), (std::vector<std::size_t>{1, 3, 0}));
  EXPECT_TRUE(ParetoFront({}).empty());
}

TEST(Front, OfEqualPointsHasTheFirst) {
  const std::vector<CostAndError> points = {{1, 1}, {1, 1}};
  EXPECT_EQ(ParetoFront(points), (std::vector<std::size_t>{0}));
}

TEST(Front, LeavesOutWhatDoesNotAnswerEverywhere) {
  Comparison comparison = WithTruth({1, 2});
  comparison.methods = {Method({1, 2}, 10), Method({1, std::nullopt}, 1),
                        Method({1, 3}, 5)};
  const ReportView view(comparison);
  EXPECT_EQ(view.front, (std::vector<std::size_t>{2, 0}));
  EXPECT_TRUE(view.IsOnFront(0));
  EXPECT_FALSE(view.IsOnFront(1));
  EXPECT_EQ(view.LitReceivers(), 2U);
}

TEST(Front, FalseLightAloneIsNotExact) {
  const Comparison comparison = WithTruth({1, 0});
  EXPECT_EQ(ErrorInChart(Summarize(comparison, Method({1, 0}))), 0);
  EXPECT_EQ(ErrorInChart(Summarize(comparison, Method({1, 1e-30}))), kInfinity);
  EXPECT_DOUBLE_EQ(ErrorInChart(Summarize(comparison, Method({1.5, 0}))), 0.5);
}

TEST(Worst, AreRankedPerGroupWithTheBestBesideThem) {
  Comparison comparison = WithTruth({1, 1, 1, 0});
  comparison.methods = {Method({1, 1.5, 2, 0}), Method({1, 1.25, 4, 1}),
                        Method({1, 1, 1, 0})};
  comparison.methods[1].name = "other";
  comparison.methods[2].group = "right";
  const auto groups = WorstReceivers(comparison, 2);
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].wrong, 3U);
  ASSERT_EQ(groups[0].worst.size(), 2U);
  EXPECT_EQ(groups[0].worst[0].receiver, 3U);  // light where there is none
  EXPECT_EQ(groups[0].worst[1].receiver, 2U);
  EXPECT_EQ(groups[0].worst[1].method, 1U);
  EXPECT_EQ(groups[0].worst[1].error.relative, 3);
  EXPECT_EQ(groups[0].worst[1].best_method, 0U);
  EXPECT_TRUE(groups[1].worst.empty());
  EXPECT_EQ(ReceiversOf(groups), (std::vector<std::size_t>{3, 2}));
}

}  // namespace
}  // namespace truelux
