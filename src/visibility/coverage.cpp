#include "visibility/coverage.h"

#include <algorithm>

namespace truelux {

Sign ComparePositions(ViewGeometry& geometry, const ViewEdge& edge,
                      const EdgePosition& a, const EdgePosition& b) {
  using Kind = EdgePosition::Kind;
  if (a.kind == Kind::kCrossing && b.kind == Kind::kCrossing) {
    return geometry.EdgeOrder(edge.plane, a.crossing, b.crossing);
  }
  if (a.kind == b.kind) return Sign::kZero;
  return a.kind < b.kind ? Sign::kNegative : Sign::kPositive;
}

std::optional<Cover> CoverOf(ViewGeometry& geometry, const ViewEdge& edge,
                             const Cone& cone) {
  Cover cover;
  for (std::size_t k = 0; k < cone.size; ++k) {
    const int plane = cone.planes[k];
    const Side from = geometry.PlaneSide(plane, edge.from);
    const Side to = geometry.PlaneSide(plane, edge.to);
    if (from.sign != Sign::kPositive && to.sign != Sign::kPositive) {
      if (from.sign != Sign::kZero || to.sign != Sign::kZero) {
        return std::nullopt;
      }
      // The cone's plane is the edge's plane. The next direction of the cone
      // but one lies strictly inside plane k, and so on the cone's side.
      const int inner = cone.directions[(k + 2) % cone.size];
      cover.side = geometry.PlaneSide(edge.plane, inner).sign;
      cover.coincident = static_cast<int>(k);
    } else if (from.sign == Sign::kPositive && to.sign == Sign::kNegative) {
      const EdgePosition p{EdgePosition::Kind::kCrossing, {plane, from, to}};
      if (ComparePositions(geometry, edge, p, cover.end) == Sign::kNegative) {
        cover.end = p;
      }
    } else if (from.sign == Sign::kNegative && to.sign == Sign::kPositive) {
      const EdgePosition p{EdgePosition::Kind::kCrossing, {plane, from, to}};
      if (ComparePositions(geometry, edge, p, cover.begin) == Sign::kPositive) {
        cover.begin = p;
      }
    }
  }
  if (ComparePositions(geometry, edge, cover.begin, cover.end) !=
      Sign::kNegative) {
    return std::nullopt;
  }
  return cover;
}

void EdgeSweep::Start(const ViewEdge& edge) {
  edge_ = edge;
  events_.clear();
  pieces_.clear();
}

void EdgeSweep::Add(const Cover& cover, Role role) {
  events_.push_back({cover.begin, role, cover.side, 1});
  events_.push_back({cover.end, role, cover.side, -1});
}

void EdgeSweep::Apply(const Event& event) {
  if (event.role == Role::kOwner) {
    owner_ += event.step;
    return;
  }
  int* count = event.role == Role::kSource ? source_ : blocker_;
  if (event.side != Sign::kPositive) count[0] += event.step;
  if (event.side != Sign::kNegative) count[1] += event.step;
}

const std::vector<VisiblePiece>& EdgeSweep::Finish() {
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

}  // namespace truelux
