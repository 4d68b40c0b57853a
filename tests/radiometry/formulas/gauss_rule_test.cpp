// SPDX-License-Identifier: GPL-3.0-or-later
// Gauss-Legendre rules: exact for polynomials up to degree 2 n - 1, and for no
// more.

#include "radiometry/formulas/gauss_rule.h"

#include <cmath>
#include <cstddef>
#include <type_traits>

#include <gtest/gtest.h>

#include "support/real.h"

namespace truelux::testing {
namespace {

constexpr mpfr_prec_t kPrecision = 500;

Real ToReal(float x) {
  return {x};
}

Real ToReal(double x) {
  return {x};
}

Real ToReal(const DoubleDouble& x) {
  return Real(x.high) + Real(x.low);
}

Real ToReal(const Ball<double>& x) {
  return {x.value};
}

Real ToReal(const Multiprecision& x) {
  Real result;
  mpfr_set(result.get(), x.get(), MPFR_RNDN);
  return result;
}

/// Half a unit in the last place of 1.
template <class T>
double Unit() {
  if (std::is_same_v<T, float>) return 0x1p-24;
  if (std::is_same_v<T, DoubleDouble>) return 0x1p-106;
  if (std::is_same_v<T, Multiprecision>) return 0x1p-500;
  return 0x1p-53;
}

template <class T>
class GaussRuleTest : public ::testing::Test {};

using Types =
    ::testing::Types<float, double, DoubleDouble, Ball<double>, Multiprecision>;
TYPED_TEST_SUITE(GaussRuleTest, Types);

/// What a rule makes of x^degree.
template <class T>
Real Integral(const GaussRule<T>& rule, int degree) {
  Real sum;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    Real term = ToReal(rule.weights[i]);
    for (int k = 0; k < degree; ++k)
      term = term * ToReal(rule.nodes[i]);
    sum = sum + term;
  }
  return sum;
}

TYPED_TEST(GaussRuleTest, IsExactUpToDegree2nMinus1AndNoFurther) {
  const GaussRules<TypeParam> rules = MakeGaussRules<TypeParam>(kPrecision);
  for (std::size_t k = 0; k < rules.size(); ++k) {
    const int n = kGaussSizes[k];
    ASSERT_EQ(rules[k].nodes.size(), static_cast<std::size_t>(n));
    ASSERT_EQ(rules[k].weights.size(), static_cast<std::size_t>(n));
    for (int degree = 0; degree < 2 * n; ++degree) {
      // Nodes off by a few units move x^d by d times as much.
      EXPECT_LE(Abs(Integral(rules[k], degree) - Real(1) / Real(degree + 1)),
                Real(64 * Unit<TypeParam>()))
          << n << " nodes, degree " << degree;
    }
    // (n!)^4 / ((2n + 1) (2n)!^2) is what is missing at degree 2 n.
    Real missing = Real(1) / Real(2 * n + 1);
    for (int i = 1; i <= n; ++i) {
      const Real factor = Real(i) / Real(n + i);
      missing = missing * factor * factor;
    }
    const Real found = Real(1) / Real(2 * n + 1) - Integral(rules[k], 2 * n);
    EXPECT_LE(Abs(found - missing), Real(64 * Unit<TypeParam>())) << n;
  }
}

TYPED_TEST(GaussRuleTest, NodesAreInsideAndSymmetricWithPositiveWeights) {
  for (const auto& rule : MakeGaussRules<TypeParam>(kPrecision)) {
    const std::size_t n = rule.nodes.size();
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_GT(Leading(rule.nodes[i]), 0);
      EXPECT_LT(Leading(rule.nodes[i]), 1);
      EXPECT_GT(Leading(rule.weights[i]), 0);
      if (i > 0) {
        EXPECT_LT(Leading(rule.nodes[i]), Leading(rule.nodes[i - 1]));
      }
      EXPECT_LE(
          Abs(ToReal(rule.nodes[i]) + ToReal(rule.nodes[n - 1 - i]) - Real(1)),
          Real(16 * Unit<TypeParam>()));
    }
  }
}

TEST(GaussRuleOfBalls, HoldsTheTrueNodesAndWeights) {
  const auto balls = MakeGaussRules<Ball<double>>(0);
  const auto truth = MakeGaussRules<Multiprecision>(kPrecision);
  for (std::size_t k = 0; k < balls.size(); ++k) {
    for (std::size_t i = 0; i < balls[k].nodes.size(); ++i) {
      const Ball<double>& node = balls[k].nodes[i];
      const Ball<double>& weight = balls[k].weights[i];
      EXPECT_LE(Abs(Real(node.value) - ToReal(truth[k].nodes[i])),
                Real(node.error));
      EXPECT_LE(Abs(Real(weight.value) - ToReal(truth[k].weights[i])),
                Real(weight.error));
      EXPECT_LE(node.error, 0x1.01p-53 * node.value);
      EXPECT_LE(weight.error, 0x1.01p-53 * weight.value);
    }
  }
}

// The bound on the double-double roots, 2^-95, with its reserve.
TEST(GaussRuleOfDoubleDoubles, IsFarWithinWhatBallsAllowForIt) {
  const auto rules = MakeGaussRules<DoubleDouble>(0);
  const auto truth = MakeGaussRules<Multiprecision>(kPrecision);
  for (std::size_t k = 0; k < rules.size(); ++k) {
    for (std::size_t i = 0; i < rules[k].nodes.size(); ++i) {
      EXPECT_LE(Abs(ToReal(rules[k].nodes[i]) - ToReal(truth[k].nodes[i])),
                Real(0x1p-98));
      EXPECT_LE(Abs(ToReal(rules[k].weights[i]) - ToReal(truth[k].weights[i])),
                Real(0x1p-98));
    }
  }
}

}  // namespace
}  // namespace truelux::testing
