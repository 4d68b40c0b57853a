// SPDX-License-Identifier: GPL-3.0-or-later
// The plain way to tell the visible pieces of one edge: everything that happens
// along it, sorted.

#ifndef TRUELUX_TESTS_SUPPORT_EDGE_SWEEP_H_
#define TRUELUX_TESTS_SUPPORT_EDGE_SWEEP_H_

#include <algorithm>
#include <cstddef>
#include <vector>

#include "visibility/edges/coverage.h"

namespace truelux::testing {

/// Collects what happens along one edge, then finds its visible pieces. Used
/// again for every edge, without allocation in the steady state.
template <class Geometry>
class EdgeSweep {
 public:
  explicit EdgeSweep(Geometry& geometry) : geometry_(geometry) {}

  void Start(const ViewEdge& edge);

  /// The source is there.
  void AddSource(const Cover& cover) { Add(cover, Role::kSource); }

  /// A blocker hides what is there.
  void AddBlocker(const Cover& cover) { Add(cover, Role::kBlocker); }

  /// A candidate edge in the same plane, with a smaller id than this one,
  /// which owns the arcs there.
  void AddOwner(const Cover& cover) { Add(cover, Role::kOwner); }

  /// The pieces that have exactly one visible side and no other owner, in
  /// order along the edge. Valid until the next Start.
  const std::vector<VisiblePiece>& Finish();

 private:
  enum class Role : signed char { kSource, kBlocker, kOwner };

  /// One end of a cover: counts change by `step` there.
  struct Event {
    EdgePosition position;
    Role role{};
    Sign side{};
    int step = 0;
  };

  void Add(const Cover& cover, Role role);
  void Apply(const Event& event);

  Geometry& geometry_;
  ViewEdge edge_;
  std::vector<Event> events_;
  std::vector<VisiblePiece> pieces_;
  // How many covers hold at the current position: [side N.d < 0, N.d > 0].
  int source_[2] = {0, 0};
  int blocker_[2] = {0, 0};
  int owner_ = 0;
};

template <class Geometry>
void EdgeSweep<Geometry>::Start(const ViewEdge& edge) {
  edge_ = edge;
  events_.clear();
  pieces_.clear();
}

template <class Geometry>
void EdgeSweep<Geometry>::Add(const Cover& cover, Role role) {
  events_.push_back({cover.begin, role, cover.side, 1});
  events_.push_back({cover.end, role, cover.side, -1});
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

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_SUPPORT_EDGE_SWEEP_H_
