// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/kink_events.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/stop.h"

namespace truelux {
namespace {

/// p and z of a point, each off by less than 2^-52 of itself.
struct NearPoint {
  double p;
  double z;
};

/// Whether double arithmetic proves that two points are in one direction at no
/// t from 0 to 1: t (a.z - b.z) = a.p - b.p.
bool AreClearlyApart(const NearPoint& a, const NearPoint& b) {
  const double p = a.p - b.p;
  const double z = a.z - b.z;
  const double slack = 0x1p-50 * (std::fabs(a.p) + std::fabs(b.p) +
                                  std::fabs(a.z) + std::fabs(b.z)) +
                       0x1p-900;
  if (!std::isfinite(slack)) return false;
  // The difference at t is p - t z, of one sign if it is at both ends.
  return (p > slack && p - z > slack) || (p < -slack && p - z < -slack);
}

bool IsBetweenEnds(const mpq_class& t) {
  return sgn(t) > 0 && cmp(t, 1) < 0;
}

bool ShareALine(const CutPoint& a, const CutPoint& b) {
  return std::ranges::any_of(a.lines, [&b](int line) {
    return std::ranges::find(b.lines, line) != b.lines.end();
  });
}

}  // namespace

std::vector<mpq_class> EventsOf(const PlaneCut& cut, const StripFinder& finder,
                                const StopFlag* stop) {
  std::vector<mpq_class> events = {0, 1};
  const auto add = [&events](const mpq_class& t) {
    if (IsBetweenEnds(t)) events.push_back(t);
  };
  for (const CutLine& line : cut.lines) {
    if (!line.is_level) add(line.c);
  }
  for (const auto& contact : cut.contacts) {
    add(contact[0]);
    add(contact[1]);
  }
  std::vector<NearPoint> near;
  for (const CutPoint& point : cut.points)
    near.push_back({point.p.get_d(), point.z.get_d()});
  for (std::size_t i = 0; i < cut.points.size(); ++i) {
    StopIfAsked(stop);
    const CutPoint& a = cut.points[i];
    for (std::size_t k = i + 1; k < cut.points.size(); ++k) {
      const CutPoint& b = cut.points[k];
      // Points of one line appear in one direction where it meets the trace.
      if (AreClearlyApart(near[i], near[k]) || a.z == b.z || ShareALine(a, b))
        continue;
      const mpq_class t = (a.p - b.p) / (a.z - b.z);
      if (IsBetweenEnds(t) && finder.Matters(t, a.DirectionFrom(t)))
        events.push_back(t);
    }
  }
  std::ranges::sort(events);
  events.erase(std::unique(events.begin(), events.end()), events.end());
  return events;
}

}  // namespace truelux
