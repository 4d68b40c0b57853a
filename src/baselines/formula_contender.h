// SPDX-License-Identifier: GPL-3.0-or-later
// The closed formulas as methods that are compared.

#ifndef TRUELUX_BASELINES_FORMULA_CONTENDER_H_
#define TRUELUX_BASELINES_FORMULA_CONTENDER_H_

#include "truelux/formulas.h"
#include "truelux/scene.h"

#include "baselines/contender.h"

namespace truelux {

/// A formula, but kAuto, on the visible contour of the default engine, in an
/// arithmetic, the sum over the sources as well; MPFR has 128 bits.
///
/// Counted are the contour and the formula's sum, not the rounding of the
/// contour to the number type, which goes through double-double, so that all
/// types start from the same numbers. For one thread.
Contender FormulaContender(const Scene& scene, Formula formula,
                           Arithmetic arithmetic);

}  // namespace truelux

#endif  // TRUELUX_BASELINES_FORMULA_CONTENDER_H_
