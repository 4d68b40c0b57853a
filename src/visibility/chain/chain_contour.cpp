// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/chain/chain_contour.h"

#include <algorithm>
#include <span>
#include <stdexcept>

namespace truelux {

template <class Geometry>
ChainContour<Geometry>::ChainContour(
    const Scene& scene, const SceneIndex& index, Geometry& geometry,
    ConeMaker<Geometry>& cones, SourceCones<Geometry>& source,
    SourceIntervals<Geometry>& intervals, BlockerParts<Geometry>& blockers,
    IgnoredFacetCache& ignored, bool checks_depths)
    : geometry_(geometry),
      cones_(cones),
      source_(source),
      checks_depths_(checks_depths),
      chain_(scene, index, geometry, cones, source, ignored, counts_),
      depth_(scene, index, geometry, cones, source, blockers, ignored, counts_),
      sweep_(geometry, cones, blockers, chain_, counts_),
      intervals_(intervals) {}

/// Notes a depth of a chain edge that has not been swept.
template <class Geometry>
void ChainContour<Geometry>::Know(ChainEdgeId id, const State& state) {
  State& known = states_[id];
  if (known.is_swept || known.known_at != KnownAt::kNowhere) return;
  known = state;
  known_.push_back(id);
}

template <class Geometry>
void ChainContour<Geometry>::CheckDepth(const ViewEdge& edge,
                                        const EdgePosition& position,
                                        bool on_positive, int depth) {
  if (depth_.At(edge, position, on_positive, *shaft_) != depth)
    throw std::logic_error("a depth is not what the tree says");
}

/// Sweeps the inner side of the source's outline: of the edges of its cones
/// that are no diagonals, one after the other where one begins where the other
/// ends.
template <class Geometry>
void ChainContour<Geometry>::SweepOutline() {
  outline_.clear();
  outline_at_.Clear();
  outline_at_.Cover(geometry_.direction_count());
  const auto parts = source_.parts();
  for (std::size_t s = 0; s < parts.size(); ++s) {
    const Cone& cone = parts[s].cone;
    for (std::size_t k = 0; k < cone.size; ++k) {
      if (source_.IsDiagonal(cone.edges[k])) continue;
      outline_at_.Set(cone.From(k), outline_.size());
      outline_.push_back({s, k});
    }
  }
  for (std::size_t i = 0; i < outline_.size(); ++i) {
    std::size_t next = i;
    while (!outline_[next].is_swept && !depth_.hides_all()) {
      OutlineEdge& edge = outline_[next];
      edge.is_swept = true;
      Cone& cone = parts[edge.part].cone;
      cones_.Complete(cone);
      const ViewDirectionId from = cone.From(edge.index);
      const ViewDirectionId to = cone.To(edge.index);
      const int* const known = corner_depths_.Find(from);
      const std::optional<int> depth = SweepOutlineEdge(
          cone, edge.index,
          known != nullptr ? std::optional(*known) : std::nullopt);
      if (!depth) break;
      corner_depths_.Set(to, *depth);
      const std::size_t* const found = outline_at_.Find(to);
      if (found == nullptr) break;
      next = *found;
    }
  }
}

/// depth: at the edge's begin, if it is known. Returns the depth where the edge
/// ends, if nothing else ends there.
template <class Geometry>
std::optional<int> ChainContour<Geometry>::SweepOutlineEdge(
    const Cone& cone, std::size_t k, std::optional<int> depth) {
  const ViewEdge edge{cone.planes[k], cone.From(k), cone.To(k)};
  sweep_.Start(edge, ChainEdgeId(),
               source_.plane().BoxOfEdge(edge.from, edge.to), kEdgeFrom,
               kEdgeTo);
  if (!depth) {
    depth = depth_.At(edge, kEdgeFrom, true, *shaft_);
    if (depth_.hides_all()) return std::nullopt;
  }
  const bool horizon = edge.plane == cones_.horizon();
  std::optional<EdgePosition> lit;
  const auto add = [&](const EdgePosition& to) {
    if (lit) {
      arcs_->push_back({edge,
                        {*lit, to, true},
                        horizon ? PieceId() : cone.piece,
                        cone.edges[k]});
    }
    lit.reset();
  };
  depth = sweep_.ForEachStretch(
      *depth,
      [&](const EdgePosition& begin, int over, int) {
        if (checks_depths_) CheckDepth(edge, begin, true, over);
        if (over != 0) {
          add(begin);
        } else if (!lit) {
          lit = begin;
        }
      },
      [&](const DepthJump& jump, int least_depth) {
        if (!jump.is_proper) return;
        const KnownAt at = jump.leaves ? KnownAt::kEntry : KnownAt::kExit;
        Know(jump.edge, {false, at, least_depth, edge.plane, {}});
      });
  add(kEdgeTo);
  if (!sweep_.ends_alone()) depth.reset();
  return depth;
}

/// Adds the arcs of what of a stretch lies inside the source.
template <class Geometry>
void ChainContour<Geometry>::AddChainArcs(ChainEdgeId id,
                                          const EdgePosition& begin,
                                          const EdgePosition& end) {
  const ChainEdge& c = chain_.edges()[id];
  const std::span<const EdgeInterval> inside = intervals_.intervals();
  const auto add = [&](const EdgePosition& from, const EdgePosition& to) {
    arcs_->push_back({c.edge, {from, to, false}, c.owner, kNoEdge});
  };
  if (inside.size() == 1) {
    add(begin, end);
    return;
  }
  for (const EdgeInterval& interval : inside) {
    const EdgePosition from =
        sweep_.IsBefore(begin, interval.begin) ? interval.begin : begin;
    const EdgePosition to =
        sweep_.IsBefore(interval.end, end) ? interval.end : end;
    if (sweep_.IsBefore(from, to)) add(from, to);
  }
}

/// The depth where the first interval of an edge begins, from what is known
/// and from what changes along the edge; nothing if nothing is known.
template <class Geometry>
std::optional<int> ChainContour<Geometry>::KnownDepth(const State& state) {
  const std::span<const DepthJump> jumps = sweep_.jumps();
  const std::span<const EdgeInterval> inside = intervals_.intervals();
  const auto changes_until = [&](std::size_t end) {
    int sum = 0;
    for (std::size_t j = 0; j < end; ++j)
      sum += jumps[j].change;
    return sum;
  };
  switch (state.known_at) {
    case KnownAt::kNowhere:
      break;
    case KnownAt::kBegin:
      if (inside.front().begin.plane != kFromEnd) break;
      ++counts_.propagated;
      return state.depth;
    case KnownAt::kEntry:
      if (inside.front().begin.plane != state.plane) break;
      ++counts_.entered;
      return state.depth;
    case KnownAt::kExit:
      if (inside.size() > 1 || inside.front().end.plane != state.plane) {
        break;
      }
      ++counts_.entered;
      return state.depth - changes_until(jumps.size());
    case KnownAt::kBefore:
    case KnownAt::kAfter: {
      const auto found = std::ranges::find(jumps, state.edge, &DepthJump::edge);
      if (found == jumps.end()) break;
      auto end = static_cast<std::size_t>(found - jumps.begin());
      if (state.known_at == KnownAt::kBefore) {
        while (end > 0 && !sweep_.IsBefore(jumps[end - 1].at, found->at))
          --end;
      } else {
        while (end < jumps.size() && !sweep_.IsBefore(found->at, jumps[end].at))
          ++end;
      }
      ++counts_.crossed;
      return state.depth - changes_until(end);
    }
  }
  return std::nullopt;
}

/// Sweeps what of a chain edge lies inside the source.
template <class Geometry>
void ChainContour<Geometry>::SweepChainEdge(ChainEdgeId id) {
  const ChainEdge& c = chain_.edges()[id];
  states_[id].is_swept = true;
  intervals_.Find(c.edge, chain_.boxes()[id.index()]);
  const std::span<const EdgeInterval> inside = intervals_.intervals();
  if (inside.empty()) return;
  const EdgePosition begin = inside.front().begin;
  const EdgePosition end = inside.back().end;
  sweep_.Start(c.edge, id, chain_.boxes()[id.index()], begin, end);
  std::optional<int> known = KnownDepth(states_[id]);
  if (!known) {
    known = depth_.At(c.edge, begin, false, *shaft_);
    if (depth_.hides_all()) return;
  }
  std::optional<EdgePosition> lit;
  const auto add = [&](const EdgePosition& to) {
    if (lit) AddChainArcs(id, *lit, to);
    lit.reset();
  };
  const int depth = sweep_.ForEachStretch(
      *known,
      [&](const EdgePosition& from, int over, int earlier) {
        if (checks_depths_) CheckDepth(c.edge, from, false, over);
        // Over the positive side there is at least the edge's own blocker.
        if (over != 0 || earlier != 0) {
          add(from);
        } else if (!lit) {
          lit = from;
        }
      },
      [&](const DepthJump& jump, int least_depth) {
        if (!jump.is_proper) return;
        const KnownAt at = jump.leaves ? KnownAt::kAfter : KnownAt::kBefore;
        Know(jump.edge, {false, at, least_depth, {}, id});
      });
  add(end);
  if (end.plane == kToEnd && sweep_.ends_alone()) Propagate(id, depth);
}

/// Sorts the spokes counter-clockwise, beginning behind the edge that ends
/// there, whose plane is given. False if two have one direction.
template <class Geometry>
bool ChainContour<Geometry>::SortSpokes(ViewPlaneId plane) {
  if (spokes_.size() < 2) return true;
  bool all_differ = true;
  const auto is_left = [&](ViewPlaneId of, bool is_outgoing,
                           ViewDirectionId direction) {
    const Sign sign = geometry_.PlaneSide(of, direction).sign;
    all_differ = all_differ && sign != Sign::kZero;
    return (sign == Sign::kPositive) == is_outgoing;
  };
  // Counter-clockwise from the edge's begin comes what is on its right first.
  for (Spoke& spoke : spokes_)
    spoke.is_first_half = !is_left(plane, true, spoke.far);
  // By a heap, which ends also where there is no order.
  const auto comes_first = [&](const Spoke& a, const Spoke& b) {
    if (a.is_first_half != b.is_first_half) return a.is_first_half;
    if (a.edge == b.edge) return false;
    return is_left(chain_.edges()[a.edge].edge.plane, a.is_outgoing, b.far);
  };
  std::ranges::make_heap(spokes_, comes_first);
  std::ranges::sort_heap(spokes_, comes_first);
  return all_differ;
}

/// From the depth on the negative side of an edge where it ends to those where
/// other edges begin: around the end it changes from spoke to spoke.
template <class Geometry>
void ChainContour<Geometry>::Propagate(ChainEdgeId id, int depth) {
  const ViewEdge& arriving = chain_.edges()[id].edge;
  spokes_.clear();
  bool any_open = false;
  chain_.ForEachAt(arriving.to, [&](ChainEdgeId next) {
    if (next == id) return;
    const ViewEdge& edge = chain_.edges()[next].edge;
    const bool is_outgoing = edge.from == arriving.to;
    const State& state = states_[next];
    any_open = any_open || (is_outgoing && !state.is_swept &&
                            state.known_at == KnownAt::kNowhere);
    spokes_.push_back({next, is_outgoing ? edge.to : edge.from, is_outgoing});
  });
  if (!any_open || !SortSpokes(arriving.plane)) return;
  for (const Spoke& spoke : spokes_) {
    const int coefficient = chain_.edges()[spoke.edge].coefficient;
    if (spoke.is_outgoing) {
      Know(spoke.edge, {false, KnownAt::kBegin, depth, {}, {}});
      depth += coefficient;
    } else {
      depth -= coefficient;
    }
  }
}

/// Sweeps the edges of which a depth is known, and those of which it gets known
/// by that.
template <class Geometry>
void ChainContour<Geometry>::SweepKnown() {
  while (!known_.empty() && !depth_.hides_all()) {
    const ChainEdgeId id = known_.back();
    known_.pop_back();
    SweepChainEdge(id);
  }
}

template <class Geometry>
void ChainContour<Geometry>::MakeChain(
    const Shaft& shaft, const Box& source_box,
    const std::vector<SilhouetteEdge>* candidates) {
  shaft_ = &shaft;
  chain_.Build(shaft, source_box, candidates);
  ++counts_.sources;
  states_.clear();
  states_.resize(chain_.edges().size());
  sweep_.SetChain(source_.box());
  corner_depths_.Clear();
  corner_depths_.Cover(geometry_.direction_count());
}

template <class Geometry>
void ChainContour<Geometry>::AppendArcs(std::vector<ViewArc>& arcs) {
  const std::size_t first = arcs.size();
  arcs_ = &arcs;
  depth_.Start();
  known_.clear();
  near_.clear();
  sweep_.ForEachNear(source_.box(), [this](ChainEdgeId id) {
    near_.push_back(id);
    states_[id] = {};
  });
  intervals_.SetSource();
  SweepOutline();
  SweepKnown();
  for (const ChainEdgeId id : near_) {
    if (states_[id].is_swept || depth_.hides_all()) continue;
    SweepChainEdge(id);
    SweepKnown();
  }
  if (depth_.hides_all()) arcs.resize(first);
}

template class ChainContour<ViewGeometry>;
template class ChainContour<UnfilteredViewGeometry>;
template class ChainContour<DisplacedViewGeometry>;

}  // namespace truelux
