// SPDX-License-Identifier: GPL-3.0-or-later
// Planes and directions through the receiver r, as recipes over the input.
//
// Nothing that a predicate decides on is ever rounded: a plane or a direction
// is stored as the input numbers that define it, and evaluated at whatever
// number type is asked for (interval, exact, double-double, ...), with ring
// operations only. Frame: the scene's, origin moved to r. Planes are normals
// N (the plane is N . d = 0), known up to a positive factor; directions
// likewise. Equation numbers refer to docs/method.md.
//
// Letters: r the receiver, n its normal; N a plane's or a triangle's normal,
// d a direction; h the height N . (p - r) of a triangle's plane over r; f a
// linear function whose sign tells the sides of a plane.

#ifndef TRUELUX_EXACT_RECIPE_H_
#define TRUELUX_EXACT_RECIPE_H_

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>

#include "truelux/geometry.h"
#include "truelux/scene.h"

#include "base/id_vector.h"
#include "base/ids.h"

namespace truelux {

/// A plane through r, by its normal.
class PlaneRecipe {
 public:
  /// What the normal is made of.
  enum class Kind : std::uint8_t {
    kEdge,      ///< (a - r) x (b - a), a and b scene vertices; degree 2
    kHorizon,   ///< the receiver's normal n; degree 1
    kCut,       ///< h_b N_a - h_a N_b, a and b triangles, N a triangle's
                ///< normal, h = N . (p - r) of any of its points p: the plane
                ///< through r and the line where both planes meet; degree 5
    kExplicit,  ///< one of the explicit vectors
  };

  /// An edge between no vertices, to be assigned to.
  constexpr PlaneRecipe() = default;

  /// The plane of the scene edge from a to b.
  static constexpr PlaneRecipe OfEdge(VertexId a, VertexId b) {
    return {Kind::kEdge, a.value(), b.value()};
  }

  /// The receiver plane.
  static constexpr PlaneRecipe OfHorizon() { return {Kind::kHorizon, -1, -1}; }

  /// The plane through the line where the planes of triangles a and b meet.
  static constexpr PlaneRecipe OfCut(TriangleId a, TriangleId b) {
    return {Kind::kCut, a.value(), b.value()};
  }

  /// The plane with this normal.
  static constexpr PlaneRecipe Explicit(ExplicitId normal) {
    return {Kind::kExplicit, normal.value(), -1};
  }

  [[nodiscard]] constexpr Kind kind() const { return kind_; }

  /// Whether the normal is taken times -1.
  [[nodiscard]] constexpr bool negated() const { return negated_; }

  /// The recipe with its normal times -1 if asked for.
  [[nodiscard]] constexpr PlaneRecipe NegatedIf(bool negate) const {
    PlaneRecipe result = *this;
    result.negated_ = negated_ != negate;
    return result;
  }

  /// a of kEdge.
  [[nodiscard]] constexpr VertexId from() const {
    assert(kind_ == Kind::kEdge);
    return VertexId(a_);
  }

  /// b of kEdge.
  [[nodiscard]] constexpr VertexId to() const {
    assert(kind_ == Kind::kEdge);
    return VertexId(b_);
  }

  /// a of kCut.
  [[nodiscard]] constexpr TriangleId first_triangle() const {
    assert(kind_ == Kind::kCut);
    return TriangleId(a_);
  }

  /// b of kCut.
  [[nodiscard]] constexpr TriangleId second_triangle() const {
    assert(kind_ == Kind::kCut);
    return TriangleId(b_);
  }

  /// The vector of kExplicit.
  [[nodiscard]] constexpr ExplicitId explicit_vector() const {
    assert(kind_ == Kind::kExplicit);
    return ExplicitId(a_);
  }

  /// Whether it is the same recipe with a and b exchanged.
  [[nodiscard]] constexpr bool IsReverseOf(const PlaneRecipe& other) const {
    return kind_ == other.kind_ && a_ == other.b_ && b_ == other.a_ &&
           negated_ == other.negated_;
  }

  friend bool operator==(const PlaneRecipe&, const PlaneRecipe&) = default;

 private:
  constexpr PlaneRecipe(Kind kind, int a, int b) : kind_(kind), a_(a), b_(b) {}

  Kind kind_ = Kind::kEdge;
  bool negated_ = false;
  int a_ = -1;
  int b_ = -1;
};

/// A direction from r.
class DirectionRecipe {
 public:
  /// What the direction is made of.
  enum class Kind : std::uint8_t {
    kVertex,         ///< a - r, a a scene vertex; degree 1
    kEdgeAtHorizon,  ///< where the edge from a to b, vertices, meets the
                     ///< receiver plane; with f(p) = n.(p-r) it is
                     ///< f(a)(b-r) - f(b)(a-r), f(a) > 0 > f(b); degree 2
    kEdgeAtPlane,    ///< where the edge from a to b meets the plane of
                     ///< triangle c; the same with f(p) = N_c . (p - c_0);
                     ///< degree 4
    kCrossing,       ///< N_a x N_b of planes a and b of the contour
    kExplicit,       ///< one of the explicit vectors
  };

  /// The direction to no vertex, to be assigned to.
  constexpr DirectionRecipe() = default;

  /// The direction to a scene vertex.
  static constexpr DirectionRecipe ToVertex(VertexId vertex) {
    return {Kind::kVertex, vertex.value()};
  }

  /// Where an edge meets the receiver plane.
  static constexpr DirectionRecipe EdgeAtHorizon(VertexId above,
                                                 VertexId below) {
    return {Kind::kEdgeAtHorizon, above.value(), below.value()};
  }

  /// Where an edge meets the plane of a triangle.
  static constexpr DirectionRecipe EdgeAtPlane(VertexId in_front,
                                               VertexId behind,
                                               TriangleId triangle) {
    return {Kind::kEdgeAtPlane, in_front.value(), behind.value(),
            triangle.value()};
  }

  /// The line where two planes meet, N_a x N_b.
  static constexpr DirectionRecipe Crossing(PlaneId a, PlaneId b) {
    return {Kind::kCrossing, a.value(), b.value()};
  }

  /// This direction.
  static constexpr DirectionRecipe Explicit(ExplicitId direction) {
    return {Kind::kExplicit, direction.value()};
  }

  [[nodiscard]] constexpr Kind kind() const { return kind_; }

  /// Whether the direction is taken times -1.
  [[nodiscard]] constexpr bool negated() const { return negated_; }

  /// The recipe with its direction times -1 if asked for.
  [[nodiscard]] constexpr DirectionRecipe NegatedIf(bool negate) const {
    DirectionRecipe result = *this;
    result.negated_ = negated_ != negate;
    return result;
  }

  /// a of kVertex.
  [[nodiscard]] constexpr VertexId vertex() const {
    assert(kind_ == Kind::kVertex);
    return VertexId(a_);
  }

  /// a of kEdgeAtHorizon and kEdgeAtPlane.
  [[nodiscard]] constexpr VertexId from() const {
    assert(IsOnEdge());
    return VertexId(a_);
  }

  /// b of kEdgeAtHorizon and kEdgeAtPlane.
  [[nodiscard]] constexpr VertexId to() const {
    assert(IsOnEdge());
    return VertexId(b_);
  }

  /// c of kEdgeAtPlane.
  [[nodiscard]] constexpr TriangleId triangle() const {
    assert(kind_ == Kind::kEdgeAtPlane);
    return TriangleId(c_);
  }

  /// a of kCrossing.
  [[nodiscard]] constexpr PlaneId first_plane() const {
    assert(kind_ == Kind::kCrossing);
    return PlaneId(a_);
  }

  /// b of kCrossing.
  [[nodiscard]] constexpr PlaneId second_plane() const {
    assert(kind_ == Kind::kCrossing);
    return PlaneId(b_);
  }

  /// The vector of kExplicit.
  [[nodiscard]] constexpr ExplicitId explicit_vector() const {
    assert(kind_ == Kind::kExplicit);
    return ExplicitId(a_);
  }

  friend bool operator==(const DirectionRecipe&,
                         const DirectionRecipe&) = default;

 private:
  constexpr DirectionRecipe(Kind kind, int a, int b = -1, int c = -1)
      : kind_(kind), a_(a), b_(b), c_(c) {}

  [[nodiscard]] constexpr bool IsOnEdge() const {
    return kind_ == Kind::kEdgeAtHorizon || kind_ == Kind::kEdgeAtPlane;
  }

  Kind kind_ = Kind::kVertex;
  bool negated_ = false;
  int a_ = -1;
  int b_ = -1;
  int c_ = -1;
};

/// The corners of a triangle.
inline std::array<VertexId, 3> CornersOf(const Triangle& triangle) {
  const auto& [a, b, c] = triangle.vertices;
  return {VertexId(a), VertexId(b), VertexId(c)};
}

struct Displacement;

/// The input that recipes are evaluated on. Does not own the spans.
struct ReceiverView {
  IdSpan<VertexId, const Point3> vertices;
  IdSpan<TriangleId, const Triangle> triangles;
  Point3 position;  ///< r
  Vector3 normal;   ///< n
  /// Taken into account by exact numbers only, to which it is not too small;
  /// null for none.
  const Displacement* displacement = nullptr;

  /// The place of corner k of a triangle.
  [[nodiscard]] const Point3& Corner(TriangleId triangle, std::size_t k) const {
    return vertices[VertexId(triangles[triangle].vertices[k])];
  }
};

}  // namespace truelux

#endif  // TRUELUX_EXACT_RECIPE_H_
