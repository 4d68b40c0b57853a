// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/gradients/nearest_gradient.h"

#include <algorithm>
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

void ExpectNear(const Vector3& a, const Vector3& b, double limit = 1e-14) {
  EXPECT_LT(LengthOf(Difference(a, b)), limit)
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

/// Of the sets of random kinks in a few directions, all nearly the same if so
/// wished, the value that a choice of t gives.
class SeveralKinks : public ::testing::TestWithParam<double> {
 protected:
  Vector3 Any() {
    return {uniform_(random_), uniform_(random_), uniform_(random_)};
  }

  std::vector<Kink> Kinks() {
    const Vector3 first = UnitOf(Any());
    std::vector<Kink> kinks;
    for (int k = 0; k < 4; ++k) {
      kinks.push_back(Across(UnitOf(Sum(first, Times(GetParam(), Any()))),
                             uniform_(random_)));
    }
    return kinks;
  }

  Vector3 Chosen(const Vector3& mean, const std::vector<Kink>& kinks) {
    Vector3 chosen = mean;
    for (const Kink& kink : kinks) {
      chosen =
          Sum(chosen, Times(uniform_(random_) * kink.size[0], kink.normal));
    }
    return chosen;
  }

  /// What the header says, by the spread of the normals.
  [[nodiscard]] static double Limit() {
    return 2e-14 / std::min(GetParam(), 1.0);
  }

  std::mt19937 random_{5};
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

TEST_P(SeveralKinks, NoCombinationIsNearer) {
  for (int trial = 0; trial < 20; ++trial) {
    const std::vector<Kink> kinks = Kinks();
    const Vector3 mean = Any();
    const Vector3 value = Times(2, Any());
    const double least =
        LengthOf(Difference(value, NearestGradient(mean, kinks, 0, value)));
    for (int k = 0; k < 2000; ++k) {
      EXPECT_LE(least,
                LengthOf(Difference(value, Chosen(mean, kinks))) + Limit());
    }
  }
}

TEST_P(SeveralKinks, ACombinationIsItsOwnNearest) {
  for (int trial = 0; trial < 200; ++trial) {
    const std::vector<Kink> kinks = Kinks();
    const Vector3 mean = Any();
    const Vector3 value = Chosen(mean, kinks);
    ExpectNear(NearestGradient(mean, kinks, 0, value), value, Limit());
    // So is every corner.
    Vector3 corner = mean;
    for (const Kink& kink : kinks)
      corner = Sum(corner, Times(kink.size[0], kink.normal));
    ExpectNear(NearestGradient(mean, kinks, 0, corner), corner, Limit());
  }
}

INSTANTIATE_TEST_SUITE_P(Spread, SeveralKinks,
                         ::testing::Values(10.0, 1e-2, 1e-4, 1e-7));

}  // namespace
}  // namespace truelux
