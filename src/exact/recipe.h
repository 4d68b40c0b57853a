// Planes and directions through the receiver r, as recipes over the input.
//
// Nothing that a predicate decides on is ever rounded: a plane or a direction
// is stored as the input numbers that define it, and evaluated at whatever
// number type is asked for (interval, exact, double-double, ...), with ring
// operations only. Frame: the scene's, origin moved to r. Planes are normals
// N (the plane is N . d = 0), known up to a positive factor; directions
// likewise. Equation numbers refer to docs/method.md.

#ifndef TRUELUX_EXACT_RECIPE_H_
#define TRUELUX_EXACT_RECIPE_H_

#include <cstdint>
#include <span>

#include "truelux/geometry.h"
#include "truelux/scene.h"

namespace truelux {

/// A plane through r, by its normal.
struct PlaneRecipe {
  enum class Kind : std::uint8_t {
    kEdge,      ///< (a - r) x (b - a), a and b scene vertices; degree 2
    kHorizon,   ///< the receiver's normal n; degree 1
    kCut,       ///< h_b N_a - h_a N_b, a and b triangles, N a triangle's
                ///< normal, h = N . (p - r) of any of its points p: the plane
                ///< through r and the line where both planes meet; degree 5
    kExplicit,  ///< entry a of the explicit vectors
  };
  Kind kind = Kind::kEdge;
  bool negated = false;  ///< the normal times -1
  int a = -1;
  int b = -1;

  friend bool operator==(const PlaneRecipe&, const PlaneRecipe&) = default;
};

/// A direction from r.
struct DirectionRecipe {
  enum class Kind : std::uint8_t {
    kVertex,         ///< a - r, a a scene vertex; degree 1
    kEdgeAtHorizon,  ///< where the edge from a to b, vertices, meets the
                     ///< receiver plane; requires n.(a-r) > 0 > n.(b-r), then
                     ///< f(a)(b-r) - f(b)(a-r), f(p) = n.(p-r); degree 2
    kEdgeAtPlane,    ///< where the edge from a to b meets the plane of
                     ///< triangle c; requires f(a) > 0 > f(b) with
                     ///< f(p) = N_c . (p - c_0); degree 4
    kCrossing,       ///< N_a x N_b of planes a and b of the contour
    kExplicit,       ///< entry a of the explicit vectors
  };
  Kind kind = Kind::kVertex;
  bool negated = false;  ///< the direction times -1
  int a = -1;
  int b = -1;
  int c = -1;

  friend bool operator==(const DirectionRecipe&,
                         const DirectionRecipe&) = default;
};

/// The input that recipes are evaluated on. Does not own the spans.
struct ReceiverView {
  std::span<const Point3> vertices;
  std::span<const Triangle> triangles;
  Point3 position;
  Vector3 normal;
};

}  // namespace truelux

#endif  // TRUELUX_EXACT_RECIPE_H_
