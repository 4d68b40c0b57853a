// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/view/nearest_edge.h"

#include <algorithm>
#include <cmath>

#include "visibility/view/rounded_angles.h"

namespace truelux {
namespace {

/// What looks nearer than this is measured again from exact numbers [rad].
constexpr double kClose = 1e-6;

}  // namespace

NearestEdge::NearestEdge(const EdgeIndex& index, const FacetFront& source)
    : source_(source),
      exact_(ViewOf(index.query())),
      interval_(ViewOf(index.query())) {
  for (const SceneEdgeId e : index.edges()) {
    if (index.CouldBound(e, source)) Add(index.SegmentOf(e));
  }
  for (const TriangleId t : index.triangles()) {
    if (const auto cut = index.CutOf(t, source)) Add(*cut);
  }
}

void NearestEdge::Add(const Segment& segment) {
  Vec3<Interval> from;
  Vec3<Interval> to;
  {
    const RoundUpward rounding;
    from = interval_.Direction(segment.from, {}, {});
    to = interval_.Direction(segment.to, {}, {});
  }
  Candidate candidate{segment, UnitOf(from), UnitOf(to), 0};
  candidate.length = AngleBetween(candidate.from, candidate.to);
  candidates_.push_back(candidate);
}

bool NearestEdge::Passes(const Segment& segment, const Vec3<Exact>& d) const {
  const auto point = PointOnArc(exact_.Direction(segment.from, {}, {}),
                                exact_.Direction(segment.to, {}, {}), d);
  return point && !source_.IsBehind(segment, *point);
}

/// The angle from d, which is `unit` rounded, to a segment that does not pass
/// through it; angle: the rounded one, below kClose.
double NearestEdge::CloseAngle(const Candidate& candidate, const Vec3<Exact>& d,
                               const Vec3<double>& unit, double angle) const {
  const Vec3<Exact> plane =
      Cross(exact_.Direction(candidate.segment.from, {}, {}),
            exact_.Direction(candidate.segment.to, {}, {}));
  const Exact height = Dot(plane, d);
  const double size = std::sqrt(CGAL::to_double(Dot(plane, plane)) *
                                CGAL::to_double(Dot(d, d)));
  const double sine = std::abs(CGAL::to_double(height)) / size;
  const double to_ends = std::min(AngleBetween(unit, candidate.from),
                                  AngleBetween(unit, candidate.to));
  // Beside the segment its plane is near; beyond its ends they are.
  const bool is_beside = to_ends > kClose || angle < to_ends;
  return is_beside && sine > 0 ? sine : to_ends;
}

std::optional<EdgeMiss> NearestEdge::To(const Vec3<Exact>& d) const {
  const Vec3<double> unit = UnitOf(d);
  std::optional<EdgeMiss> nearest;
  for (const Candidate& candidate : candidates_) {
    if (nearest && LeastAngle(unit, candidate.from, candidate.length) >
                       nearest->angle + kClose) {
      continue;
    }
    const Vec3<double> cross = Cross(candidate.from, candidate.to);
    const double length = RoundedLength(cross);
    const Vec3<double> normal = length > 0 ? 1 / length * cross : cross;
    double angle = AngleToArc(unit, candidate.from, candidate.to, normal);
    if (nearest && angle > nearest->angle + kClose) continue;
    if (angle < kClose) {
      if (Passes(candidate.segment, d)) continue;
      angle = CloseAngle(candidate, d, unit, angle);
      if (!(angle > 0) || !std::isfinite(angle)) continue;
    }
    if (!nearest || angle < nearest->angle)
      nearest = EdgeMiss{candidate.segment.edge, angle};
  }
  return nearest;
}

}  // namespace truelux
