// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/chain/source_chain.h"

#include <algorithm>
#include <array>
#include <utility>

#include "scene/index/plane_region.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

/// Keeps what two regions keep.
template <class First, class Second>
struct BothRegions {
  const First& first;
  const Second& second;

  [[nodiscard]] unsigned Kept(const FourBoxes& boxes) const {
    const unsigned kept = first.Kept(boxes);
    return kept == 0 ? 0 : kept & second.Kept(boxes);
  }
};

}  // namespace

template <class Geometry>
SourceChain<Geometry>::SourceChain(const Scene& scene, const SceneIndex& index,
                                   Geometry& geometry,
                                   ConeMaker<Geometry>& cones,
                                   SourceCones<Geometry>& source,
                                   IgnoredFacetCache& ignored,
                                   ChainCounts& counts)
    : scene_(scene),
      index_(index),
      pieces_(index.pieces()),
      geometry_(geometry),
      cones_(cones),
      source_(source),
      ignored_(ignored),
      counts_(counts),
      is_added_(index.pieces().corners().size()),
      cut_directions_(index.pieces().corners().size()) {}

/// Whether a piece hides what lies behind it: it is no part of the source, is
/// there, and is not seen edge-on.
template <class Geometry>
bool SourceChain<Geometry>::Blocks(PieceId piece) {
  const FacetId facet = pieces_.pieces()[piece].facet;
  return !source_.IsOwn(facet) && !ignored_.IsIgnored(facet) &&
         cones_.ReceiverSide(piece) != Sign::kZero;
}

/// Whether the only two pieces of an edge show r the same side. Where a piece
/// does not block, the edge is added with what lies in the source's plane, or
/// with the borders of what is not there.
template <class Geometry>
bool SourceChain<Geometry>::IsInner(const SilhouetteEdge& edge) {
  return edge.other_piece.valid() && cones_.ReceiverSide(edge.piece) ==
                                         cones_.ReceiverSide(edge.other_piece);
}

/// Of a piece that blocks and has an edge in the source's plane: whether it
/// lies in front of the source.
template <class Geometry>
bool SourceChain<Geometry>::BlocksAtPlane(PieceId piece) {
  const FacetId facet = pieces_.pieces()[piece].facet;
  if (source_.IsCoplanar(facet)) return source_.IsSeenBeforeSource(facet);
  const PieceSides sides = source_.plane().SidesOf(pieces_.CornersOf(piece));
  return sides.any_front ||
         (!sides.any_behind && source_.IsSeenBeforeSource(facet));
}

/// Where an edge, the first of equal ones, meets the source's plane between
/// its ends.
template <class Geometry>
ViewDirectionId SourceChain<Geometry>::CutDirection(EdgeId edge) {
  return cut_directions_.FindOrMake(edge, [&] {
    VertexId in_front = pieces_.corners()[edge];
    VertexId behind = pieces_.corners()[pieces_.NextCorner(edge)];
    if (source_.plane().SideOf(in_front) != Sign::kPositive)
      std::swap(in_front, behind);
    return geometry_.AddDirection(DirectionRecipe::EdgeAtPlane(
        in_front, behind, source_.plane().triangle()));
  });
}

template <class Geometry>
void SourceChain<Geometry>::Append(const ChainEdge& edge, const ImageBox& box) {
  ++counts_.edges;
  if (edge.coefficient > 1) ++counts_.several;
  edges_.push_back(edge);
  boxes_.push_back(box);
}

/// Sums up the coefficient of an edge, the first of equal ones, turned so that
/// it begins at `from`; and chooses its owner and plane. in_plane: it lies in
/// the source's plane. False if the coefficient is zero.
template <class Geometry>
bool SourceChain<Geometry>::Weigh(EdgeId edge, VertexId from, bool in_plane,
                                  ChainEdge& c) {
  // The first edges that run so, as their pieces do seen counter-clockwise, and
  // against it.
  EdgeId along;
  EdgeId against;
  c.coefficient = 0;
  EdgeId e = edge;
  do {
    const PieceId piece = pieces_.PieceOf(e);
    if (Blocks(piece) && (!in_plane || BlocksAtPlane(piece))) {
      const bool forward = cones_.ReceiverSide(piece) == Sign::kPositive;
      const bool is_along = forward == (pieces_.corners()[e] == from);
      c.coefficient += is_along ? 1 : -1;
      EdgeId& first = is_along ? along : against;
      if (!first.valid() || e < first) first = e;
    }
    e = pieces_.NextSameEdge(e);
  } while (e != edge);
  if (c.coefficient == 0) return false;
  const EdgeId own = c.coefficient > 0 ? along : against;
  c.owner = pieces_.PieceOf(own);
  c.edge.plane = cones_.EdgePlane(own);
  return true;
}

/// Adds what of an edge, the first of equal ones, lies in front of the
/// source's plane, if its coefficient is not zero. False if there is nothing.
template <class Geometry>
bool SourceChain<Geometry>::AddEdge(EdgeId edge) {
  if (is_added_.Contains(edge)) return false;
  is_added_.Insert(edge);
  const std::array<VertexId, 2> ends{
      pieces_.corners()[edge], pieces_.corners()[pieces_.NextCorner(edge)]};
  ImageBox box;
  if (!source_.plane().BoxOfVertices(ends, box) || !box.Meets(source_.box())) {
    return false;
  }
  const Sign from_side = source_.plane().SideOf(ends[0]);
  const Sign to_side = source_.plane().SideOf(ends[1]);
  const bool in_plane = from_side == Sign::kZero && to_side == Sign::kZero;
  if (from_side != Sign::kPositive && to_side != Sign::kPositive && !in_plane) {
    return false;
  }
  ChainEdge c;
  if (!Weigh(edge, ends[0], in_plane, c)) return false;
  const auto end = [&](std::size_t k, Sign side) {
    return side == Sign::kNegative ? CutDirection(edge)
                                   : geometry_.VertexDirection(ends[k]);
  };
  c.edge.from = end(0, from_side);
  c.edge.to = end(1, to_side);
  if (c.coefficient < 0) {
    std::swap(c.edge.from, c.edge.to);
    c.coefficient = -c.coefficient;
  }
  if (from_side == Sign::kNegative || to_side == Sign::kNegative) {
    ++counts_.clipped;
    box = source_.plane().BoxOfEdge(c.edge.from, c.edge.to);
    if (!box.Meets(source_.box())) return false;
  }
  if (in_plane) ++counts_.in_plane;
  Append(c, box);
  return true;
}

/// Adds the edge along which the source's plane cuts a piece.
template <class Geometry>
void SourceChain<Geometry>::AddCut(PieceId piece, const CornerSigns& sides) {
  const Piece& p = pieces_.pieces()[piece];
  const auto corners = pieces_.CornersOf(p);
  const auto size = static_cast<std::size_t>(p.corner_count);
  // Around the piece, counter-clockwise as seen from r, it leaves the front
  // where the cut begins and comes back where the cut ends.
  const bool forward = cones_.ReceiverSide(piece) == Sign::kPositive;
  ChainEdge c;
  c.coefficient = 1;
  c.owner = piece;
  for (std::size_t k = 0; k < size; ++k) {
    const std::size_t next = k + 1 < size ? k + 1 : 0;
    const auto set = [&](ViewDirectionId direction, Sign here) {
      const bool leaves = (here == Sign::kPositive) == forward;
      (leaves ? c.edge.from : c.edge.to) = direction;
    };
    if (sides[k] == Sign::kZero) {
      // A corner in the plane: the sides of its neighbours differ.
      set(geometry_.VertexDirection(corners[k]),
          sides[k > 0 ? k - 1 : size - 1]);
    } else if (sides[next] == -sides[k]) {
      const EdgeId edge(p.first_corner.value() + static_cast<int>(k));
      set(CutDirection(pieces_.FirstSameEdge(edge)), sides[k]);
    }
  }
  c.edge.plane = geometry_.AddPlane(
      PlaneRecipe::OfCut(source_.plane().triangle(), p.triangle)
          .NegatedIf(!forward));
  const ImageBox box = source_.plane().BoxOfEdge(c.edge.from, c.edge.to);
  if (!box.Meets(source_.box())) return;
  ++counts_.cuts;
  Append(c, box);
}

template <class Geometry>
void SourceChain<Geometry>::AddPieceAtPlane(PieceId piece) {
  if (!Blocks(piece)) return;
  const Piece& p = pieces_.pieces()[piece];
  const auto corners = pieces_.CornersOf(p);
  if (source_.IsCoplanar(p.facet)) {
    // Known without arithmetic.
    for (const VertexId vertex : corners)
      source_.plane().MarkInPlane(vertex);
  }
  const PieceSides sides = source_.plane().SidesOf(corners);
  if (sides.any_front && sides.any_behind) {
    AddCut(piece, sides.signs);
    return;
  }
  if (sides.any_behind) return;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::size_t next = k + 1 < corners.size() ? k + 1 : 0;
    if (sides.signs[k] != Sign::kZero || sides.signs[next] != Sign::kZero)
      continue;
    const EdgeId edge(p.first_corner.value() + static_cast<int>(k));
    AddEdge(pieces_.FirstSameEdge(edge));
  }
}

/// Adds what the chain has in the source's plane: there an edge may be no
/// inner one although its pieces show r the same side, since only one of them
/// lies in front.
template <class Geometry>
void SourceChain<Geometry>::AddAtSourcePlane(const Box& source_box) {
  const auto vertices = VerticesOf(scene_);
  const TriangleId triangle = source_.plane().triangle();
  const PlaneRegion region(
      geometry_.TriangleNormalFilter(triangle),
      vertices[CornersOf(TrianglesOf(scene_)[triangle])[0]], source_box);
  index_.tree().Visit(region,
                      [this](int piece) { AddPieceAtPlane(PieceId(piece)); });
}

/// Adds the borders of what is not there because of on_face.
template <class Geometry>
void SourceChain<Geometry>::AddIgnoredBorders(const Shaft& shaft) {
  const auto vertices = VerticesOf(scene_);
  for (const FacetId facet :
       FacetsOf(FacesOf(scene_)[IndexOf(ignored_.on_face())])) {
    const TriangleId triangle = FirstTriangleOf(FacetsOf(scene_)[facet]);
    const PlaneRegion plane(
        geometry_.TriangleNormalFilter(triangle),
        vertices[CornersOf(TrianglesOf(scene_)[triangle])[0]], index_.box());
    index_.tree().Visit(BothRegions<Shaft, PlaneRegion>{shaft, plane},
                        [this](int piece) {
                          const Piece& p = pieces_.pieces()[PieceId(piece)];
                          if (!ignored_.IsIgnored(p.facet)) return;
                          for (const EdgeId edge : p.edges()) {
                            if (AddEdge(pieces_.FirstSameEdge(edge)))
                              ++counts_.borders;
                          }
                        });
  }
}

template <class Geometry>
void SourceChain<Geometry>::Link() {
  ends_at_.Clear();
  ends_at_.Cover(geometry_.direction_count());
  links_.resize(edges_.size());
  const auto ends = [this](ViewDirectionId direction) -> Ends& {
    if (!ends_at_.Has(direction)) ends_at_.Set(direction, {});
    return ends_at_[direction];
  };
  for (const ChainEdgeId e : edges_.ids()) {
    Ends& from = ends(edges_[e].edge.from);
    links_[e].next_from = std::exchange(from.first_from, e);
    Ends& to = ends(edges_[e].edge.to);
    links_[e].next_to = std::exchange(to.first_to, e);
  }
}

template <class Geometry>
void SourceChain<Geometry>::Build(
    const Shaft& shaft, const Box& source_box,
    const std::vector<SilhouetteEdge>* candidates) {
  edges_.clear();
  boxes_.clear();
  is_added_.Clear();
  cut_directions_.Clear();
  looked_at_ = 0;
  const auto add = [this](const SilhouetteEdge& edge) {
    ++looked_at_;
    if (!IsInner(edge)) AddEdge(edge.edge);
    return true;
  };
  if (candidates != nullptr) {
    std::ranges::for_each(*candidates, add);
  } else {
    index_.silhouettes().Visit(shaft, Box::Of(geometry_.view().position), add);
  }
  AddAtSourcePlane(source_box);
  if (ignored_.on_face().valid()) AddIgnoredBorders(shaft);
  Link();
}

template class SourceChain<ViewGeometry>;
template class SourceChain<UnfilteredViewGeometry>;
template class SourceChain<DisplacedViewGeometry>;

}  // namespace truelux
