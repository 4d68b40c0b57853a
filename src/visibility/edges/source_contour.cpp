// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/edges/source_contour.h"

#include <algorithm>
#include <bit>

namespace truelux {
namespace {

/// With fewer blockers, looking for hidden ones costs more than it saves.
constexpr std::size_t kManyBlockers = 32;

}  // namespace

template <class Geometry>
SourceContour<Geometry>::SourceContour(const ConvexPieces& pieces,
                                       Geometry& geometry,
                                       ConeMaker<Geometry>& cones,
                                       SourceCones<Geometry>& source,
                                       BlockerParts<Geometry>& blockers,
                                       SourceIntervals<Geometry>& intervals)
    : pieces_(pieces),
      geometry_(geometry),
      cones_(cones),
      source_(source),
      blockers_(blockers),
      intervals_(intervals) {}

/// Whether some other blocker has this edge, too, and lies on its other side.
/// Seen from r both run counter-clockwise, so that they lie on opposite sides
/// exactly if they run through the edge in opposite directions.
template <class Geometry>
bool SourceContour<Geometry>::IsInner(EdgeId edge) {
  const auto start = [this](EdgeId e, PieceId piece) {
    // The corner where the edge starts, seen counter-clockwise from r.
    const bool forward = cones_.ReceiverSide(piece) == Sign::kPositive;
    return pieces_.corners()[forward ? e : pieces_.NextCorner(e)];
  };
  VertexId own_start;
  for (EdgeId other = pieces_.NextSameEdge(edge); other != edge;
       other = pieces_.NextSameEdge(other)) {
    const PieceId piece = pieces_.PieceOf(other);
    if (!blockers_.IsBlocker(piece)) continue;
    if (!own_start.valid()) own_start = start(edge, pieces_.PieceOf(edge));
    if (start(other, piece) != own_start) return true;
  }
  return false;
}

template <class Geometry>
void SourceContour<Geometry>::NumberEdges(std::span<Part> parts,
                                          bool are_blockers,
                                          CandidateId& next) {
  for (Part& part : parts) {
    const CandidateId first = next;
    for (std::size_t k = 0; k < part.cone.size; ++k) {
      const EdgeId edge = part.cone.edges[k];
      const bool left_out = are_blockers ? edge != kNoEdge && IsInner(edge)
                                         : source_.IsDiagonal(edge);
      part.candidates[k] = left_out ? CandidateId() : next;
      if (!left_out) ++next;
    }
    part.has_candidates = next != first;
  }
}

/// Gives every edge its id, except those that are left out.
template <class Geometry>
void SourceContour<Geometry>::NumberCandidates() {
  CandidateId next(0);
  NumberEdges(source_.parts(), false, next);
  NumberEdges(blockers_.parts(), true, next);
}

/// Whether a cover of the edge's own plane belongs to a candidate that owns
/// the arcs there instead of candidate `id`.
template <class Geometry>
bool SourceContour<Geometry>::IsOwnedBefore(const Part& part,
                                            const Cover& cover,
                                            CandidateId id) {
  if (cover.side == Sign::kZero) return false;
  const CandidateId owner = part.candidates[cover.coincident];
  return owner.valid() && owner < id;
}

/// Starts the edges of a blocker with what lies inside the source.
template <class Geometry>
void SourceContour<Geometry>::StartBlocker(const Owner& owner) {
  for (std::size_t k = 0; k < owner.part->cone.size; ++k) {
    if (!owner.part->candidates[k].valid()) continue;
    intervals_.Find(edges_[k], boxes_[k]);
    for (const EdgeInterval& interval : intervals_.intervals())
      ranges_[k].Start(interval.begin, interval.end);
  }
}

/// Starts the edges of a part; a bit for every edge that may hold arcs.
template <class Geometry>
std::uint32_t SourceContour<Geometry>::StartEdges(const Owner& owner) {
  const Cone& cone = owner.part->cone;
  for (std::size_t k = 0; k < cone.size; ++k) {
    edges_[k] = {cone.planes[k], cone.From(k), cone.To(k)};
    boxes_[k] = source_.plane().BoxOfEdge(edges_[k].from, edges_[k].to);
    // Along its own edge a source holds the inner side, a blocker hides it.
    needs_positive_[k] = !owner.is_blocker;
    ranges_[k].Clear();
    if (!owner.is_blocker && owner.part->candidates[k].valid())
      ranges_[k].Start(kEdgeFrom, kEdgeTo);
  }
  if (owner.is_blocker) StartBlocker(owner);
  std::uint32_t open = 0;
  for (std::size_t k = 0; k < cone.size; ++k)
    open |= (ranges_[k].empty() ? 0U : 1U) << k;
  return open;
}

/// Takes what blocker p hides from the open edges of a part, and closes the
/// edges that are hidden completely. False if no edge is open any more.
template <class Geometry>
bool SourceContour<Geometry>::Hide(const Owner& owner, std::size_t p,
                                   std::uint32_t& open) {
  // Loops of a fixed length and no branches: nothing here can be predicted.
  const Cone& own = owner.part->cone;
  const std::size_t size = own.size;
  const auto next = [size](std::size_t k) { return k + 1 < size ? k + 1 : 0; };
  const ImageBox& box = blockers_.boxes()[p];
  std::uint32_t near = 0;
  for (std::size_t k = 0; k < size; ++k)
    near |= (boxes_[k].Meets(box) ? 1U : 0U) << k;
  near &= open;
  if (near == 0) return true;
  Part& blocker = blockers_.parts()[p];
  cones_.Complete(blocker.cone);
  for (std::size_t k = 0; k < size; ++k) {
    geometry_.FilterSides(blocker.cone.bundle, own.directions[k], sides_[k]);
  }
  for (std::size_t k = 0; k < size; ++k) {
    const bool outside = (sides_[k].negative & sides_[next(k)].negative) != 0;
    near &= ~((outside ? 1U : 0U) << k);
  }
  for (std::uint32_t bits = near; bits != 0; bits &= bits - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(bits));
    Cover cover;
    if (!CoverOf(geometry_, edges_[k], blocker.cone, sides_[k], sides_[next(k)],
                 cover)) {
      continue;
    }
    const bool hides = cover.side == Sign::kZero ||
                       (cover.side == Sign::kPositive) == needs_positive_[k] ||
                       IsOwnedBefore(blocker, cover, owner.part->candidates[k]);
    if (hides && !ranges_[k].Remove(geometry_, edges_[k], cover)) {
      open &= ~(1U << k);
    }
  }
  return open != 0;
}

template <class Geometry>
void SourceContour<Geometry>::AddArc(const Owner& owner, std::size_t k,
                                     const VisiblePiece& piece) {
  const bool horizon = edges_[k].plane == cones_.horizon();
  const Cone& cone = owner.part->cone;
  arcs_->push_back({edges_[k], piece, horizon ? PieceId() : cone.piece,
                    owner.is_blocker ? kNoEdge : cone.edges[k]});
}

/// Finds the arcs on the edges of a part. Each candidate has exactly one side
/// that can be source. A blocker hides the side on which it lies. An edge of
/// the source bounds the polygon, or is a diagonal and not a candidate; the
/// other cones of a simple polygon, clipped or not, do not reach it. Blockers
/// remove intervals from the side that can be source, and what remains becomes
/// arcs.
template <class Geometry>
void SourceContour<Geometry>::SweepPart(const Owner& owner) {
  if (!owner.part->has_candidates) return;
  cones_.Complete(owner.part->cone);
  std::uint32_t open = StartEdges(owner);
  if (open == 0) return;
  const ImageBox& box = owner.is_blocker ? blockers_.boxes()[owner.index]
                                         : source_.boxes()[owner.index];
  const bool any_left = bins_.ForEach(box, [&](std::size_t p) {
    if (owner.is_blocker && p == owner.index) return true;
    return Hide(owner, p, open);
  });
  if (!any_left) return;
  for (; open != 0; open &= open - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(open));
    ranges_[k].ForEachLeft(
        geometry_, edges_[k],
        [&](const EdgePosition& begin, const EdgePosition& end) {
          AddArc(owner, k, {begin, end, needs_positive_[k]});
        });
  }
}

template <class Geometry>
void SourceContour<Geometry>::AppendArcs(std::vector<ViewArc>& arcs) {
  if (blockers_.hide_all()) return;
  arcs_ = &arcs;
  const bool are_dropped = blockers_.DropHiddenInGrid();
  bins_.Build(blockers_.boxes(), source_.box());
  if (!are_dropped && blockers_.parts().size() >= kManyBlockers)
    blockers_.DropHidden(bins_);
  NumberCandidates();
  intervals_.SetSource();
  for (std::size_t s = 0; s < source_.parts().size(); ++s)
    SweepPart({&source_.parts()[s], s, false});
  for (std::size_t p = 0; p < blockers_.parts().size(); ++p)
    SweepPart({&blockers_.parts()[p], p, true});
}

template class SourceContour<ViewGeometry>;
template class SourceContour<UnfilteredViewGeometry>;
template class SourceContour<DisplacedViewGeometry>;

}  // namespace truelux
