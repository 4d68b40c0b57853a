// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/edges/source_outline.h"

#include <algorithm>
#include <cstddef>

namespace truelux {

template <class Geometry>
void SourceOutline<Geometry>::SetSource() {
  edges_.clear();
  boxes_.clear();
  for (const Part& part : source_.parts()) {
    const Cone& cone = part.cone;
    for (std::size_t k = 0; k < cone.size; ++k) {
      const EdgeId edge = cone.edges[k];
      if (source_.IsDiagonal(edge)) continue;
      const ViewPlaneId plane =
          edge == kNoEdge ? cone.planes[k] : cones_.EdgePlane(edge);
      edges_.push_back({plane, cone.From(k), cone.To(k)});
      boxes_.push_back(
          source_.plane().BoxOfEdge(edges_.back().from, edges_.back().to));
    }
  }
  bins_.Build(boxes_, source_.box());
  cone_bins_.Build(source_.boxes(), source_.box());
  places_.Clear();
}

/// Asks the cones whose boxes hold the direction. It may also lie on a diagonal.
template <class Geometry>
typename SourceOutline<Geometry>::Place SourceOutline<Geometry>::FindPlace(
    ViewDirectionId direction) {
  const ImageBox box = source_.plane().BoxOfEdge(direction, direction);
  Place place = Place::kOutside;
  ForEachConeNear(box, [&](Cone& cone) {
    cones_.Complete(cone);
    BundleSides sides;
    geometry_.FilterSides(cone.bundle, direction, sides);
    if (sides.negative != 0) return true;
    const bool is_inside = sides.positive == geometry_.BundleMask(cone.bundle);
    place = is_inside ? Place::kInside : Place::kUnknown;
    return false;
  });
  return place;
}

template <class Geometry>
typename SourceOutline<Geometry>::Place SourceOutline<Geometry>::PlaceOf(
    ViewDirectionId direction) {
  places_.Cover(geometry_.direction_count());
  return places_.FindOrMake(direction, [&] { return FindPlace(direction); });
}

/// An edge e from a to b with the plane N and one f from p to q with the plane
/// M, which has the source on its positive side, cross in a direction or in its
/// opposite if a and b lie on two sides of M, and p and q on two sides of N. It is
/// the direction itself if e goes to the positive side of the one exactly if f
/// leaves that of the other.
template <class Geometry>
bool SourceOutline<Geometry>::FindPassages(const ViewEdge& edge,
                                           const ImageBox& box) {
  passages_.clear();
  return bins_.ForEach(box, [&](std::size_t i) {
    if (!boxes_[i].Meets(box)) return true;
    const ViewEdge& f = edges_[i];
    const Sign p = geometry_.PlaneSide(edge.plane, f.from).sign;
    const Sign q = geometry_.PlaneSide(edge.plane, f.to).sign;
    if (p == q && p != Sign::kZero) return true;
    const Side a = geometry_.PlaneSide(f.plane, edge.from);
    const Side b = geometry_.PlaneSide(f.plane, edge.to);
    if (a.sign == b.sign && a.sign != Sign::kZero) return true;
    if (p == Sign::kZero || q == Sign::kZero || a.sign == Sign::kZero ||
        b.sign == Sign::kZero) {
      return false;
    }
    const bool enters = b.sign == Sign::kPositive;
    if (enters == (p == Sign::kPositive))
      passages_.push_back({MakeCrossing(f.plane, a, b), enters});
    return true;
  });
}

template <class Geometry>
bool SourceOutline<Geometry>::Clip(const ViewEdge& edge, const ImageBox& box,
                                   std::vector<EdgeInterval>& intervals) {
  if (!FindPassages(edge, box)) return false;
  if (passages_.empty()) {
    const Place place = PlaceOf(edge.from);
    if (place == Place::kInside) intervals.push_back({kEdgeFrom, kEdgeTo});
    return place != Place::kUnknown;
  }
  const auto order = [&](const Passage& a, const Passage& b) {
    return ComparePositions(geometry_, edge, a.at, b.at);
  };
  if (passages_.size() > 1) {
    std::ranges::sort(passages_, [&](const Passage& a, const Passage& b) {
      return order(a, b) == Sign::kNegative;
    });
  }
  EdgePosition begin = kEdgeFrom;
  for (std::size_t i = 0; i < passages_.size(); ++i) {
    // Where a boundary is doubled, source touches source.
    const bool is_alone =
        i == 0 || (order(passages_[i - 1], passages_[i]) == Sign::kNegative &&
                   passages_[i - 1].enters != passages_[i].enters);
    if (!is_alone) return false;
    if (passages_[i].enters) {
      begin = passages_[i].at;
    } else {
      intervals.push_back({begin, passages_[i].at});
    }
  }
  if (passages_.back().enters) intervals.push_back({begin, kEdgeTo});
  return true;
}

template class SourceOutline<ViewGeometry>;
template class SourceOutline<UnfilteredViewGeometry>;
template class SourceOutline<DisplacedViewGeometry>;

}  // namespace truelux
