// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/surface_side.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace truelux {
namespace {

Point3 RoundedOf(const RationalVector& p) {
  return {NearestTo(p.x), NearestTo(p.y), NearestTo(p.z)};
}

/// E on both sides of the middle of a line.
void SetSides(const Oracle& oracle, const PlanFrame& plan, double aside,
              SurfaceLine& line) {
  const Vec3<double> a = plan.PlaceOf(line.ends[0]);
  const Vec3<double> b = plan.PlaceOf(line.ends[1]);
  const PlanPoint way = {b.x - a.x, b.y - a.y};
  const double length = LengthOf(way);
  if (length == 0) return;
  const PlanPoint middle = {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)};
  const PlanPoint left = {-way.t * aside / length, way.s * aside / length};
  line.left = oracle.Evaluate(plan.ReceiverAt(middle + left)).value;
  line.right = oracle.Evaluate(plan.ReceiverAt(middle - left)).value;
}

}  // namespace

std::vector<SurfaceSide> SidesOf(const Scene& scene, const SurfaceFrame& frame,
                                 const EdgePlanes& planes, const Watch& watch) {
  std::vector<SurfaceSide> sides;
  for (const bool is_reverse : {false, true}) {
    std::vector<int> faces = FacesOfSide(frame, is_reverse);
    if (faces.empty()) continue;
    sides.push_back(
        {std::move(faces), PlanFrame(scene, frame, is_reverse),
         SurfaceLinesOf(scene, frame, planes, is_reverse, watch.stop)});
  }
  return sides;
}

std::vector<SurfaceLine> ShownLines(const Oracle& oracle,
                                    const SurfaceSide& side, double aside) {
  std::vector<SurfaceLine> shown;
  for (const ExactSurfaceLine& exact : side.lines.lines) {
    SurfaceLine& line = shown.emplace_back();
    line.kind = exact.is_jump ? SurfaceLineKind::kJump : SurfaceLineKind::kKink;
    line.ends = {RoundedOf(exact.from), RoundedOf(exact.to)};
    line.faces = exact.faces;
    line.edges = exact.edges;
    line.size = exact.size;
    if (oracle.options().emission == Emission::kRadiance) {
      for (double& b : line.size)
        b *= std::numbers::pi;
    }
    if (exact.is_jump) SetSides(oracle, side.plan, aside, line);
  }
  return shown;
}

}  // namespace truelux
