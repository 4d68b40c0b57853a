#include "visibility/source_contour.h"

#include <algorithm>

namespace truelux {
namespace {

std::size_t Index(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

template <class Geometry>
SourceContour<Geometry>::SourceContour(const ConvexPieces& pieces,
                                       Geometry& geometry,
                                       ConeMaker<Geometry>& cones,
                                       SourceParts<Geometry>& parts)
    : pieces_(pieces),
      geometry_(geometry),
      cones_(cones),
      parts_(parts),
      sweep_(geometry) {}

template <class Geometry>
Part& SourceContour<Geometry>::OwnerOf(const Candidate& candidate) {
  return candidate.is_blocker ? parts_.blockers()[Index(candidate.part)]
                              : parts_.sources()[Index(candidate.part)];
}

/// Whether both sides of a source's edge are source: the pieces on both its
/// sides survived the horizon.
template <class Geometry>
bool SourceContour<Geometry>::IsDiagonal(int edge) const {
  const auto has_edge = [this](int piece) {
    return std::ranges::any_of(parts_.sources(), [piece](const Part& part) {
      return part.cone.piece == piece;
    });
  };
  if (parts_.sources().size() == 1) return false;
  for (int other = pieces_.NextSameEdge(edge); other != edge;
       other = pieces_.NextSameEdge(other)) {
    if (has_edge(pieces_.PieceOf(other))) return true;
  }
  return false;
}

/// Whether some other blocker has this edge, too, and lies on its other side.
/// Seen from r both run counter-clockwise, so that they lie on opposite sides
/// exactly if they run through the edge in opposite directions.
template <class Geometry>
bool SourceContour<Geometry>::IsInner(int edge) {
  const auto start = [this](int e, int piece) {
    // The corner where the edge starts, seen counter-clockwise from r.
    const bool forward = cones_.ReceiverSide(piece) == Sign::kPositive;
    const Piece& p = pieces_.pieces()[Index(piece)];
    const bool last = e == p.first_corner + p.corner_count - 1;
    const int end = last ? p.first_corner : e + 1;
    return pieces_.corners()[Index(forward ? e : end)];
  };
  int own_start = -1;
  for (int other = pieces_.NextSameEdge(edge); other != edge;
       other = pieces_.NextSameEdge(other)) {
    const int piece = pieces_.PieceOf(other);
    if (!parts_.IsBlocker(piece)) continue;
    if (own_start < 0) own_start = start(edge, pieces_.PieceOf(edge));
    if (start(other, piece) != own_start) return true;
  }
  return false;
}

template <class Geometry>
void SourceContour<Geometry>::CollectEdges(std::span<Part> parts,
                                           bool are_blockers) {
  for (std::size_t p = 0; p < parts.size(); ++p) {
    Part& part = parts[p];
    for (std::size_t k = 0; k < part.cone.size; ++k) {
      const int edge = part.cone.edges[k];
      const bool left_out =
          edge != kNoEdge && (are_blockers ? IsInner(edge) : IsDiagonal(edge));
      part.candidates[k] =
          left_out ? Part::kNoCandidate : static_cast<int>(candidates_.size());
      if (left_out) continue;
      candidates_.push_back(
          {static_cast<int>(p), static_cast<int>(k), are_blockers});
    }
  }
}

template <class Geometry>
void SourceContour<Geometry>::CollectCandidates() {
  candidates_.clear();
  CollectEdges(parts_.sources(), false);
  CollectEdges(parts_.blockers(), true);
}

/// Whether a cover of the edge's own plane belongs to a candidate that owns
/// the arcs there instead of candidate `id`.
template <class Geometry>
bool SourceContour<Geometry>::IsOwnedBefore(const Part& part,
                                            const Cover& cover, int id) {
  if (cover.side == Sign::kZero) return false;
  const int owner = part.candidates[Index(cover.coincident)];
  return owner != Part::kNoCandidate && owner < id;
}

/// Adds the source's pieces to the sweep, and notes where and on which sides
/// of the edge there is any source at all. False if there is none, or another
/// candidate owns all arcs.
template <class Geometry>
bool SourceContour<Geometry>::SweepSource(const Candidate& candidate, int id) {
  const bool one_piece = parts_.sources().size() == 1;
  for (std::size_t p = 0; p < parts_.sources().size(); ++p) {
    const Part& part = parts_.sources()[p];
    Cover cover;
    if (!candidate.is_blocker && candidate.part == static_cast<int>(p)) {
      // Along its own edge a part holds the inner side of the whole edge.
      cover.side = Sign::kPositive;
    } else if (!parts_.StrictlyInside(edge_.from) ||
               !parts_.StrictlyInside(edge_.to)) {
      if (!CoverOf(geometry_, edge_, part.cone, cover)) continue;
      if (IsOwnedBefore(part, cover, id)) {
        if (cover.Whole()) return false;
        sweep_.AddOwner(cover);
      }
    }
    needed_.negative = needed_.negative || cover.side != Sign::kPositive;
    needed_.positive = needed_.positive || cover.side != Sign::kNegative;
    if (one_piece) {
      begin_ = cover.begin;
      end_ = cover.end;
      source_side_ = cover.side;
    } else {
      sweep_.AddSource(cover);
    }
  }
  return needed_.negative || needed_.positive;
}

/// Takes what a cover hides out of [begin_, end_] where it reaches one of its
/// ends; otherwise the cover becomes part of the sweep. False if nothing is
/// left.
template <class Geometry>
bool SourceContour<Geometry>::TrimBy(const Cover& cover) {
  const auto before = [this](const EdgePosition& a, const EdgePosition& b) {
    return ComparePositions(geometry_, edge_, a, b) == Sign::kNegative;
  };
  if (!before(begin_, cover.begin)) {
    if (!before(begin_, cover.end)) return true;
    begin_ = cover.end;
    return before(begin_, end_);
  }
  if (!before(cover.end, end_)) {
    if (before(cover.begin, end_)) end_ = cover.begin;
    return true;
  }
  sweep_.AddBlocker(cover);
  return true;
}

/// False if no piece of the edge can be an arc any more.
template <class Geometry>
bool SourceContour<Geometry>::SweepBlocker(Part& part, int id) {
  cones_.Complete(part.cone);
  Cover cover;
  if (!CoverOf(geometry_, edge_, part.cone, cover)) return true;
  const bool owned = IsOwnedBefore(part, cover, id);
  const bool hides_positive = cover.side != Sign::kNegative;
  const bool hides_negative = cover.side != Sign::kPositive;
  if (owned || ((hides_positive || !needed_.positive) &&
                (hides_negative || !needed_.negative))) {
    return TrimBy(cover);
  }
  sweep_.AddBlocker(cover);
  return true;
}

/// False if no piece of the edge can be an arc.
template <class Geometry>
bool SourceContour<Geometry>::SweepParts(const Candidate& candidate, int id) {
  needed_ = {};
  begin_ = {EdgePosition::Kind::kFrom, {}};
  end_ = {EdgePosition::Kind::kTo, {}};
  if (!SweepSource(candidate, id)) return false;
  if (candidate.is_blocker) {
    needed_.positive = false;
    if (!needed_.negative) return false;
  }
  const ImageBox box = parts_.BoxOfEdge(edge_.from, edge_.to);
  return bins_.ForEach(box, [&](std::size_t p) {
    if (candidate.is_blocker && candidate.part == static_cast<int>(p)) {
      return true;
    }
    if (!parts_.blocker_boxes()[p].Meets(box)) return true;
    return SweepBlocker(parts_.blockers()[p], id);
  });
}

template <class Geometry>
void SourceContour<Geometry>::Sweep(int id) {
  const Candidate& candidate = candidates_[Index(id)];
  Part& owner = OwnerOf(candidate);
  const auto k = Index(candidate.edge);
  const int from = owner.cone.From(k);
  const int to = owner.cone.To(k);
  if (!parts_.BoxOfEdge(from, to).Meets(parts_.source_box())) return;
  cones_.Complete(owner.cone);
  edge_ = {owner.cone.planes[k], from, to};
  sweep_.Start(edge_, candidate.is_blocker);
  if (!SweepParts(candidate, id)) return;
  if (parts_.sources().size() == 1) {
    sweep_.AddSource({begin_, end_, source_side_});
  } else {
    sweep_.Trim(begin_, end_);
  }
  const bool horizon = edge_.plane == cones_.horizon();
  for (const VisiblePiece& piece : sweep_.Finish()) {
    arcs_.push_back({edge_, piece, horizon ? -1 : owner.cone.piece,
                     candidate.is_blocker ? kNoEdge : owner.cone.edges[k]});
  }
}

template <class Geometry>
const std::vector<ViewArc>& SourceContour<Geometry>::FindArcs() {
  arcs_.clear();
  if (parts_.hidden()) return arcs_;
  CollectCandidates();
  bins_.Build(parts_.blocker_boxes(), parts_.source_box());
  for (std::size_t id = 0; id < candidates_.size(); ++id) {
    Sweep(static_cast<int>(id));
  }
  return arcs_;
}

template class SourceContour<ViewGeometry>;
template class SourceContour<UnfilteredViewGeometry>;

}  // namespace truelux
