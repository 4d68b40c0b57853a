// SPDX-License-Identifier: GPL-3.0-or-later
// What stands or hangs above a surface, as furniture is on a floor plan.

#ifndef TRUELUX_PLAN_OBJECT_DRAWING_H_
#define TRUELUX_PLAN_OBJECT_DRAWING_H_

#include <span>
#include <string>

#include "plan/paper.h"
#include "plan/plan_objects.h"

namespace truelux {

/// How an object looks in the plan and beside it. The stroke lies below the
/// fill, so that sides between two faces of an object are not seen; where
/// objects overlap, no colour gets darker than the fill.
inline constexpr const char* kObjectStyle =
    "fill=\"#dde3ea\" stroke=\"#748292\" stroke-width=\"1.6\" "
    "stroke-linejoin=\"round\" paint-order=\"stroke\" opacity=\"0.6\"";
/// How a lamp looks.
inline constexpr const char* kLampStyle =
    "fill=\"none\" stroke=\"#f0a020\" stroke-width=\"1.1\" "
    "stroke-dasharray=\"6 3\"";

/// Elements of SVG, and which kinds are among them.
struct ObjectDrawing {
  std::string elements;
  bool has_objects = false;  ///< some that do not emit
  bool has_lamps = false;
};

/// Objects in orthogonal projection, cut off at the plan's area. Left out is
/// what does not emit and would hide the whole plan: the box around it covers
/// three quarters of the area. Of what has very many corners the box is drawn.
[[nodiscard]] ObjectDrawing DrawObjects(std::span<const PlanObject> objects,
                                        const Paper& paper);

}  // namespace truelux

#endif  // TRUELUX_PLAN_OBJECT_DRAWING_H_
