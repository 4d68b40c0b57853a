// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/cut_merge.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "scene/emitters.h"

namespace truelux {
namespace {

bool HaveSameEnds(const CutSegment& a, const CutSegment& b) {
  return a.ends == b.ends || (a.ends[0] == b.ends[1] && a.ends[1] == b.ends[0]);
}

/// Makes one part of two that lie on both sides of a line.
void JoinSides(std::vector<CutFacet>& facets) {
  for (std::size_t i = 0; i < facets.size(); ++i) {
    for (std::size_t k = i + 1; k < facets.size(); ++k) {
      if (facets[i].facet == facets[k].facet && facets[i].side != 0 &&
          facets[i].side == -facets[k].side &&
          facets[i].segment.line == facets[k].segment.line &&
          HaveSameEnds(facets[i].segment, facets[k].segment)) {
        facets[i].side = 0;
        facets.erase(facets.begin() + static_cast<std::ptrdiff_t>(k));
        break;
      }
    }
  }
}

/// Puts b at the end of a, if they meet in a point.
bool JoinsEnds(CutSegment& a, const CutSegment& b) {
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      if (a.ends[i] != kOnTrace && a.ends[i] == b.ends[k]) {
        a.ends[i] = b.ends[1 - k];
        return true;
      }
    }
  }
  return false;
}

void JoinParts(std::vector<CutFacet>& facets) {
  for (std::size_t i = 0; i < facets.size(); ++i) {
    for (std::size_t k = i + 1; k < facets.size();) {
      if (facets[i].facet == facets[k].facet &&
          facets[i].side == facets[k].side &&
          facets[i].segment.line == facets[k].segment.line &&
          JoinsEnds(facets[i].segment, facets[k].segment)) {
        facets.erase(facets.begin() + static_cast<std::ptrdiff_t>(k));
        k = i + 1;
      } else {
        ++k;
      }
    }
  }
}

/// Calls visit with every segment of facets, flat triangles and edges.
template <class Visit>
void ForEachSegment(PlaneCut& cut, const Visit& visit) {
  for (CutFacet& facet : cut.facets)
    visit(facet.segment);
  for (CutFlat& flat : cut.flats) {
    for (CutSegment& side : flat.sides)
      visit(side);
  }
  for (CutEdge& edge : cut.edges)
    visit(edge.segment);
}

bool FacetEmits(const Scene& scene, int facet) {
  const int face = scene.facets()[static_cast<std::size_t>(facet)].face;
  return Emits(scene.faces()[static_cast<std::size_t>(face)]);
}

/// Whether the front of a facet is seen from some place of the trace.
bool MayShowFront(const PlaneCut& cut, const CutFacet& facet) {
  const CutLine& line = cut.lines[static_cast<std::size_t>(facet.segment.line)];
  return facet.turn * sgn(line.HeightAt(0)) < 0 ||
         facet.turn * sgn(line.HeightAt(1)) < 0;
}

/// Whether a facet has an edge at its line, or another facet pierces it there.
bool IsBound(const PlaneCut& cut, const CutFacet& facet) {
  return facet.side != 0 ||
         std::ranges::any_of(cut.facets, [&facet](const CutFacet& other) {
           return other.segment.line == facet.segment.line &&
                  other.tilt != facet.tilt;
         });
}

/// Whether a point of a segment's line lies on the segment.
bool Holds(const PlaneCut& cut, const CutSegment& segment,
           const CutPoint& point) {
  const bool is_level =
      cut.lines[static_cast<std::size_t>(segment.line)].is_level;
  const auto place = [is_level](const CutPoint& p) -> const mpq_class& {
    return is_level ? p.p : p.z;
  };
  bool is_before = false;
  bool is_behind = false;
  for (const int end : segment.ends) {
    // z grows without bound towards the trace.
    const int order =
        end == kOnTrace ? 1
                        : cmp(place(cut.points[static_cast<std::size_t>(end)]),
                              place(point));
    is_before = is_before || order <= 0;
    is_behind = is_behind || order >= 0;
  }
  return is_before && is_behind;
}

/// Where two lines cross above the trace.
std::optional<CutPoint> CrossingOf(const CutLine& a, const CutLine& b) {
  if (a.is_level) {
    if (b.is_level) return std::nullopt;
    return CrossingOf(b, a);
  }
  if (!b.is_level && a.c == b.c) return std::nullopt;
  CutPoint point;
  point.z =
      b.is_level ? mpq_class(1 / b.c) : mpq_class((a.b - b.b) / (a.c - b.c));
  if (point.z <= 0) return std::nullopt;
  point.p = a.c * point.z - a.b;
  return point;
}

}  // namespace

void MergeFacets(PlaneCut& cut) {
  JoinSides(cut.facets);
  JoinParts(cut.facets);
}

void DropPoints(PlaneCut& cut) {
  std::vector<int> places(cut.points.size(), kOnTrace);
  std::vector<CutPoint> kept;
  ForEachSegment(cut, [&](CutSegment& segment) {
    for (int& end : segment.ends) {
      if (end == kOnTrace) continue;
      const auto index = static_cast<std::size_t>(end);
      if (places[index] == kOnTrace) {
        places[index] = static_cast<int>(kept.size());
        kept.push_back(cut.points[index]);
      }
      end = places[index];
    }
  });
  cut.points = std::move(kept);
}

void MarkParts(const Scene& scene, PlaneCut& cut) {
  for (CutFacet& facet : cut.facets) {
    facet.is_light = FacetEmits(scene, facet.facet) && MayShowFront(cut, facet);
    facet.is_bound = IsBound(cut, facet);
  }
  for (CutFlat& flat : cut.flats)
    flat.is_light = FacetEmits(scene, flat.facet);
}

void AddCrossings(PlaneCut& cut) {
  std::vector<std::vector<CutSegment>> segments(cut.lines.size());
  ForEachSegment(cut, [&](const CutSegment& segment) {
    segments[static_cast<std::size_t>(segment.line)].push_back(segment);
  });
  for (std::size_t i = 0; i < cut.lines.size(); ++i) {
    for (std::size_t k = i + 1; k < cut.lines.size(); ++k) {
      if (segments[i].empty() || segments[k].empty()) continue;
      std::optional<CutPoint> point = CrossingOf(cut.lines[i], cut.lines[k]);
      const auto holds = [&](const CutSegment& segment) {
        return Holds(cut, segment, *point);
      };
      if (!point || !std::ranges::any_of(segments[i], holds) ||
          !std::ranges::any_of(segments[k], holds)) {
        continue;
      }
      auto same = std::ranges::find_if(cut.points, [&](const CutPoint& p) {
        return p.p == point->p && p.z == point->z;
      });
      if (same == cut.points.end())
        same = cut.points.insert(cut.points.end(), *std::move(point));
      for (const int line : {static_cast<int>(i), static_cast<int>(k)}) {
        if (std::ranges::find(same->lines, line) == same->lines.end())
          same->lines.push_back(line);
      }
    }
  }
}

}  // namespace truelux
