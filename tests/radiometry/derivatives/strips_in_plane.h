// SPDX-License-Identifier: GPL-3.0-or-later
// The strips beside one plane through the receiver, for StripsTwin.

#ifndef TRUELUX_TESTS_RADIOMETRY_DERIVATIVES_STRIPS_IN_PLANE_H_
#define TRUELUX_TESTS_RADIOMETRY_DERIVATIVES_STRIPS_IN_PLANE_H_

#include <span>

#include "truelux/geometry.h"

#include "exact/rational.h"
#include "radiometry/derivatives/strips_twin.h"

namespace truelux::testing {

/// b of the plane with the normal m, for a receiver with the normal n that lies
/// on no sheet.
Rgb KinkSize(std::span<const Sheet> sheets, const RationalVector& m,
             const RationalVector& n);

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_RADIOMETRY_DERIVATIVES_STRIPS_IN_PLANE_H_
