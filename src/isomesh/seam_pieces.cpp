// SPDX-License-Identifier: GPL-3.0-or-later
#include "isomesh/seam_pieces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "isomesh/near_points.h"

namespace truelux {
namespace {

using Place = std::pair<double, double>;

Place PlaceOf(const PlanPoint& p) {
  return {p.s, p.t};
}

/// How far along the way from a to b a point is, 0 .. 1.
double AlongOf(const PlanPoint& a, const PlanPoint& b, const PlanPoint& p) {
  return Dot(p - a, b - a) / Dot(b - a, b - a);
}

/// How much a kind says: at jumps and outlines a mesh ends.
int RankOf(SideKind kind) {
  switch (kind) {
    case SideKind::kInner:
      return 0;
    case SideKind::kKink:
      return 1;
    case SideKind::kOutline:
      return 2;
    case SideKind::kJump:
      break;
  }
  return 3;
}

}  // namespace

SeamPieces::SeamPieces(std::span<const Seam> seams, double alike)
    : alike_(alike), of_seams_(seams.size()) {
  NearPoints known(alike);
  std::vector<PlanPoint> corners;
  const auto one_of = [&](const PlanPoint& p) {
    if (const PlanPoint* near = known.NearestTo(p)) return *near;
    known.Add(p);
    corners.push_back(p);
    return p;
  };
  std::vector<Seam> joined(seams.begin(), seams.end());
  for (Seam& seam : joined) {
    seam.from = one_of(seam.from);
    seam.to = one_of(seam.to);
  }
  std::ranges::sort(corners, {}, PlaceOf);
  for (std::size_t i = 0; i < joined.size(); ++i)
    AddSeam(static_cast<int>(i), joined[i], corners);
  points_.resize(pieces_.size());
}

void SeamPieces::AddSeam(int index, const Seam& seam,
                         std::span<const PlanPoint> corners) {
  const Place from = PlaceOf(seam.from);
  const Place to = PlaceOf(seam.to);
  if (from == to) return;
  const auto [least, most] = std::minmax(seam.from.s, seam.to.s);
  std::vector<std::pair<double, PlanPoint>> path = {{0, seam.from},
                                                    {1, seam.to}};
  for (auto corner =
           std::ranges::lower_bound(corners, least - alike_, {}, &PlanPoint::s);
       corner != corners.end() && corner->s <= most + alike_; ++corner) {
    if (PlaceOf(*corner) == from || PlaceOf(*corner) == to) continue;
    const PlanPoint way = seam.to - seam.from;
    const double along = AlongOf(seam.from, seam.to, *corner);
    if (along > 0 && along < 1 &&
        LengthOf(*corner - seam.from - along * way) <= alike_)
      path.push_back({along, *corner});
  }
  std::ranges::sort(path, {}, &std::pair<double, PlanPoint>::first);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const PlanPoint& a = path[i - 1].second;
    const PlanPoint& b = path[i].second;
    const auto [entry, is_new] =
        names_.emplace(std::minmax(PlaceOf(a), PlaceOf(b)), pieces_.size());
    if (is_new) pieces_.push_back({a, b, SideKind::kInner, -1});
    SeamPiece& piece = pieces_[entry->second];
    if (RankOf(seam.kind) > RankOf(piece.kind)) {
      piece.kind = seam.kind;
      piece.seam = index;
    }
    of_seams_[static_cast<std::size_t>(index)].push_back(entry->second);
  }
}

PlanPoint SeamPieces::Divide(int seam, const PlanPoint& p) {
  const auto& parts = of_seams_[static_cast<std::size_t>(seam)];
  if (parts.empty()) return p;  // the seam is as short as a rounding
  const auto distance_from = [&](std::size_t i) {
    const SeamPiece& piece = pieces_[i];
    const double along = std::clamp(AlongOf(piece.from, piece.to, p), 0.0, 1.0);
    return LengthOf(p - piece.from - along * (piece.to - piece.from));
  };
  const std::size_t i = *std::ranges::min_element(parts, {}, distance_from);
  const SeamPiece& piece = pieces_[i];
  // Points beside jumps and outlines are the margin away from them.
  const PlanPoint at = piece.kind == SideKind::kKink
                           ? p
                           : piece.from + AlongOf(piece.from, piece.to, p) *
                                              (piece.to - piece.from);
  for (const PlanPoint& other : PathOf(i)) {
    if (AreAlike(other, at)) return other;
  }
  points_[i].push_back(at);
  return at;
}

std::vector<PlanPoint> SeamPieces::PathOf(std::size_t piece) const {
  const PlanPoint from = pieces_[piece].from;
  const PlanPoint to = pieces_[piece].to;
  std::vector<PlanPoint> path = points_[piece];
  std::ranges::sort(path, {},
                    [&](const PlanPoint& p) { return AlongOf(from, to, p); });
  path.insert(path.begin(), from);
  path.push_back(to);
  return path;
}

}  // namespace truelux
