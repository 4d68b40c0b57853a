// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/coplanar_overlap.h"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "exact/decide.h"
#include "exact/number.h"
#include "exact/vec3.h"
#include "scene/newell.h"

namespace truelux {
namespace {

using Corners = std::span<const Point3>;

/// Of a convex polygon: of its first corner.
template <class NT>
Vec3<NT> NormalOf(Corners c) {
  return Cross(Displacement<NT>(c[0], c[1]), Displacement<NT>(c[0], c[2]));
}

/// The side of an edge of a polygon on which a point lies, seen along the
/// polygon's normal: kPositive on the polygon's.
template <class NT>
NT SideOfEdge(Corners polygon, std::size_t edge, const Point3& p) {
  const Point3& from = polygon[edge];
  return Dot(Cross(Displacement<NT>(from, polygon[(edge + 1) % polygon.size()]),
                   Displacement<NT>(from, p)),
             NormalOf<NT>(polygon));
}

bool IsSame(const Point3& p, const Point3& q) {
  return p.x == q.x && p.y == q.y && p.z == q.z;
}

/// Whether the line of an edge parts a polygon from another one, seen along
/// its normal. Where ask() of a side is unknown, the answer is no.
template <class Ask>
bool IsPartedByEdge(Corners polygon, Corners other, const Ask& ask) {
  for (std::size_t edge = 0; edge < polygon.size(); ++edge) {
    const bool parts = std::ranges::all_of(other, [&](const Point3& p) {
      // Neighbours in a mesh are parted by an edge that holds these points.
      if (IsSame(p, polygon[edge]) ||
          IsSame(p, polygon[(edge + 1) % polygon.size()]))
        return true;
      const std::optional<Sign> sign = ask(polygon, edge, p);
      return sign && *sign != Sign::kPositive;
    });
    if (parts) return true;
  }
  return false;
}

template <class Ask>
bool AreParted(Corners a, Corners b, const Ask& ask) {
  return IsPartedByEdge(a, b, ask) || IsPartedByEdge(b, a, ask);
}

bool AreCoplanarAlike(Corners a, Corners b) {
  for (const Point3& p : b) {
    const Sign height = Decide(
        [&]<class NT>() { return HeightOver(NormalOf<NT>(a), a[0], p); });
    if (height != Sign::kZero) return false;
  }
  return LookAlike(a, b);
}

}  // namespace

bool LookAlike(Corners a, Corners b) {
  return Decide([&]<class NT>() {
           return Dot(NormalOf<NT>(a), NormalOf<NT>(b));
         }) == Sign::kPositive;
}

/// Two convex polygons in one plane that have no more than a line in common are
/// parted by an edge of one of them.
bool OverlapInPlane(Corners a, Corners b) {
  const auto by_interval = [](Corners t, std::size_t edge, const Point3& p) {
    return TrySign(SideOfEdge<Interval>(t, edge, p));
  };
  // First what is cheap and tells nearly always: not in one plane for certain,
  // or parted along some normal.
  for (const Point3& p : b) {
    const auto height = TrySign(HeightOver(NormalOf<Interval>(a), a[0], p));
    if (height && *height != Sign::kZero) return false;
  }
  if (AreParted(a, b, by_interval) || !AreCoplanarAlike(a, b)) return false;
  return !AreParted(a, b, [](Corners t, std::size_t edge, const Point3& p) {
    return std::optional<Sign>(
        Decide([&]<class NT>() { return SideOfEdge<NT>(t, edge, p); }));
  });
}

}  // namespace truelux
