// SPDX-License-Identifier: GPL-3.0-or-later
// What coincides in one direction, and what a vertex there is called.

#ifndef TRUELUX_VISIBILITY_COINCIDENCE_H_
#define TRUELUX_VISIBILITY_COINCIDENCE_H_

#include <cstddef>
#include <set>

#include "truelux/visibility.h"

#include "exact/primitive.h"
#include "exact/recipe.h"

namespace truelux {

/// The edges and scene vertices that coincide in one direction.
class Coincidence {
 public:
  /// An edge in the plane with this normal; vertex: the scene vertex where it
  /// ends there, none if it passes. Edges in the receiver plane are no planes of
  /// their own.
  void Add(const Vec3<Exact>& plane, VertexId vertex,
           const Vec3<Exact>& receiver_normal) {
    const Vec3<Exact> turn = Cross(plane, receiver_normal);
    if (!Dot(turn, turn).is_zero())
      planes_.insert(WithoutSign(MakePrimitive(plane)));
    if (vertex.valid()) {
      vertices_.insert(vertex);
    } else {
      passed_ = true;
    }
  }

  /// Sets all but the direction.
  void Describe(bool on_horizon, ContourVertex& vertex) const {
    vertex.conjunctive = IsConjunctive(on_horizon);
    vertex.planes = static_cast<int>(planes_.size()) + (on_horizon ? 1 : 0);
    if (!vertices_.empty()) {
      vertex.kind = VertexKind::kIntrinsic;
      vertex.vertex = vertices_.begin()->value();
    } else if (on_horizon) {
      vertex.kind = VertexKind::kHorizon;
    }
  }

 private:
  /// Several of: scene vertex, crossing of edges, horizon point. A scene vertex
  /// explains all edges that end there; two planes make one crossing.
  [[nodiscard]] bool IsConjunctive(bool on_horizon) const {
    const std::size_t edges = planes_.size();
    if (on_horizon) return !vertices_.empty() || edges > 1;
    if (vertices_.size() > 1) return true;
    return vertices_.empty() ? edges > 2 : passed_;
  }

  std::set<PrimitiveVector> planes_;  ///< of edges, without sign
  std::set<VertexId> vertices_;       ///< scene vertices exactly there
  bool passed_ = false;  ///< an edge passes that does not end at such a vertex
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_COINCIDENCE_H_
