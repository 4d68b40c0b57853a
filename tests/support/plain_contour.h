// SPDX-License-Identifier: GPL-3.0-or-later
// The contour engine's slow twin: every edge against every triangle. No boxes,
// no index, no pieces but triangles, no edge left out, nothing trimmed.

#ifndef TRUELUX_TESTS_SUPPORT_PLAIN_CONTOUR_H_
#define TRUELUX_TESTS_SUPPORT_PLAIN_CONTOUR_H_

#include "visibility/contour.h"

namespace truelux::testing {

/// The visible contours that ContourEngine::Build finds, bounded by the same
/// arcs up to their order and to where they are split.
Contour PlainContour(const ContourQuery& query);

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_SUPPORT_PLAIN_CONTOUR_H_
