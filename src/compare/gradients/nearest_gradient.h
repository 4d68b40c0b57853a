// SPDX-License-Identifier: GPL-3.0-or-later
// At a kink: the generalized gradient that a value is nearest to.

#ifndef TRUELUX_COMPARE_GRADIENTS_NEAREST_GRADIENT_H_
#define TRUELUX_COMPARE_GRADIENTS_NEAREST_GRADIENT_H_

#include <cstddef>
#include <span>

#include "truelux/derivatives.h"
#include "truelux/geometry.h"

namespace truelux {

/// Of the vectors mean + the sum over kinks of t b m, t in [-1, 1] each, the one
/// nearest to value: they are the gradients on all sides of the kinks and what
/// lies between (Clarke's generalized gradient). Any of them is a fair answer
/// of a program that gives one vector. In binary64: off by a few 1e-16 of the
/// largest |b| for one kink, and by 1e-12 of it for several. mean itself, bit for
/// bit, if value is that; mean if value is no number.
[[nodiscard]] Vector3 NearestGradient(const Vector3& mean,
                                      std::span<const Kink> kinks,
                                      std::size_t channel,
                                      const Vector3& value);

}  // namespace truelux

#endif  // TRUELUX_COMPARE_GRADIENTS_NEAREST_GRADIENT_H_
