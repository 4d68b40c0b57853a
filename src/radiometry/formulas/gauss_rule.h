// SPDX-License-Identifier: GPL-3.0-or-later
// Gauss-Legendre rules on [0, 1].

#ifndef TRUELUX_RADIOMETRY_FORMULAS_GAUSS_RULE_H_
#define TRUELUX_RADIOMETRY_FORMULAS_GAUSS_RULE_H_

#include <array>
#include <vector>

#include "exact/numeric.h"

namespace truelux {

/// Exact for polynomials up to degree 2 n - 1, n its number of nodes.
template <class T>
struct GaussRule {
  std::vector<T> nodes;
  std::vector<T> weights;  ///< positive; their sum is 1
};

inline constexpr std::array<int, 6> kGaussSizes = {3, 4, 5, 6, 8, 10};

/// One rule for each of kGaussSizes.
template <class T>
using GaussRules = std::array<GaussRule<T>, kGaussSizes.size()>;

/// precision [bits]: of Multiprecision; not looked at otherwise. Nodes and
/// weights are off by a few units in the last place; a Ball holds that.
template <class T>
GaussRules<T> MakeGaussRules(mpfr_prec_t precision);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_FORMULAS_GAUSS_RULE_H_
