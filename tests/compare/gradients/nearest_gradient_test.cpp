// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/gradients/nearest_gradient.h"

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "base/vector_math.h"

namespace truelux {
namespace {

Kink Across(const Vector3& normal, double size) {
  Kink kink;
  kink.normal = normal;
  kink.size = {size, 0, 0};
  return kink;
}

void ExpectNear(const Vector3& a, const Vector3& b) {
  EXPECT_LT(LengthOf(Difference(a, b)), 1e-12)
      << a.x << " " << a.y << " " << a.z;
}

TEST(NearestGradient, OfOneKinkLiesOnTheSegmentBetweenItsSides) {
  const std::vector<Kink> kinks = {Across({1, 0, 0}, -2)};
  const Vector3 mean{5, 1, 1};
  ExpectNear(NearestGradient(mean, kinks, 0, {6, 1, 1}), {6, 1, 1});
  ExpectNear(NearestGradient(mean, kinks, 0, {9, 1, 1}), {7, 1, 1});
  ExpectNear(NearestGradient(mean, kinks, 0, {-9, 4, 1}), {3, 1, 1});
  // The other channels are smooth.
  ExpectNear(NearestGradient(mean, kinks, 1, {6, 1, 1}), mean);
}

TEST(NearestGradient, IsTheMeanForTheMeanAndForWhatIsNoNumber) {
  const std::vector<Kink> kinks = {Across({0.6, 0.8, 0}, 0.1),
                                   Across({0, 0.6, 0.8}, 0.3)};
  const Vector3 mean{0.1, 0.2, 0.3};
  for (const double x : {0.1, std::numeric_limits<double>::quiet_NaN()}) {
    const Vector3 nearest = NearestGradient(mean, kinks, 0, {x, 0.2, 0.3});
    EXPECT_EQ(nearest.x, mean.x);
    EXPECT_EQ(nearest.y, mean.y);
    EXPECT_EQ(nearest.z, mean.z);
  }
}

TEST(NearestGradient, OfSeveralKinksIsNotFartherThanAnyCombination) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto any = [&] {
    return Vector3{uniform(random), uniform(random), uniform(random)};
  };
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Kink> kinks;
    for (int k = 0; k < 4; ++k)
      kinks.push_back(Across(UnitOf(any()), uniform(random)));
    const Vector3 mean = any();
    const Vector3 value = Times(2, any());
    const double least =
        LengthOf(Difference(value, NearestGradient(mean, kinks, 0, value)));
    for (int k = 0; k < 2000; ++k) {
      Vector3 other = mean;
      for (const Kink& kink : kinks) {
        other = Sum(other, Times(uniform(random) * kink.size[0], kink.normal));
      }
      EXPECT_LE(least, LengthOf(Difference(value, other)) + 1e-12);
    }
  }
}

}  // namespace
}  // namespace truelux
