// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/simple_polygon.h"

#include <cassert>
#include <optional>

#include "exact/rounding.h"
#include "exact/sign.h"

namespace truelux {
namespace {

/// Whether b lies strictly between a and c, given that the images of a, b and
/// c are on one line.
bool StrictlyBetween(const ProjectedRing& ring, int a, int b, int c) {
  return ring.Order(a, b) * ring.Order(b, c) == Sign::kPositive;
}

/// Whether the edges a-b and b-c have more than b in common.
bool FoldsBack(const ProjectedRing& ring, int a, int b, int c) {
  return ring.Orientation(a, b, c) == Sign::kZero &&
         !StrictlyBetween(ring, a, b, c);
}

/// Whether the closed segments a-b and c-d meet, given that no edges fold back
/// and a-b and c-d are no neighbours.
///
/// False if all four points are on one line. If the segments overlap there,
/// follow each along the ring until it leaves the line: the straight pieces
/// overlap too, so an end of one lies on the other, and the edge that leaves
/// the line at that end meets an edge of the other piece.
bool SegmentsMeet(const ProjectedRing& ring, int a, int b, int c, int d) {
  if (ring.SurelyApart(a, b, c, d)) return false;
  const Sign side_c = ring.Orientation(a, b, c);
  const Sign side_d = ring.Orientation(a, b, d);
  if (side_c * side_d == Sign::kPositive) return false;
  if (side_c == Sign::kZero && side_d == Sign::kZero) return false;
  return ring.Orientation(c, d, a) * ring.Orientation(c, d, b) !=
         Sign::kPositive;
}

}  // namespace

std::optional<BoundaryContact> FindContact(const ProjectedRing& ring) {
  assert(IsRoundingUpward());
  const int n = ring.size();
  const auto next = [n](int i) { return i + 1 < n ? i + 1 : 0; };
  // Neighbours first: it also rules out edges whose image is a point.
  for (int i = 0; i < n; ++i) {
    if (FoldsBack(ring, i, next(i), next(next(i)))) {
      return BoundaryContact{i, next(i)};
    }
  }
  for (int i = 0; i < n; ++i) {
    for (int j = i + 2; j < n && next(j) != i; ++j) {
      if (SegmentsMeet(ring, i, next(i), j, next(j))) {
        return BoundaryContact{i, j};
      }
    }
  }
  return std::nullopt;
}

}  // namespace truelux
