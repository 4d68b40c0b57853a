// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspect/view_measure.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/vector_math.h"

namespace truelux {
namespace {

constexpr double kPi = std::numbers::pi;

const Vector3& DirectionOf(const WholeView& view, int vertex) {
  return view.vertices[static_cast<std::size_t>(vertex)].vertex.direction;
}

/// The angle from a to b, counter-clockwise about unit normal n, all in one
/// plane. Rounding must not turn a short arc into a circle, nor the reverse.
double AngleOf(const Vector3& a, const Vector3& b, const Vector3& n,
               bool at_least_pi) {
  // a x (b - a) keeps the digits of a short arc.
  const double angle =
      std::atan2(Dot(Cross(a, Difference(b, a)), n), Dot(a, b));
  if (!at_least_pi) return std::abs(angle);
  return angle < 1 ? angle + 2 * kPi : angle;
}

/// The arc run through the other way.
CircleArc Reversed(const CircleArc& arc) {
  const Vector3 side = arc.At(arc.angle + kPi / 2);
  return {arc.At(arc.angle), {-side.x, -side.y, -side.z}, arc.angle};
}

/// Van Oosterom and Strackee, from differences of the corners.
double SignedTriangle(const Vector3& a, const Vector3& b, const Vector3& c) {
  const double volume = Dot(a, Cross(Difference(b, a), Difference(c, a)));
  return 2 * std::atan2(volume, 1 + Dot(a, b) + Dot(b, c) + Dot(c, a));
}

}  // namespace

Vector3 InFrame(const Vector3& v, const ViewFrame& frame) {
  return {Dot(v, frame.right), Dot(v, frame.up), Dot(v, frame.ahead)};
}

double AngleOfArc(const WholeView& view, const WholeViewArc& arc) {
  if (arc.from == arc.to) return 2 * kPi;
  return AngleOf(UnitOf(DirectionOf(view, arc.from)),
                 UnitOf(DirectionOf(view, arc.to)), UnitOf(arc.plane_normal),
                 arc.at_least_pi);
}

CircleArc ArcInFrame(const WholeView& view, const WholeViewArc& arc,
                     const ViewFrame& frame) {
  // right, up, ahead turn to the left: what runs counter-clockwise about the
  // normal runs clockwise in the frame.
  const Vector3 n = UnitOf(InFrame(arc.plane_normal, frame));
  Vector3 start{1, 0, 0};  // of the whole horizon
  if (arc.from >= 0)
    start = UnitOf(InFrame(UnitOf(DirectionOf(view, arc.from)), frame));
  const Vector3 side = Cross(n, start);
  return {start, {-side.x, -side.y, -side.z}, AngleOfArc(view, arc)};
}

std::vector<std::vector<CircleArc>> BorderOf(const WholeView& view, int region,
                                             const ViewFrame& frame) {
  std::vector<std::vector<CircleArc>> border;
  for (const ViewLoop& loop :
       view.regions[static_cast<std::size_t>(region)].loops) {
    std::vector<CircleArc>& arcs = border.emplace_back();
    for (const int a : loop.arcs) {
      const WholeViewArc& arc = view.arcs[static_cast<std::size_t>(a)];
      const CircleArc own = ArcInFrame(view, arc, frame);
      arcs.push_back(arc.left == region ? own : Reversed(own));
    }
  }
  return border;
}

Vector3 MiddleOf(const std::vector<std::vector<CircleArc>>& border) {
  Vector3 sum{0, 0, 0};
  double length = 0;
  for (const auto& loop : border) {
    for (const CircleArc& arc : loop) {
      // The integral of the direction along the arc.
      const double s = std::sin(arc.angle);
      const double c = 1 - std::cos(arc.angle);
      sum = {sum.x + s * arc.start.x + c * arc.side.x,
             sum.y + s * arc.start.y + c * arc.side.y,
             sum.z + s * arc.start.z + c * arc.side.z};
      length += arc.angle;
    }
  }
  // Of a border around most of the hemisphere any direction inside will do.
  constexpr double kNarrow = 0.3;
  if (!(Dot(sum, sum) > kNarrow * kNarrow * length * length)) return {0, 0, 1};
  return UnitOf(sum);
}

double SolidAngleOf(const std::vector<std::vector<CircleArc>>& border) {
  const Vector3 middle = MiddleOf(border);
  double sum = 0;
  for (const auto& loop : border) {
    for (const CircleArc& arc : loop) {
      const int pieces = std::max(1, static_cast<int>(std::ceil(arc.angle)));
      for (int i = 0; i < pieces; ++i) {
        // Clockwise in a frame that turns to the left.
        sum -= SignedTriangle(middle, arc.At(i * arc.angle / pieces),
                              arc.At((i + 1) * arc.angle / pieces));
      }
    }
  }
  return sum;
}

}  // namespace truelux
