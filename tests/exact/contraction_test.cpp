// SPDX-License-Identifier: GPL-3.0-or-later
// No product is fused with a sum: results are the same with and without the
// instructions of a processor, and at every level of optimisation.

#include <cstddef>
#include <random>

#include <gtest/gtest.h>

namespace truelux {
namespace {

struct Point2 {
  double x;
  double y;
};

/// A difference and a sum of products side by side, as GCC 12 fuses them at -O3
/// despite -ffp-contract=off. Not inlined, so that they are compiled like this.
[[gnu::noinline]] Point2 Turned(const Point2& p, double c, double s) {
  return {c * p.x - s * p.y, c * p.y + s * p.x};
}

[[gnu::noinline]] double ProductPlus(double x, double y, double z) {
  return x * y + z;
}

/// The product of two numbers, which the compiler must write to memory.
double Rounded(double x, double y) {
  const volatile double product = x * y;
  return product;
}

TEST(Contraction, ProductsAreRoundedBeforeTheyAreAdded) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::size_t fused_would_differ = 0;
  for (int i = 0; i < 1000; ++i) {
    const Point2 p{uniform(random), uniform(random)};
    const double c = uniform(random);
    const double s = uniform(random);
    const Point2 q = Turned(p, c, s);
    const double difference = Rounded(c, p.x) - Rounded(s, p.y);
    EXPECT_EQ(q.x, difference);
    EXPECT_EQ(q.y, Rounded(c, p.y) + Rounded(s, p.x));
    EXPECT_EQ(ProductPlus(c, p.x, s), Rounded(c, p.x) + s);
    if (__builtin_fma(c, p.x, -Rounded(s, p.y)) != difference) {
      ++fused_would_differ;
    }
  }
  EXPECT_GT(fused_would_differ, 100U);
}

}  // namespace
}  // namespace truelux
