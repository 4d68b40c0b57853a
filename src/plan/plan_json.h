// SPDX-License-Identifier: GPL-3.0-or-later
// Contours with all that is known about them, as JSON.

#ifndef TRUELUX_PLAN_PLAN_JSON_H_
#define TRUELUX_PLAN_PLAN_JSON_H_

#include <string>

#include "truelux/isolux.h"

#include "plan/plan_subject.h"

namespace truelux {

/// An object, ended by a line end; one contour, line or triangle a line of the
/// text. The width of a chord that is not known is null.
[[nodiscard]] std::string PlanJson(const Isolux& isolux,
                                   const PlanSubject& subject);

}  // namespace truelux

#endif  // TRUELUX_PLAN_PLAN_JSON_H_
