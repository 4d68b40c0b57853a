#include "visibility/edges/source_parts.h"

#include <algorithm>

namespace truelux {
namespace {

std::size_t Index(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

template <class Geometry>
SourceParts<Geometry>::SourceParts(const Scene& scene,
                                   const ConvexPieces& pieces,
                                   Geometry& geometry,
                                   ConeMaker<Geometry>& cones)
    : scene_(scene),
      pieces_(pieces),
      geometry_(geometry),
      cones_(cones),
      source_of_(pieces.pieces().size()),
      blocker_of_(pieces.pieces().size()) {}

template <class Geometry>
bool SourceParts<Geometry>::SetSource(int facet) {
  facet_ = facet;
  sources_.clear();
  source_boxes_.clear();
  blockers_.clear();
  blocker_boxes_.clear();
  hidden_ = false;
  sides_.clear();
  ++source_generation_;
  ChooseCone(0);
  plane_triangle_ = scene_.facets()[Index(facet)].first_triangle;
  chart_ = ImageChart(geometry_.TriangleNormalFilter(plane_triangle_));
  const int first = pieces_.FirstPieceOf(facet);
  const auto count = static_cast<int>(pieces_.PiecesOf(facet).size());
  for (int piece = first; piece < first + count; ++piece) {
    // Its corners lie in its plane, without arithmetic.
    for (const int vertex : pieces_.CornersOf(pieces_.pieces()[Index(piece)])) {
      EntryOf(geometry_.VertexDirection(vertex)).front =
          static_cast<signed char>(Sign::kZero);
    }
    if (auto cone = cones_.AboveHorizon(piece)) {
      cones_.Complete(*cone);
      sources_.push_back({*cone, {}});
      source_of_[Index(piece)] = source_generation_;
    }
  }
  if (sources_.empty()) return false;
  for (const Part& part : sources_)
    source_boxes_.push_back(BoxOf(part.cone));
  source_box_ = source_boxes_.front();
  for (const ImageBox& box : source_boxes_)
    source_box_.Include(box);
  return true;
}

template <class Geometry>
void SourceParts<Geometry>::FindEntry(int direction) {
  if (Index(direction) >= entries_.size()) {
    entries_.resize(Index(geometry_.direction_count()));
  }
  DirectionEntry& entry = entries_[Index(direction)];
  entry.generation = source_generation_;
  entry.box = chart_.Of(geometry_.DirectionFilter(direction), entry.misses);
  entry.front = kUnknown;
  entry.sides = kNoSides;
  entry.choice = 0;
}

template <class Geometry>
Sign SourceParts<Geometry>::FrontSide(int vertex) {
  DirectionEntry& entry = EntryOf(geometry_.VertexDirection(vertex));
  if (entry.front == kUnknown) {
    entry.front =
        static_cast<signed char>(geometry_.VertexSide(plane_triangle_, vertex));
  }
  return static_cast<Sign>(entry.front);
}

template <class Geometry>
void SourceParts<Geometry>::FindSides(int direction, DirectionEntry& entry) {
  if (entry.sides == kNoSides) {
    entry.sides = static_cast<int>(sides_.size());
    sides_.emplace_back();
  }
  entry.choice = choice_;
  const int bundle = chosen().cone.bundle;
  BundleSides& sides = sides_[Index(entry.sides)];
  geometry_.FilterSides(bundle, direction, sides);
  geometry_.CompleteSides(bundle, direction, sides);
}

template <class Geometry>
ImageBox SourceParts<Geometry>::BoxOf(const Cone& cone) {
  ImageBox box = EntryOf(cone.directions[0]).box;
  for (std::size_t k = 1; k < cone.size; ++k) {
    box.Include(EntryOf(cone.directions[k]).box);
  }
  return box;
}

template <class Geometry>
ImageBox SourceParts<Geometry>::BoxOfEdge(int from, int to) {
  ImageBox box = EntryOf(from).box;
  box.Include(EntryOf(to).box);
  return box;
}

template <class Geometry>
bool SourceParts<Geometry>::IsEarlier(int facet) const {
  const auto facets = scene_.facets();
  return facets[Index(facet)].face < facets[Index(facet_)].face;
}

template <class Geometry>
bool SourceParts<Geometry>::MayBlock(int piece, ImageBox& box) {
  const Piece& p = pieces_.pieces()[Index(piece)];
  if (hidden_ || p.facet == facet_) return false;
  if (IsCoplanar(p.facet) && !IsEarlier(p.facet)) return false;
  bool misses = true;
  const auto corners = pieces_.CornersOf(p);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const DirectionEntry& entry =
        EntryOf(geometry_.VertexDirection(corners[k]));
    misses = misses && entry.misses;
    if (k == 0) {
      box = entry.box;
    } else {
      box.Include(entry.box);
    }
  }
  return !misses && box.Meets(source_box_);
}

/// Whether some plane of the source has the whole cone, whose box is given, on
/// its outer side; of a source of several cones, whether its boxes are apart
/// from the cone's. (Cones that only another plane separates are missed; they
/// cost time, not correctness.)
template <class Geometry>
bool SourceParts<Geometry>::IsApart(const Cone& cone, const ImageBox& box) {
  if (sources_.size() != 1) {
    return std::ranges::none_of(source_boxes_, [&box](const ImageBox& source) {
      return source.Meets(box);
    });
  }
  const std::uint32_t all = geometry_.BundleMask(chosen().cone.bundle);
  std::uint32_t inside = 0;
  for (std::size_t k = 0; k < cone.size; ++k) {
    inside |= SidesOfSource(cone.directions[k]).positive;
    if (inside == all) return false;
  }
  return true;
}

template <class Geometry>
void SourceParts<Geometry>::AddBlocker(int piece, const ImageBox& box) {
  const Piece& p = pieces_.pieces()[Index(piece)];
  const auto corners = pieces_.CornersOf(p);
  if (std::ranges::none_of(corners, [this](int v) {
        return cones_.HorizonSide(v) == Sign::kPositive;
      })) {
    return;
  }
  CornerSigns sides{};
  bool any_front = false;
  bool any_behind = false;
  const bool coplanar = IsCoplanar(p.facet);
  for (std::size_t k = 0; k < corners.size() && !coplanar; ++k) {
    sides[k] = FrontSide(corners[k]);
    any_front = any_front || sides[k] == Sign::kPositive;
    any_behind = any_behind || sides[k] == Sign::kNegative;
  }
  if (!any_front) {
    // In the source's plane it is wholly in front iff its face is earlier.
    if (any_behind || !IsEarlier(p.facet)) return;
  }
  if (cones_.ReceiverSide(piece) == Sign::kZero) return;
  Part part;
  ImageBox part_box = box;
  if (any_front && any_behind) {
    part.cone = cones_.InFrontOf(plane_triangle_, piece, sides);
    part_box = BoxOf(part.cone);
    if (!part_box.Meets(source_box_)) return;
  } else {
    part.cone = cones_.Whole(piece);
  }
  if (IsApart(part.cone, part_box)) return;
  if (part_box.Contains(source_box_)) {
    cones_.Complete(part.cone);
    hidden_ = std::ranges::all_of(sources_, [&](const Part& source) {
      return Contains(geometry_, part.cone, source.cone);
    });
    if (hidden_) return;
  }
  blocker_of_[Index(piece)] = source_generation_;
  blockers_.push_back(part);
  blocker_boxes_.push_back(part_box);
}

template <class Geometry>
void SourceParts<Geometry>::DropHiddenBlockers(PartBins& bins) {
  std::size_t kept = 0;
  dropped_.assign(blockers_.size(), false);
  for (std::size_t p = 0; p < blockers_.size(); ++p) {
    const ImageBox& box = blocker_boxes_[p];
    // What another part hides is itself in the part that hides that one.
    dropped_[p] = !bins.ForEachAround(box, [&](std::size_t other) {
      if (other == p || dropped_[other] ||
          !blocker_boxes_[other].Contains(box)) {
        return true;
      }
      cones_.Complete(blockers_[other].cone);
      return !Contains(geometry_, blockers_[other].cone, blockers_[p].cone);
    });
    if (!dropped_[p]) ++kept;
  }
  if (kept == blockers_.size()) return;
  std::size_t next = 0;
  for (std::size_t p = 0; p < blockers_.size(); ++p) {
    if (dropped_[p]) continue;
    if (next != p) {
      blockers_[next] = blockers_[p];
      blocker_boxes_[next] = blocker_boxes_[p];
    }
    ++next;
  }
  blockers_.resize(kept);
  blocker_boxes_.resize(kept);
  bins.Build(blocker_boxes_, source_box_);
}

template class SourceParts<ViewGeometry>;
template class SourceParts<UnfilteredViewGeometry>;

}  // namespace truelux
