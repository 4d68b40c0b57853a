// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/formulas/gauss_rule.h"

#include <cmath>
#include <numbers>
#include <type_traits>

namespace truelux {
namespace {

/// The type in which roots are found.
template <class T>
using RootType = std::conditional_t<std::is_same_v<T, Multiprecision>,
                                    Multiprecision, DoubleDouble>;

template <class R>
R Start(double x, mpfr_prec_t precision) {
  if constexpr (std::is_same_v<R, Multiprecision>) {
    return {precision, x};
  } else {
    return Make<R>(x);
  }
}

template <class T>
T Rounded(const RootType<T>& x) {
  if constexpr (std::is_same_v<T, RootType<T>>) {
    return x;
  } else if constexpr (kIsBall<T>) {
    return {x.high, std::fabs(x.low) + 0x1p-95};
  } else {
    return static_cast<T>(x.high);
  }
}

/// The Legendre polynomial of degree n at x and its derivative.
template <class R>
struct Legendre {
  R value;
  R slope;
};

template <class R>
Legendre<R> LegendreAt(int n, const R& x) {
  const R one = Make<R>(1);
  R before = one;
  R value = x;
  for (int k = 2; k <= n; ++k) {
    const R next =
        (Make<R>(2 * k - 1) * x * value - Make<R>(k - 1) * before) / Make<R>(k);
    before = value;
    value = next;
  }
  return {value, Make<R>(n) * (x * value - before) / (x * x - one)};
}

/// Newton's steps double the correct bits, 13 at the start: enough for 2^18.
constexpr int kSteps = 15;

template <class T>
GaussRule<T> MakeRule(int n, mpfr_prec_t precision) {
  using R = RootType<T>;
  GaussRule<T> rule;
  for (int i = 1; i <= n; ++i) {
    R x = Start<R>(std::cos(std::numbers::pi * (i - 0.25) / (n + 0.5)),
                   precision);
    for (int step = 0; step < kSteps; ++step) {
      const Legendre<R> p = LegendreAt(n, x);
      x = x - p.value / p.slope;
    }
    const R slope = LegendreAt(n, x).slope;
    const R one = Make<R>(1);
    rule.nodes.push_back(Rounded<T>((x + one) / Make<R>(2)));
    rule.weights.push_back(Rounded<T>(one / ((one - x * x) * slope * slope)));
  }
  return rule;
}

}  // namespace

template <class T>
GaussRules<T> MakeGaussRules(mpfr_prec_t precision) {
  GaussRules<T> rules;
  for (std::size_t i = 0; i < rules.size(); ++i) {
    rules[i] = MakeRule<T>(kGaussSizes[i], precision);
  }
  return rules;
}

template GaussRules<float> MakeGaussRules(mpfr_prec_t);
template GaussRules<double> MakeGaussRules(mpfr_prec_t);
template GaussRules<DoubleDouble> MakeGaussRules(mpfr_prec_t);
template GaussRules<Ball<double>> MakeGaussRules(mpfr_prec_t);
template GaussRules<Multiprecision> MakeGaussRules(mpfr_prec_t);

}  // namespace truelux
