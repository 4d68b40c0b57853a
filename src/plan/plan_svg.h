// SPDX-License-Identifier: GPL-3.0-or-later
// Contours as a plan for people: SVG.

#ifndef TRUELUX_PLAN_PLAN_SVG_H_
#define TRUELUX_PLAN_PLAN_SVG_H_

#include <string>

#include "truelux/isolux.h"

#include "plan/plan_subject.h"

namespace truelux {

/// The surface as its lit side is seen, with contours by the colours of their
/// levels, which stand in gaps of the lines, lines at which light jumps, what is
/// open, under these the objects above the surface, and a legend. In a browser,
/// lines and objects tell under the pointer what they are.
[[nodiscard]] std::string PlanSvg(const Isolux& isolux,
                                  const PlanSubject& subject);

}  // namespace truelux

#endif  // TRUELUX_PLAN_PLAN_SVG_H_
