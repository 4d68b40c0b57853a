// What cones do along one edge: the interval of the edge inside each cone, on
// which side, and the sweep that tells visible from hidden.

#ifndef TRUELUX_VISIBILITY_COVERAGE_H_
#define TRUELUX_VISIBILITY_COVERAGE_H_

#include <vector>

#include "exact/view_geometry.h"
#include "visibility/cone.h"

namespace truelux {

/// An edge through the view: the arc from one direction to another, in a
/// plane whose normal is a positive multiple of from x to.
struct ViewEdge {
  int plane = -1;
  int from = -1;
  int to = -1;
};

/// A position on a ViewEdge: a crossing strictly between its ends, or an end.
using EdgePosition = Crossing;

/// Stands for the plane of a position that is an end.
inline constexpr int kFromEnd = -2;
inline constexpr int kToEnd = -1;

inline constexpr EdgePosition kEdgeFrom{kFromEnd, Sign::kZero, 0, 0};
inline constexpr EdgePosition kEdgeTo{kToEnd, Sign::kZero, 1, 0};

/// The open interval of an edge inside a cone.
struct Cover {
  EdgePosition begin = kEdgeFrom;
  EdgePosition end = kEdgeTo;
  /// kZero: the cone lies on both sides of the edge. Otherwise one of the
  /// cone's planes is the edge's plane, and the cone lies only on the side
  /// N . d > 0 (kPositive) or N . d < 0 (kNegative).
  Sign side = Sign::kZero;
  int coincident = -1;  ///< if side is not kZero: which edge of the cone

  [[nodiscard]] bool Whole() const {
    return begin.plane == kFromEnd && end.plane == kToEnd;
  }
};

/// Order of two positions on an edge; kNegative: a comes first. Exact.
template <class Geometry>
Sign ComparePositions(Geometry& geometry, const ViewEdge& edge,
                      const EdgePosition& a, const EdgePosition& b) {
  if (a.plane >= 0 && b.plane >= 0) return geometry.EdgeOrder(edge.plane, a, b);
  if (a.plane == b.plane) return Sign::kZero;
  const bool a_first = a.plane == kFromEnd || b.plane == kToEnd;
  return a_first ? Sign::kNegative : Sign::kPositive;
}

/// Finds the part of an edge inside a complete cone; false if it is empty.
/// Exact. A cone that touches the edge only from one side, along one of its
/// own edges, covers that side (method.md, section 4).
template <class Geometry>
bool CoverOf(Geometry& geometry, const ViewEdge& edge, const Cone& cone,
             Cover& cover);

/// The same, given the sides of the edge's ends to the cone's bundle.
template <class Geometry>
bool CoverOf(Geometry& geometry, const ViewEdge& edge, const Cone& cone,
             BundleSides& from, BundleSides& to, Cover& cover);

/// A piece of an edge of which exactly one side is visible.
struct VisiblePiece {
  EdgePosition begin;
  EdgePosition end;
  bool positive = true;  ///< the visible side is N . d > 0
};

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
    Role role;
    Sign side;
    int step;
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

extern template bool CoverOf(ViewGeometry&, const ViewEdge&, const Cone&,
                             Cover&);
extern template bool CoverOf(UnfilteredViewGeometry&, const ViewEdge&,
                             const Cone&, Cover&);
extern template bool CoverOf(ViewGeometry&, const ViewEdge&, const Cone&,
                             BundleSides&, BundleSides&, Cover&);
extern template bool CoverOf(UnfilteredViewGeometry&, const ViewEdge&,
                             const Cone&, BundleSides&, BundleSides&, Cover&);
extern template class EdgeSweep<ViewGeometry>;
extern template class EdgeSweep<UnfilteredViewGeometry>;

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_COVERAGE_H_
