// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/strip_arcs.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/ids.h"
#include "scene/coplanar_order.h"
#include "scene/emitters.h"

namespace truelux {
namespace {

/// Adds a number that is not there yet.
void AddOnce(std::vector<int>& numbers, int number) {
  if (std::ranges::find(numbers, number) == numbers.end())
    numbers.push_back(number);
}

int FaceOfFacet(const Scene& scene, int facet) {
  return scene.facets()[static_cast<std::size_t>(facet)].face;
}

bool FacetEmits(const Scene& scene, int facet) {
  return Emits(
      scene.faces()[static_cast<std::size_t>(FaceOfFacet(scene, facet))]);
}

}  // namespace

StripFinder::StripFinder(const Scene& scene, const PlaneCut& cut)
    : scene_(scene), cut_(cut) {
  for (std::size_t i = 0; i < cut.facets.size(); ++i) {
    const CutFacet& facet = cut.facets[i];
    spans_.push_back({&facet.segment, static_cast<int>(i), -1, facet.is_bound,
                      facet.is_light});
  }
  for (std::size_t i = 0; i < cut.flats.size(); ++i) {
    const CutFlat& flat = cut.flats[i];
    for (const CutSegment& side : flat.sides)
      spans_.push_back({&side, -1, static_cast<int>(i), true, flat.is_light});
  }
  for (std::size_t i = 0; i < cut.points.size(); ++i)
    order_.push_back(static_cast<int>(i));
}

bool StripFinder::IsIn(const CutSegment& segment, const mpq_class& t,
                       const mpq_class& u) const {
  bool is_before = false;
  bool is_behind = false;
  for (const int end : segment.ends) {
    int order = 0;
    if (end == kOnTrace) {
      const CutLine& line = cut_.lines[static_cast<std::size_t>(segment.line)];
      order = cmp(line.c, t);
    } else {
      order =
          cmp(cut_.points[static_cast<std::size_t>(end)].DirectionFrom(t), u);
    }
    is_before = is_before || order <= 0;
    is_behind = is_behind || order >= 0;
  }
  return is_before && is_behind;
}

bool StripFinder::Matters(const mpq_class& t, const mpq_class& u) const {
  const bool is_lit = std::ranges::any_of(spans_, [&](const Span& span) {
    return span.is_light && IsIn(*span.segment, t, u);
  });
  if (!is_lit) return false;
  int line = -1;
  for (const Span& span : spans_) {
    if (!span.is_bound || span.segment->line == line ||
        !IsIn(*span.segment, t, u)) {
      continue;
    }
    if (line >= 0) return true;
    line = span.segment->line;
  }
  return false;
}

void StripFinder::Sort(const mpq_class& t) {
  const std::size_t count = cut_.points.size();
  directions_.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    directions_[i] = cut_.points[i].DirectionFrom(t);
  const auto direction = [this](int point) -> const mpq_class& {
    return directions_[static_cast<std::size_t>(point)];
  };
  // The order at the last place is nearly right.
  for (std::size_t i = 1; i < count; ++i) {
    for (std::size_t k = i;
         k > 0 && direction(order_[k]) < direction(order_[k - 1]); --k) {
      std::swap(order_[k], order_[k - 1]);
    }
  }
  ranks_.assign(count, 0);
  different_.clear();
  for (const int point : order_) {
    if (different_.empty() || different_.back() != direction(point))
      different_.push_back(direction(point));
    ranks_[static_cast<std::size_t>(point)] =
        static_cast<int>(different_.size()) - 1;
  }
}

StripFinder::Cells StripFinder::CellsOf(const CutSegment& segment,
                                        const mpq_class& t) const {
  std::array<int, 2> ends{};
  for (std::size_t k = 0; k < 2; ++k) {
    if (segment.ends[k] != kOnTrace) {
      ends[k] = ranks_[static_cast<std::size_t>(segment.ends[k])];
      continue;
    }
    const CutLine& line = cut_.lines[static_cast<std::size_t>(segment.line)];
    const int order = cmp(line.c, t);
    if (order == 0) return {};
    ends[k] = order > 0 ? static_cast<int>(different_.size()) : -1;
  }
  const auto [least, most] = std::ranges::minmax(ends);
  return {least + 1, most + 1};
}

bool StripFinder::ShowsFront(const CutFacet& facet, const mpq_class& t) const {
  const CutLine& line =
      cut_.lines[static_cast<std::size_t>(facet.segment.line)];
  return facet.turn * (line.is_level ? sgn(line.c) : cmp(line.c, t)) < 0;
}

bool StripFinder::ShowsFront(const Cover& cover, int sense,
                             const mpq_class& t) const {
  if (cover.facet != nullptr) return ShowsFront(*cover.facet, t);
  // Beside P a triangle in P is seen from the side that one is on.
  return sense * cover.front_side > 0;
}

mpq_class StripFinder::MiddleOf(int cell) const {
  const auto next = static_cast<std::size_t>(cell);
  if (next == 0) return different_.front() - 1;
  if (next == different_.size()) return different_.back() + 1;
  return (different_[next - 1] + different_[next]) / 2;
}

StripFinder::Cell StripFinder::CellOf(const std::vector<int>& spans,
                                      const mpq_class& t,
                                      const mpq_class& u) const {
  Cell cell;
  for (const int index : spans) {
    const int line = spans_[static_cast<std::size_t>(index)].segment->line;
    if (std::ranges::find(cell.lines, line, &PlacedLine::line) !=
        cell.lines.end()) {
      continue;
    }
    const CutLine& l = cut_.lines[static_cast<std::size_t>(line)];
    cell.lines.push_back({line, l.is_level ? mpq_class(1 / l.c)
                                           : mpq_class((u + l.b) / (l.c - t))});
  }
  std::ranges::sort(cell.lines, {}, &PlacedLine::z);
  const auto place_of = [&cell](int line) {
    return static_cast<int>(
        std::ranges::find(cell.lines, line, &PlacedLine::line) -
        cell.lines.begin());
  };
  std::vector<std::pair<int, int>> open;  // flat triangles with one side
  for (const int index : spans) {
    const Span& span = spans_[static_cast<std::size_t>(index)];
    const int place = place_of(span.segment->line);
    if (span.facet >= 0) {
      const CutFacet& facet = cut_.facets[static_cast<std::size_t>(span.facet)];
      cell.covers.push_back({&facet, facet.facet, 0, place, place});
      continue;
    }
    const auto other =
        std::ranges::find(open, span.flat, &std::pair<int, int>::first);
    if (other == open.end()) {
      open.emplace_back(span.flat, place);
      continue;
    }
    const CutFlat& flat = cut_.flats[static_cast<std::size_t>(span.flat)];
    cell.covers.push_back({nullptr, flat.facet, flat.front_side,
                           std::max(place, other->second),
                           std::min(place, other->second)});
  }
  return cell;
}

bool StripFinder::IsNearer(const Cover& a, const Cover& b, int strip, int sense,
                           const Cell& cell, const mpq_class& t) const {
  // Strip k lies between the lines k - 1 and k.
  const auto depth = [strip](const Cover& cover) {
    return cover.facet == nullptr ? 2 * strip - 1 : 2 * cover.near;
  };
  if (depth(a) != depth(b)) return depth(a) > depth(b);
  if (a.facet != nullptr && b.facet != nullptr &&
      a.facet->tilt != b.facet->tilt) {
    const int line = cell.lines[static_cast<std::size_t>(a.near)].line;
    const mpq_class height =
        cut_.lines[static_cast<std::size_t>(line)].HeightAt(t);
    const int below = strip <= a.near ? 1 : -1;
    return sense * below * sgn(height) * cmp(a.facet->tilt, b.facet->tilt) > 0;
  }
  const auto seen = [&](const Cover& cover) {
    return SeenFacet{FacetId(cover.scene_facet), ShowsFront(cover, sense, t)};
  };
  return IsSeenBefore(scene_, seen(a), seen(b));
}

StripFinder::Seen StripFinder::SeenIn(const Cell& cell, int strip, int sense,
                                      const mpq_class& t) const {
  const auto is_there = [strip, sense](const Cover& cover) {
    if (cover.facet == nullptr) return cover.far < strip && strip <= cover.near;
    const int below = strip <= cover.near ? 1 : -1;
    return cover.facet->side == 0 || cover.facet->side * sense * below > 0;
  };
  const Cover* nearest = nullptr;
  for (const Cover& cover : cell.covers) {
    if (is_there(cover) && (nearest == nullptr ||
                            IsNearer(cover, *nearest, strip, sense, cell, t))) {
      nearest = &cover;
    }
  }
  if (nearest == nullptr || !FacetEmits(scene_, nearest->scene_facet) ||
      !ShowsFront(*nearest, sense, t)) {
    return {nearest, -1};
  }
  return {nearest, FaceOfFacet(scene_, nearest->scene_facet)};
}

void StripFinder::AddStep(const Seen& below, const Seen& above, int place,
                          Steps& steps) const {
  if (above.face == below.face) return;
  const auto k = static_cast<std::size_t>(place);
  const auto exitance = [this](const Seen& seen, std::size_t channel) {
    return seen.face < 0 ? 0
                         : scene_.faces()[static_cast<std::size_t>(seen.face)]
                               .emission[channel];
  };
  for (std::size_t channel = 0; channel < 3; ++channel) {
    mpq_class& jump = steps.steps[k].jump[channel];
    jump += exitance(above, channel);
    jump -= exitance(below, channel);
  }
  for (const Cover* cover : {above.cover, below.cover}) {
    if (cover != nullptr && cover->facet == nullptr &&
        (cover->near == place || cover->far == place)) {
      AddOnce(steps.faces[k], FaceOfFacet(scene_, cover->scene_facet));
    }
  }
}

std::optional<StripArc> StripFinder::ArcOf(const Cell& cell,
                                           const mpq_class& t) const {
  Steps all;
  for (const PlacedLine& line : cell.lines)
    all.steps.push_back({line.line, {}});
  all.faces.resize(cell.lines.size());
  const int count = static_cast<int>(cell.lines.size());
  for (const int sense : {1, -1}) {
    Seen below = SeenIn(cell, 0, sense, t);
    for (int place = 0; place < count; ++place) {
      const Seen above = SeenIn(cell, place + 1, sense, t);
      AddStep(below, above, place, all);
      below = above;
    }
  }
  if (!DropChannelsWithoutKink(all.steps)) return std::nullopt;
  StripArc arc;
  for (std::size_t k = 0; k < all.steps.size(); ++k) {
    if (std::ranges::all_of(all.steps[k].jump,
                            [](const mpq_class& j) { return j == 0; })) {
      continue;
    }
    arc.steps.push_back(std::move(all.steps[k]));
    for (const int face : all.faces[k])
      AddOnce(arc.faces, face);
  }
  return arc;
}

bool StripFinder::DropChannelsWithoutKink(std::vector<StripStep>& steps) const {
  // The sum of jump (u + b) / (c - t) over lines vanishes for all u and t if it
  // does over the lines of each c.
  bool has_kink = false;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const auto vanishes = [&](const StripStep& step) {
      const CutLine& line = cut_.lines[static_cast<std::size_t>(step.line)];
      mpq_class sum;
      mpq_class moment;
      for (const StripStep& other : steps) {
        const CutLine& l = cut_.lines[static_cast<std::size_t>(other.line)];
        if (l.is_level != line.is_level) continue;
        if (l.is_level) {
          sum += other.jump[channel] / l.c;
        } else if (l.c == line.c) {
          sum += other.jump[channel];
          moment += other.jump[channel] * l.b;
        }
      }
      return sum == 0 && moment == 0;
    };
    if (std::ranges::all_of(steps, vanishes)) {
      for (StripStep& step : steps)
        step.jump[channel] = 0;
    } else {
      has_kink = true;
    }
  }
  return has_kink;
}

void StripFinder::AddEdges(StripArc& arc, int cell, const mpq_class& t) const {
  for (std::size_t i = 0; i < cut_.edges.size(); ++i) {
    const CutSegment& segment = cut_.edges[i].segment;
    if (std::ranges::find(arc.steps, segment.line, &StripStep::line) ==
        arc.steps.end()) {
      continue;
    }
    const Cells cells = CellsOf(segment, t);
    if (cells.first <= cell && cell < cells.last)
      arc.edges.push_back(static_cast<int>(i));
  }
}

std::vector<StripArc> StripFinder::ArcsAt(const mpq_class& t) {
  Sort(t);

  struct Content {
    std::vector<int> spans;
    bool is_lit = false;
    int line = -1;  ///< at which strips may differ
    bool has_two_lines = false;
  };

  if (different_.empty()) return {};
  std::vector<Content> contents(different_.size() + 1);
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    const Span& span = spans_[i];
    const Cells cells = CellsOf(*span.segment, t);
    const bool is_light =
        span.is_light &&
        (span.facet < 0 ||
         ShowsFront(cut_.facets[static_cast<std::size_t>(span.facet)], t));
    for (int k = cells.first; k < cells.last; ++k) {
      Content& content = contents[static_cast<std::size_t>(k)];
      content.spans.push_back(static_cast<int>(i));
      content.is_lit = content.is_lit || is_light;
      if (!span.is_bound) continue;
      content.has_two_lines =
          content.has_two_lines ||
          (content.line >= 0 && content.line != span.segment->line);
      content.line = span.segment->line;
    }
  }
  std::vector<StripArc> arcs;
  for (std::size_t k = 0; k < contents.size(); ++k) {
    if (!contents[k].is_lit || !contents[k].has_two_lines) continue;
    const int cell = static_cast<int>(k);
    std::optional<StripArc> arc =
        ArcOf(CellOf(contents[k].spans, t, MiddleOf(cell)), t);
    if (!arc) continue;
    if (k > 0) arc->from = different_[k - 1];
    if (k < different_.size()) arc->to = different_[k];
    AddEdges(*arc, cell, t);
    arcs.push_back(*std::move(arc));
  }
  return arcs;
}

}  // namespace truelux
