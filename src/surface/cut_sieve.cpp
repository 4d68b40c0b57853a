// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/cut_sieve.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace truelux {
namespace {

/// Directions that something can have from one place; without an end it reaches
/// the trace.
struct Range {
  std::optional<mpq_class> least;
  std::optional<mpq_class> most;
};

/// The ranges from both ends of the trace. Between them the least one is
/// concave, and the most one convex.
struct Reach {
  int line = 0;
  std::array<Range, 2> ranges;
};

Range RangeOf(const PlaneCut& cut, const CutSegment& segment,
              const mpq_class& t, bool to_right, bool to_left) {
  Range range;
  bool is_first = true;
  for (const int end : segment.ends) {
    if (end == kOnTrace) continue;
    const mpq_class u =
        cut.points[static_cast<std::size_t>(end)].DirectionFrom(t);
    if (is_first || u < *range.least) range.least = u;
    if (is_first || u > *range.most) range.most = u;
    is_first = false;
  }
  if (to_right) range.most.reset();
  if (to_left) range.least.reset();
  return range;
}

Reach ReachOf(const PlaneCut& cut, const CutSegment& segment) {
  const mpq_class& foot = cut.lines[static_cast<std::size_t>(segment.line)].c;
  const bool is_long =
      std::ranges::find(segment.ends, kOnTrace) != segment.ends.end();
  // A foot between the ends is seen on either side.
  const bool to_right = is_long && foot > 0;
  const bool to_left = is_long && foot < 1;
  return {segment.line,
          {RangeOf(cut, segment, 0, to_right, to_left),
           RangeOf(cut, segment, 1, to_right, to_left)}};
}

/// Whether a lies on the left of b from all places of the trace.
bool IsLeftOf(const Reach& a, const Reach& b) {
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& most = a.ranges[k].most;
    const auto& least = b.ranges[k].least;
    if (!most || !least || *most >= *least) return false;
  }
  return true;
}

bool MayOverlap(const Reach& a, const Reach& b) {
  return !IsLeftOf(a, b) && !IsLeftOf(b, a);
}

bool MayOverlapOne(const Reach& a, const std::vector<Reach>& others) {
  return std::ranges::any_of(
      others, [&a](const Reach& other) { return MayOverlap(a, other); });
}

}  // namespace

void DropWithoutEffect(PlaneCut& cut) {
  std::vector<Reach> lights;
  std::vector<Reach> bounds;
  for (const CutFacet& facet : cut.facets) {
    if (!facet.is_light && !facet.is_bound) continue;
    Reach reach = ReachOf(cut, facet.segment);
    if (facet.is_light) lights.push_back(reach);
    if (facet.is_bound) bounds.push_back(std::move(reach));
  }
  for (const CutFlat& flat : cut.flats) {
    for (const CutSegment& side : flat.sides) {
      bounds.push_back(ReachOf(cut, side));
      if (flat.is_light) lights.push_back(bounds.back());
    }
  }
  // Lines count that overlap another one and a light.
  std::vector<Reach> counting;
  for (const Reach& bound : bounds) {
    const bool has_other = std::ranges::any_of(bounds, [&](const Reach& other) {
      return other.line != bound.line && MayOverlap(bound, other);
    });
    if (has_other && MayOverlapOne(bound, lights)) counting.push_back(bound);
  }
  std::erase_if(cut.facets, [&](const CutFacet& facet) {
    const Reach reach = ReachOf(cut, facet.segment);
    return !MayOverlapOne(reach, counting) || !MayOverlapOne(reach, lights);
  });
  if (counting.empty()) cut.flats.clear();
}

}  // namespace truelux
