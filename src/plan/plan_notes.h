// SPDX-License-Identifier: GPL-3.0-or-later
// What is proven about contours, in words.

#ifndef TRUELUX_PLAN_PLAN_NOTES_H_
#define TRUELUX_PLAN_PLAN_NOTES_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "truelux/isolux.h"

namespace truelux {

/// A sentence each, the most important first.
[[nodiscard]] std::vector<std::string> PlanNotes(const Isolux& isolux);

/// About the lines at which light jumps: how many there are, and whether these
/// are all.
[[nodiscard]] std::vector<std::string> LineNotes(const SurfaceLines& lines);

/// What is proven about extrema, a sentence each.
[[nodiscard]] std::vector<std::string> ExtremaNotes(
    const SurfaceExtrema& extrema);

/// How often irradiance was asked for.
[[nodiscard]] std::string WorkNote(const Isolux& isolux);

/// "1 vertex", "12 vertices".
[[nodiscard]] std::string Counted(std::size_t count, std::string_view one,
                                  std::string_view more);

/// "12", "0.034", "6.7e-07": a number for people, with a few digits.
[[nodiscard]] std::string ShortNumber(double value);

/// The same, rounded up: of a bound from above.
[[nodiscard]] std::string ShortBound(double value);

/// "12 %", "6.7e-05 %": a part of a whole.
[[nodiscard]] std::string ShareText(double part, double whole);

}  // namespace truelux

#endif  // TRUELUX_PLAN_PLAN_NOTES_H_
