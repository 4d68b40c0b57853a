// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/gradients/gradient_errors.h"

#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <gtest/gtest.h>

namespace truelux {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kTolerance = 0.01;

/// Receivers with one channel each.
class Table {
 public:
  Table& Add(const Vector3& value, const Vector3& truth,
             Smoothness smoothness = Smoothness::kC1) {
    data_.values.push_back({value});
    data_.truth.push_back({smoothness, {truth}});
    return *this;
  }

  [[nodiscard]] std::vector<GradientError> Errors() {
    data_.channels = {0};
    return ErrorsOf(data_, kTolerance);
  }

 private:
  GradientData data_;
};

TEST(GradientErrors, MeasureTheDifferenceByTheLengthOfTheTruth) {
  const auto e = Table()
                     .Add({3, 4, 0}, {3, 4, 0})
                     .Add({3, 4, 0.05}, {3, 4, 0})
                     .Add({3, 4, 0.06}, {3, 4, 0})
                     .Errors();
  EXPECT_TRUE(e[0].exact && e[0].passes && e[0].excess == 0);
  EXPECT_TRUE(e[1].passes && !e[1].exact);
  EXPECT_FALSE(e[2].passes);
  EXPECT_DOUBLE_EQ(e[2].excess, 0.06 / 5);
  EXPECT_DOUBLE_EQ(e[2].absolute, 0.06);
}

TEST(GradientErrors, TellTurnsFromLengthening) {
  const auto e =
      Table().Add({0, 2, 0}, {2, 0, 0}).Add({3, 0, 0}, {2, 0, 0}).Errors();
  EXPECT_DOUBLE_EQ(e[0].angle, std::acos(0.0));
  EXPECT_EQ(e[0].lengthening, 0);
  EXPECT_EQ(e[1].angle, 0);
  EXPECT_DOUBLE_EQ(e[1].lengthening, 0.5);
}

TEST(GradientErrors, MeasureWhatShouldBeZeroByTheLongestOfTheTable) {
  const auto e = Table()
                     .Add({0, 0, 8}, {0, 0, 8})
                     .Add({0.08, 0, 0}, {})
                     .Add({0.09, 0, 0}, {})
                     .Errors();
  EXPECT_TRUE(e[1].is_flat && e[1].passes);
  EXPECT_TRUE(e[2].is_flat && !e[2].passes);
  // Where nothing slopes, nothing may.
  EXPECT_FALSE(Table().Add({1e-300, 0, 0}, {}).Errors()[0].passes);
}

TEST(GradientErrors, NoNumberPassesButWhereThereIsNoGradient) {
  const auto e =
      Table()
          .Add({kNan, 0, 0}, {1, 0, 0})
          .Add({kNan, kNan, kNan}, {1, 0, 0}, Smoothness::kDiscontinuous)
          .Add({1, -std::numeric_limits<double>::infinity(), 0}, {1, 0, 0})
          .Errors();
  EXPECT_TRUE(e[0].no_number && !e[0].passes);
  EXPECT_FALSE(e[1].has_gradient);
  EXPECT_TRUE(e[1].passes);
  EXPECT_TRUE(e[2].no_number && !e[2].passes);
  EXPECT_EQ(e[2].angle, 0);
  EXPECT_FALSE(Summarize(std::span(e).subspan(1, 1)).compares_anything());
  EXPECT_TRUE(Summarize(e).compares_anything());
}

TEST(GradientErrors, CountEveryReceiverOnce) {
  const auto errors = Table()
                          .Add({1, 0, 0}, {1, 0, 0})
                          .Add({2, 0, 0}, {1, 0, 0}, Smoothness::kKink)
                          .Add({0, 0, 0}, {})
                          .Add({1, 0, 0}, {})
                          .Add({kNan, 0, 0}, {})
                          .Add({}, {9, 9, 9}, Smoothness::kDiscontinuous)
                          .Errors();
  const GradientErrorSummary s = Summarize(errors);
  EXPECT_EQ(s.receivers, 6U);
  EXPECT_EQ(s.sloping + s.flat + s.no_number + s.discontinuous, 6U);
  EXPECT_EQ(s.sloping, 2U);
  EXPECT_EQ(s.sloping_exact, 1U);
  EXPECT_EQ(s.sloping_failing, 1U);
  EXPECT_EQ(s.flat, 2U);
  EXPECT_EQ(s.flat_failing, 1U);
  EXPECT_EQ(s.kinks, 1U);
  EXPECT_EQ(s.failing(), 3U);
  EXPECT_DOUBLE_EQ(s.mean_lengthening, 0.5);
  // What is discontinuous has no part in what the others are measured by.
  EXPECT_EQ(s.max_absolute, 1);
  EXPECT_EQ(WorstOf(errors, 9), (std::vector<std::size_t>{4, 1, 3}));
}

}  // namespace
}  // namespace truelux
