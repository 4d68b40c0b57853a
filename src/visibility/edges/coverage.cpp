// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/edges/coverage.h"

#include <bit>
#include <cstdint>

namespace truelux {

template <class Geometry>
bool CoverOf(Geometry& geometry, const ViewEdge& edge, const Cone& cone,
             BundleSides& from, BundleSides& to, Cover& cover) {
  if ((from.negative & to.negative) != 0) return false;
  geometry.CompleteSides(cone.bundle, edge.from, from);
  geometry.CompleteSides(cone.bundle, edge.to, to);
  const std::uint32_t not_inside =
      geometry.BundleMask(cone.bundle) & ~(from.positive | to.positive);
  if ((not_inside & (from.negative | to.negative)) != 0) return false;
  cover.begin = kEdgeFrom;
  cover.end = kEdgeTo;
  cover.side = Sign::kZero;
  if (not_inside != 0) {
    // The cone's plane is the edge's plane. The next direction of the cone
    // but one lies strictly inside plane k, and so on the cone's side.
    const auto k = static_cast<std::size_t>(std::countr_zero(not_inside));
    const ViewDirectionId inner = cone.directions[(k + 2) % cone.size];
    cover.side = geometry.PlaneSide(edge.plane, inner).sign;
    cover.coincident = k;
  }
  const auto crossing = [&](std::uint32_t bit) {
    const auto k = static_cast<std::size_t>(std::countr_zero(bit));
    return MakeCrossing(cone.planes[k], from.SideOf(k), to.SideOf(k));
  };
  const std::uint32_t leaving = from.positive & to.negative;
  for (std::uint32_t bits = leaving; bits != 0; bits &= bits - 1) {
    const EdgePosition p = crossing(bits);
    if (ComparePositions(geometry, edge, p, cover.end) == Sign::kNegative) {
      cover.end = p;
    }
  }
  const std::uint32_t entering = from.negative & to.positive;
  for (std::uint32_t bits = entering; bits != 0; bits &= bits - 1) {
    const EdgePosition p = crossing(bits);
    if (ComparePositions(geometry, edge, p, cover.begin) == Sign::kPositive) {
      cover.begin = p;
    }
  }
  return leaving == 0 || entering == 0 ||
         ComparePositions(geometry, edge, cover.begin, cover.end) ==
             Sign::kNegative;
}

template <class Geometry>
bool CoverOf(Geometry& geometry, const ViewEdge& edge, const Cone& cone,
             Cover& cover) {
  BundleSides from;
  BundleSides to;
  geometry.FilterSides(cone.bundle, edge.from, from);
  geometry.FilterSides(cone.bundle, edge.to, to);
  return CoverOf(geometry, edge, cone, from, to, cover);
}

template bool CoverOf(ViewGeometry&, const ViewEdge&, const Cone&, Cover&);
template bool CoverOf(UnfilteredViewGeometry&, const ViewEdge&, const Cone&,
                      Cover&);
template bool CoverOf(DisplacedViewGeometry&, const ViewEdge&, const Cone&,
                      Cover&);
template bool CoverOf(ViewGeometry&, const ViewEdge&, const Cone&, BundleSides&,
                      BundleSides&, Cover&);
template bool CoverOf(UnfilteredViewGeometry&, const ViewEdge&, const Cone&,
                      BundleSides&, BundleSides&, Cover&);
template bool CoverOf(DisplacedViewGeometry&, const ViewEdge&, const Cone&,
                      BundleSides&, BundleSides&, Cover&);

}  // namespace truelux
