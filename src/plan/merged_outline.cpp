// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/merged_outline.h"

#include <cassert>
#include <cstddef>

namespace truelux {
namespace {

/// Where the sides that are left go from each point.
using Ways = std::map<GridPoint, std::vector<GridPoint>>;

/// Takes sides from a point until none of its own is left, which is where the
/// way comes back to it. A part of the way that comes back to its own start is
/// a ring.
void TakeRings(const GridPoint& start, Ways& ways,
               std::vector<GridRing>& rings) {
  GridRing way = {start};
  std::map<GridPoint, std::size_t> place = {{start, 0}};
  for (;;) {
    std::vector<GridPoint>& next = ways[way.back()];
    if (next.empty()) break;
    const GridPoint to = next.back();
    next.pop_back();
    const auto [met, is_new] = place.try_emplace(to, way.size());
    if (is_new) {
      way.push_back(to);
      continue;
    }
    const auto first = way.begin() + static_cast<std::ptrdiff_t>(met->second);
    rings.emplace_back(first, way.end());
    for (auto p = first + 1; p != way.end(); ++p)
      place.erase(*p);
    way.erase(first + 1, way.end());
  }
  // As many sides come to a point as leave it.
  assert(way.size() == 1);
}

}  // namespace

double SignedArea(const GridRing& ring) {
  double doubled = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const GridPoint& a = ring[i];
    const GridPoint& b = ring[(i + 1) % ring.size()];
    doubled +=
        static_cast<double>(a[0]) * b[1] - static_cast<double>(b[0]) * a[1];
  }
  return doubled / 2;
}

void MergedOutline::Add(const GridRing& ring) {
  const int turn = SignedArea(ring) < 0 ? -1 : 1;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const GridPoint& a = ring[i];
    const GridPoint& b = ring[(i + 1) % ring.size()];
    if (a < b) sides_[{a, b}] += turn;
    if (b < a) sides_[{b, a}] -= turn;
  }
}

std::vector<GridRing> MergedOutline::Rings() const {
  Ways ways;
  for (const auto& [side, count] : sides_) {
    for (int i = 0; i < count; ++i)
      ways[side[0]].push_back(side[1]);
    for (int i = 0; i < -count; ++i)
      ways[side[1]].push_back(side[0]);
  }
  std::vector<GridRing> rings;
  for (const auto& [start, next] : ways) {
    if (!next.empty()) TakeRings(start, ways, rings);
  }
  return rings;
}

}  // namespace truelux
