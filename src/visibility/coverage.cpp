#include "visibility/coverage.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace truelux {

template <class Geometry>
bool CoverOf(Geometry& geometry, const ViewEdge& edge, const Cone& cone,
             Cover& cover) {
  BundleSides from;
  BundleSides to;
  geometry.FilterSides(cone.bundle, edge.from, from);
  geometry.FilterSides(cone.bundle, edge.to, to);
  if ((from.negative & to.negative) != 0) return false;
  geometry.CompleteSides(cone.bundle, edge.from, from);
  geometry.CompleteSides(cone.bundle, edge.to, to);
  const std::uint32_t not_inside =
      geometry.BundleMask(cone.bundle) & ~(from.positive | to.positive);
  if ((not_inside & (from.negative | to.negative)) != 0) return false;
  cover = Cover{};
  if (not_inside != 0) {
    // The cone's plane is the edge's plane. The next direction of the cone
    // but one lies strictly inside plane k, and so on the cone's side.
    const auto k = static_cast<std::size_t>(std::countr_zero(not_inside));
    const int inner = cone.directions[(k + 2) % cone.size];
    cover.side = geometry.PlaneSide(edge.plane, inner).sign;
    cover.coincident = static_cast<int>(k);
  }
  const std::uint32_t leaving = from.positive & to.negative;
  const std::uint32_t entering = from.negative & to.positive;
  for (std::uint32_t bits = leaving | entering; bits != 0; bits &= bits - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(bits));
    const EdgePosition p{
        EdgePosition::Kind::kCrossing,
        MakeCrossing(cone.planes[k], from.SideOf(k), to.SideOf(k))};
    if ((leaving >> k & 1) != 0) {
      if (ComparePositions(geometry, edge, p, cover.end) == Sign::kNegative) {
        cover.end = p;
      }
    } else if (ComparePositions(geometry, edge, p, cover.begin) ==
               Sign::kPositive) {
      cover.begin = p;
    }
  }
  return leaving == 0 || entering == 0 ||
         ComparePositions(geometry, edge, cover.begin, cover.end) ==
             Sign::kNegative;
}

template <class Geometry>
void EdgeSweep<Geometry>::Start(const ViewEdge& edge, bool positive_hidden) {
  edge_ = edge;
  events_.clear();
  pieces_.clear();
  blocker_[0] = 0;
  blocker_[1] = positive_hidden ? 1 : 0;
}

template <class Geometry>
void EdgeSweep<Geometry>::Add(const Cover& cover, Role role) {
  events_.push_back({cover.begin, role, cover.side, 1});
  events_.push_back({cover.end, role, cover.side, -1});
}

template <class Geometry>
void EdgeSweep<Geometry>::Trim(const EdgePosition& begin,
                               const EdgePosition& end) {
  // As if some other candidate owned those parts.
  Cover cover;
  if (begin.kind != EdgePosition::Kind::kFrom) {
    cover.end = begin;
    AddOwner(cover);
  }
  if (end.kind != EdgePosition::Kind::kTo) {
    cover.begin = end;
    cover.end = {EdgePosition::Kind::kTo, {}};
    AddOwner(cover);
  }
}

template <class Geometry>
void EdgeSweep<Geometry>::Apply(const Event& event) {
  if (event.role == Role::kOwner) {
    owner_ += event.step;
    return;
  }
  int* count = event.role == Role::kSource ? source_ : blocker_;
  if (event.side != Sign::kPositive) count[0] += event.step;
  if (event.side != Sign::kNegative) count[1] += event.step;
}

template <class Geometry>
const std::vector<VisiblePiece>& EdgeSweep<Geometry>::Finish() {
  std::ranges::sort(events_, [this](const Event& a, const Event& b) {
    return ComparePositions(geometry_, edge_, a.position, b.position) ==
           Sign::kNegative;
  });
  const auto visible = [this](int side) {
    return source_[side] > 0 && blocker_[side] == 0;
  };
  for (std::size_t i = 0; i + 1 < events_.size(); ++i) {
    Apply(events_[i]);
    // A side is judged between two events at different positions only; where
    // it cannot yield an arc, the positions need not be told apart.
    if (owner_ > 0 || visible(0) == visible(1)) continue;
    const EdgePosition& begin = events_[i].position;
    const EdgePosition& end = events_[i + 1].position;
    if (ComparePositions(geometry_, edge_, begin, end) == Sign::kZero) continue;
    pieces_.push_back({begin, end, visible(1)});
  }
  if (!events_.empty()) Apply(events_.back());
  return pieces_;
}

template bool CoverOf(ViewGeometry&, const ViewEdge&, const Cone&, Cover&);
template bool CoverOf(UnfilteredViewGeometry&, const ViewEdge&, const Cone&,
                      Cover&);
template class EdgeSweep<ViewGeometry>;
template class EdgeSweep<UnfilteredViewGeometry>;

}  // namespace truelux
