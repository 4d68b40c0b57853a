// SPDX-License-Identifier: GPL-3.0-or-later
// An Isolux made by hand, with everything in it that files may have to show.

#ifndef TRUELUX_TESTS_PLAN_MADE_ISOLUX_H_
#define TRUELUX_TESTS_PLAN_MADE_ISOLUX_H_

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "truelux/isolux.h"

#include "plan/plan_subject.h"

namespace truelux::testing {

/// A rectangle from (0, 0, 1) to (width, height, 1), lit from above.
inline Isolux MadeFloor(double width, double height) {
  Isolux isolux;
  isolux.right = {1, 0, 0};
  isolux.up = {0, 1, 0};
  const std::array<Point3, 4> corners = {
      {{0, 0, 1}, {width, 0, 1}, {width, height, 1}, {0, height, 1}}};
  for (std::size_t i = 0; i < 4; ++i)
    isolux.outline.push_back({corners[i], corners[(i + 1) % 4]});
  isolux.size = std::max(width, height);
  isolux.area = width * height;
  return isolux;
}

/// A circle or, if it is not closed, its upper half.
inline IsoluxContour MadeCircle(double level, double x, double y, double radius,
                                bool is_closed, int steps = 90) {
  IsoluxContour contour;
  contour.level = level;
  contour.is_closed = is_closed;
  const double turn = is_closed ? 2 * std::numbers::pi : std::numbers::pi;
  const int count = is_closed ? steps : steps + 1;
  for (int i = 0; i < count; ++i) {
    const double angle = turn * i / steps;
    const Vector3 out{std::cos(angle), std::sin(angle), 0};
    contour.vertices.push_back({{x + radius * out.x, y + radius * out.y, 1},
                                {-out.x, -out.y, 0},
                                1e-9,
                                true,
                                !is_closed && (i == 0 || i == steps)
                                    ? ContourPlace::kJump
                                    : ContourPlace::kInside});
  }
  contour.widths.assign(static_cast<std::size_t>(steps), 1e-3 * radius);
  return contour;
}

/// Rings around two lamps, half rings at a wall, and one of each other thing.
inline Isolux MadeIsolux() {
  Isolux isolux = MadeFloor(10, 8);
  for (int i = 0; i < 7; ++i) {
    const double level = 0.1 * (i + 1);
    isolux.levels.push_back(level);
    const double radius = 3.3 - 0.45 * i;
    isolux.contours.push_back(MadeCircle(level, 3.5, 4, radius, true));
    if (i < 4)
      isolux.contours.push_back(
          MadeCircle(level, 8.4, 2, 1.4 - 0.4 * i, false));
  }
  isolux.levels.push_back(7);  // no line has it
  isolux.contours[1].vertices[2].is_certified = false;
  isolux.contours[1].widths[3] = std::numeric_limits<double>::infinity();
  SurfaceLine jump;
  jump.kind = SurfaceLineKind::kJump;
  jump.ends = {{{7, 2, 1}, {9.8, 2, 1}}};
  jump.faces = {3, 5};
  jump.left = {1, 2, 3};
  SurfaceLine kink;
  kink.ends = {{{0, 1, 1}, {10, 7, 1}}};
  kink.edges = {{0, 2}, {-1, -1}};
  kink.size = {-0.5, 0.25, 1e-300};
  isolux.lines.lines = {jump, kink};
  isolux.lines.notes = {{Severity::kNote, "", 0, "say \"so\""}};
  isolux.open.push_back({{{{1, 1, 1}, {1.5, 1, 1}, {1, 1.5, 1}}}, 0, 0.75});
  isolux.open_area = 0.125;
  isolux.dark_area = 8;
  isolux.least = 0;
  isolux.most = 0.8125;
  isolux.search_evaluations = 1000;
  isolux.line_evaluations = 4000;
  isolux.triangles = 321;
  return isolux;
}

inline PlanSubject MadeSubject() {
  return {.scene = "room.obj",
          .surface = "floor",
          .channel = "luminance",
          .options = {},
          .vertex_numbers = {11, 12, 13},
          .objects = {}};
}

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_PLAN_MADE_ISOLUX_H_
