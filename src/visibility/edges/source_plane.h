// SPDX-License-Identifier: GPL-3.0-or-later
// The plane of one source: where directions from r meet it, and on which side
// of it vertices are.

#ifndef TRUELUX_VISIBILITY_EDGES_SOURCE_PLANE_H_
#define TRUELUX_VISIBILITY_EDGES_SOURCE_PLANE_H_

#include <cstddef>
#include <span>

#include "base/stamped_table.h"
#include "exact/cached_sign.h"
#include "exact/view_geometry.h"
#include "visibility/edges/cone.h"
#include "visibility/edges/image_box.h"

namespace truelux {

/// On which sides of a plane the corners of a piece lie.
struct PieceSides {
  CornerSigns signs{};      ///< in the piece's order
  bool any_front = false;   ///< some corner is strictly in front
  bool any_behind = false;  ///< some corner is strictly behind
};

/// Answers about one plane after the other; each direction and each vertex is
/// looked at once per plane. Answers are values: later questions move nothing.
template <class Geometry>
class SourcePlane {
 public:
  /// The geometry must outlive the object.
  explicit SourcePlane(Geometry& geometry) : geometry_(geometry) {}

  /// Starts with the plane of a triangle, which r is in front of.
  void Start(TriangleId triangle);

  /// The triangle that carries the plane.
  [[nodiscard]] TriangleId triangle() const { return triangle_; }

  /// Makes `box` contain the images of some vertices, at least one, and so of
  /// their hull. False if certainly none of the directions to them ever meets
  /// the plane.
  bool BoxOfVertices(std::span<const VertexId> vertices, ImageBox& box);

  /// A box that contains the image of a cone.
  ImageBox BoxOf(const Cone& cone);

  /// A box that contains the image of an edge between two directions.
  ImageBox BoxOfEdge(ViewDirectionId from, ViewDirectionId to);

  /// Notes that a vertex is known, without arithmetic, to lie in the plane.
  void MarkInPlane(VertexId vertex) {
    EntryOf(geometry_.VertexDirection(vertex)).side = CachedSign(Sign::kZero);
  }

  /// Sign of VertexSide to the plane, asked once.
  Sign SideOf(VertexId vertex) {
    return EntryOf(geometry_.VertexDirection(vertex)).side.Get([&] {
      return geometry_.VertexSide(triangle_, vertex);
    });
  }

  /// The same of the corners of a piece.
  PieceSides SidesOf(std::span<const VertexId> corners) {
    PieceSides sides;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Sign sign = SideOf(corners[k]);
      sides.signs[k] = sign;
      sides.any_front = sides.any_front || sign == Sign::kPositive;
      sides.any_behind = sides.any_behind || sign == Sign::kNegative;
    }
    return sides;
  }

 private:
  /// What a direction is to the plane.
  struct Entry {
    ImageBox box;
    bool misses = false;  ///< certainly never meets the plane
    CachedSign side;      ///< of VertexSide, for a vertex
  };

  /// Valid until EntryOf another direction: stays inside this class.
  Entry& EntryOf(ViewDirectionId direction) {
    Entry* const entry = entries_.Find(direction);
    return entry != nullptr ? *entry : MakeEntry(direction);
  }

  Entry& MakeEntry(ViewDirectionId direction);

  Geometry& geometry_;
  TriangleId triangle_;
  ImageChart chart_;
  StampedTable<Entry, ViewDirectionId> entries_;
};

extern template class SourcePlane<ViewGeometry>;
extern template class SourcePlane<UnfilteredViewGeometry>;
extern template class SourcePlane<DisplacedViewGeometry>;

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_EDGES_SOURCE_PLANE_H_
