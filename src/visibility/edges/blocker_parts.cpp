// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/edges/blocker_parts.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>

namespace truelux {

template <class Geometry>
BlockerParts<Geometry>::BlockerParts(const ConvexPieces& pieces,
                                     Geometry& geometry,
                                     ConeMaker<Geometry>& cones,
                                     SourceCones<Geometry>& source,
                                     DirectionSides<Geometry>& sides)
    : pieces_(pieces),
      geometry_(geometry),
      cones_(cones),
      source_(source),
      sides_(sides),
      is_blocker_(pieces.pieces().size()) {}

template <class Geometry>
void BlockerParts<Geometry>::Start() {
  parts_.clear();
  boxes_.clear();
  hide_all_ = false;
  is_blocker_.Clear();
  Cone& first = source_.parts().front().cone;
  cones_.Complete(first);
  sides_.SetBundle(first.bundle);
}

template <class Geometry>
bool BlockerParts<Geometry>::MayBlock(PieceId piece, ImageBox& box) {
  const Piece& p = pieces_.pieces()[piece];
  if (hide_all_ || source_.IsOwn(p.facet)) return false;
  if (source_.IsCoplanar(p.facet) && !source_.IsSeenBeforeSource(p.facet)) {
    return false;
  }
  return source_.plane().BoxOfVertices(pieces_.CornersOf(p), box) &&
         box.Meets(source_.box());
}

/// Whether some plane of the source has the whole cone, whose box is given, on
/// its outer side; of a source of several cones, whether its boxes are apart
/// from the cone's. (Cones that only another plane separates are missed; they
/// cost time, not correctness.)
template <class Geometry>
bool BlockerParts<Geometry>::IsApart(const Cone& cone, const ImageBox& box) {
  if (source_.parts().size() != 1) {
    return std::ranges::none_of(
        source_.boxes(),
        [&box](const ImageBox& source) { return source.Meets(box); });
  }
  assert(sides_.bundle() == source_.parts().front().cone.bundle);
  const std::uint32_t all = geometry_.BundleMask(sides_.bundle());
  std::uint32_t inside = 0;
  for (std::size_t k = 0; k < cone.size; ++k) {
    inside |= sides_.Of(cone.directions[k]).positive;
    if (inside == all) return false;
  }
  return true;
}

template <class Geometry>
bool BlockerParts<Geometry>::HidesAll(Cone& cone, const ImageBox& box) {
  if (!box.Contains(source_.box())) return false;
  cones_.Complete(cone);
  return std::ranges::all_of(source_.parts(), [&](const Part& source) {
    return Contains(geometry_, cone, source.cone);
  });
}

template <class Geometry>
bool BlockerParts<Geometry>::MakePart(PieceId piece, Part& part,
                                      ImageBox& box) {
  const Piece& p = pieces_.pieces()[piece];
  PieceSides sides;
  if (!source_.IsCoplanar(p.facet))
    sides = source_.plane().SidesOf(pieces_.CornersOf(p));
  if (!sides.any_front) {
    // In the source's plane it is wholly in front, or not at all.
    if (sides.any_behind || !source_.IsSeenBeforeSource(p.facet)) return false;
  }
  if (cones_.ReceiverSide(piece) == Sign::kZero) return false;
  if (sides.any_front && sides.any_behind) {
    part.cone =
        cones_.InFrontOf(source_.plane().triangle(), piece, sides.signs);
    box = source_.plane().BoxOf(part.cone);
    return box.Meets(source_.box());
  }
  part.cone = cones_.Whole(piece);
  return true;
}

template <class Geometry>
void BlockerParts<Geometry>::Add(PieceId piece, const ImageBox& box) {
  if (std::ranges::none_of(pieces_.CornersOf(piece), [this](VertexId v) {
        return cones_.HorizonSide(v) == Sign::kPositive;
      })) {
    return;
  }
  Part part;
  ImageBox part_box = box;
  if (!MakePart(piece, part, part_box) || IsApart(part.cone, part_box)) return;
  hide_all_ = HidesAll(part.cone, part_box);
  if (hide_all_) return;
  is_blocker_.Insert(piece);
  parts_.push_back(part);
  boxes_.push_back(part_box);
}

/// Drops the blockers that finder.ForEachAround shows to be hidden. False if none
/// are.
template <class Geometry>
template <class Finder>
bool BlockerParts<Geometry>::Drop(const Finder& finder) {
  std::size_t kept = 0;
  dropped_.assign(parts_.size(), false);
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const ImageBox& box = boxes_[p];
    // What another part hides is itself in the part that hides that one.
    dropped_[p] = !finder.ForEachAround(box, [&](std::size_t other) {
      if (other == p || dropped_[other] || !boxes_[other].Contains(box)) {
        return true;
      }
      cones_.Complete(parts_[other].cone);
      return !Contains(geometry_, parts_[other].cone, parts_[p].cone);
    });
    if (!dropped_[p]) ++kept;
  }
  if (kept == parts_.size()) return false;
  std::size_t next = 0;
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    if (dropped_[p]) continue;
    if (next != p) {
      parts_[next] = parts_[p];
      boxes_[next] = boxes_[p];
    }
    ++next;
  }
  parts_.resize(kept);
  boxes_.resize(kept);
  return true;
}

template <class Geometry>
void BlockerParts<Geometry>::DropHidden(PartBins& bins) {
  if (Drop(bins)) bins.Build(boxes_, source_.box());
}

template <class Geometry>
bool BlockerParts<Geometry>::DropHiddenInGrid() {
  if (!grid_.Build(boxes_, source_.box())) return false;
  Drop(grid_);
  return true;
}

template class BlockerParts<ViewGeometry>;
template class BlockerParts<UnfilteredViewGeometry>;
template class BlockerParts<DisplacedViewGeometry>;

}  // namespace truelux
