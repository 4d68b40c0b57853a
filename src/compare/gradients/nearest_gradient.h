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
/// of a program that gives one vector. In binary64: off by some 1e-15 of the sum of
/// |mean| and all |b|, divided by the angle between the normals of kinks where
/// these are nearly parallel; value itself, bit for bit, if it is as near as that to
/// one of them; mean if value is no number.
[[nodiscard]] Vector3 NearestGradient(const Vector3& mean,
                                      std::span<const Kink> kinks,
                                      std::size_t channel,
                                      const Vector3& value);

}  // namespace truelux

#endif  // TRUELUX_COMPARE_GRADIENTS_NEAREST_GRADIENT_H_
