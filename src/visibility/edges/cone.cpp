// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/edges/cone.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>

namespace truelux {
template <class Geometry>
ConeMaker<Geometry>::ConeMaker(Geometry& geometry, const ConvexPieces& pieces)
    : geometry_(geometry),
      pieces_(pieces),
      receiver_sides_(pieces.pieces().size()),
      edge_planes_(pieces.corners().size()) {}

template <class Geometry>
void ConeMaker<Geometry>::SetReceiver(bool whole_sphere) {
  whole_sphere_ = whole_sphere;
  horizon_ = geometry_.AddPlane(PlaneRecipe::OfHorizon());
  horizon_side_.clear();
  receiver_sides_.Clear();
  edge_planes_.Clear();
}

template <class Geometry>
Sign ConeMaker<Geometry>::ReceiverSide(PieceId piece) {
  return receiver_sides_.FindOrMake(piece, [&] {
    return geometry_.ReceiverSide(pieces_.pieces()[piece].triangle);
  });
}

template <class Geometry>
Sign ConeMaker<Geometry>::HorizonSide(VertexId vertex) {
  if (whole_sphere_) return Sign::kPositive;
  const ViewDirectionId direction = geometry_.VertexDirection(vertex);
  if (direction >= horizon_side_.end_id()) {
    horizon_side_.resize(geometry_.direction_count());
  }
  return horizon_side_[direction].Get(
      [&] { return geometry_.PlaneSide(horizon_, direction).sign; });
}

template <class Geometry>
ViewPlaneId ConeMaker<Geometry>::EdgePlane(EdgeId edge) {
  return edge_planes_.FindOrMake(edge, [&] {
    const auto corners = pieces_.corners();
    VertexId from = corners[edge];
    VertexId to = corners[pieces_.NextCorner(edge)];
    if (ReceiverSide(pieces_.PieceOf(edge)) != Sign::kPositive)
      std::swap(from, to);
    return geometry_.AddPlane(PlaneRecipe::OfEdge(from, to));
  });
}

template <class Geometry>
void ConeMaker<Geometry>::MakePlanes(Cone& cone) {
  for (std::size_t k = 0; k < cone.size; ++k) {
    if (!cone.planes[k].valid()) {
      cone.planes[k] = EdgePlane(cone.edges[k]);
    }
  }
  cone.bundle = geometry_.AddBundle(std::span(cone.planes).first(cone.size));
}

template <class Geometry>
Cone ConeMaker<Geometry>::Whole(PieceId piece) {
  const Piece& p = pieces_.pieces()[piece];
  const auto corners = pieces_.CornersOf(p);
  assert(ReceiverSide(piece) != Sign::kZero);
  // h > 0: the normal points away from r, so that the corners already run
  // counter-clockwise seen from r; else they run clockwise.
  const bool forward = ReceiverSide(piece) == Sign::kPositive;
  Cone cone;
  cone.piece = piece;
  cone.size = corners.size();
  for (std::size_t k = 0; k < cone.size; ++k) {
    // Backward the ring is c[n-1], c[n-2], .., c[0], and edge k, from c[n-1-k]
    // to c[n-2-k], is the piece's edge n-2-k.
    const std::size_t at = forward ? k : cone.size - 1 - k;
    const std::size_t edge = forward ? k : (2 * cone.size - 2 - k) % cone.size;
    cone.directions[k] = geometry_.VertexDirection(corners[at]);
    cone.edges[k] = EdgeId(p.first_corner.value() + static_cast<int>(edge));
  }
  return cone;
}

/// The part of a piece's cone where a linear function is >= 0. sides: the
/// function's signs at the corners, at least one positive and one negative.
/// cut: id of the plane where the function is 0, normal to the positive side.
/// crossing(p, q): id of the direction where the edge between corner p
/// (positive) and corner q (negative) meets the cut.
template <class Geometry>
template <class MakeCrossing>
Cone ConeMaker<Geometry>::Clip(PieceId piece, const CornerSigns& sides,
                               ViewPlaneId cut, const MakeCrossing& crossing) {
  assert(std::ranges::count(sides, Sign::kPositive) > 0);
  assert(std::ranges::count(sides, Sign::kNegative) > 0);
  const Cone whole = Whole(piece);
  const bool forward = ReceiverSide(piece) == Sign::kPositive;
  // The piece's corner at position k of the cone.
  const auto corner = [&](std::size_t k) {
    return forward ? k : whole.size - 1 - k;
  };
  Cone part;
  part.piece = piece;
  const auto add = [&part](ViewDirectionId direction, ViewPlaneId plane,
                           EdgeId edge) {
    part.directions[part.size] = direction;
    part.planes[part.size] = plane;
    part.edges[part.size] = edge;
    ++part.size;
  };
  for (std::size_t k = 0; k < whole.size; ++k) {
    const std::size_t next = k + 1 < whole.size ? k + 1 : 0;
    const Sign here = sides[corner(k)];
    const Sign there = sides[corner(next)];
    if (here == Sign::kPositive ||
        (here == Sign::kZero && there != Sign::kNegative)) {
      add(whole.directions[k], ViewPlaneId(), whole.edges[k]);
      if (there == Sign::kNegative) {
        add(crossing(corner(k), corner(next)), cut, kNoEdge);
      }
    } else if (here == Sign::kZero) {
      // The piece goes from front to back in this corner.
      add(whole.directions[k], cut, kNoEdge);
    } else if (there == Sign::kPositive) {
      add(crossing(corner(next), corner(k)), ViewPlaneId(), whole.edges[k]);
    }
  }
  return part;
}

template <class Geometry>
std::optional<Cone> ConeMaker<Geometry>::AboveHorizon(PieceId piece) {
  const auto corners = pieces_.CornersOf(piece);
  CornerSigns sides{};
  bool any_above = false;
  bool any_below = false;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    sides[k] = HorizonSide(corners[k]);
    any_above = any_above || sides[k] == Sign::kPositive;
    any_below = any_below || sides[k] == Sign::kNegative;
  }
  if (!any_above) return std::nullopt;
  if (!any_below) return Whole(piece);
  return Clip(piece, sides, horizon_, [&](std::size_t p, std::size_t q) {
    return geometry_.AddDirection(
        DirectionRecipe::EdgeAtHorizon(corners[p], corners[q]));
  });
}

template <class Geometry>
Cone ConeMaker<Geometry>::InFrontOf(TriangleId source, PieceId piece,
                                    const CornerSigns& sides) {
  assert(ReceiverSide(piece) != Sign::kZero);
  const Piece& p = pieces_.pieces()[piece];
  const auto corners = pieces_.CornersOf(p);
  // c = sign(h_T) (h_T N_S - h_S N_T), method.md eq. (5): c . d > 0 where the
  // ray along d meets T in front of the plane of S.
  const ViewPlaneId cut = geometry_.AddPlane(
      PlaneRecipe::OfCut(source, p.triangle)
          .NegatedIf(ReceiverSide(piece) == Sign::kNegative));
  return Clip(piece, sides, cut, [&](std::size_t i, std::size_t j) {
    return geometry_.AddDirection(
        DirectionRecipe::EdgeAtPlane(corners[i], corners[j], source));
  });
}

template class ConeMaker<ViewGeometry>;
template class ConeMaker<UnfilteredViewGeometry>;
template class ConeMaker<DisplacedViewGeometry>;

}  // namespace truelux
