// Pointed convex cones with apex r: a triangle as seen from the receiver, or
// the part of it above the horizon or in front of a source's plane.

#ifndef TRUELUX_VISIBILITY_CONE_H_
#define TRUELUX_VISIBILITY_CONE_H_

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "truelux/scene.h"

#include "exact/view_geometry.h"

namespace truelux {

/// Two vertices in either order, as one number; kNoEdgeKey for an edge that is
/// no edge of the scene (a cut or a horizon edge).
using EdgeKey = std::uint64_t;
inline constexpr EdgeKey kNoEdgeKey = ~EdgeKey{0};

/// A closed pointed cone of 3 or 4 edges, counter-clockwise from r: edge k
/// runs from direction k to direction k + 1 in plane k, whose normal points
/// inwards and is a positive multiple of direction k x direction k + 1.
struct Cone {
  static constexpr std::size_t kMaxEdges = 4;

  int triangle = -1;
  std::size_t size = 0;
  std::array<int, kMaxEdges> directions{};
  std::array<int, kMaxEdges> planes{};
  std::array<EdgeKey, kMaxEdges> keys{};

  [[nodiscard]] int From(std::size_t k) const { return directions[k]; }

  [[nodiscard]] int To(std::size_t k) const {
    return directions[k + 1 < size ? k + 1 : 0];
  }
};

/// Makes cones, and keeps what belongs to a triangle for one receiver.
class ConeMaker {
 public:
  /// The view geometry and the spans must outlive the object.
  ConeMaker(ViewGeometry& geometry, std::span<const Triangle> triangles);

  /// Sign of h_t, asked once per triangle.
  Sign ReceiverSide(int triangle);

  /// The cone of a whole triangle. Requires ReceiverSide != zero.
  const Cone& Whole(int triangle);

  /// The part of a triangle in n . d >= 0; nothing if no point has
  /// n . d > 0. Requires ReceiverSide != zero.
  std::optional<Cone> AboveHorizon(int triangle);

  /// The part of `triangle` strictly in front of the plane of `source`; a
  /// triangle in that plane is wholly in front iff `earlier`. Nothing if there
  /// is no such part. Requires ReceiverSide(triangle) != zero and
  /// ReceiverSide(source) negative.
  std::optional<Cone> InFrontOf(int source, int triangle, bool earlier);

  /// Id of the plane n . d = 0.
  [[nodiscard]] int horizon() const { return horizon_; }

  /// Sign of n . d for the direction to a scene vertex, asked once.
  Sign HorizonSide(int vertex);

 private:
  /// The corners' vertex numbers, counter-clockwise from r.
  std::array<int, 3> Corners(int triangle);

  ViewGeometry& geometry_;
  std::span<const Triangle> triangles_;
  int horizon_;
  std::vector<signed char> receiver_side_;  ///< per triangle; kUnknown
  std::vector<signed char> horizon_side_;   ///< per direction id; kUnknown
  std::vector<int> whole_index_;            ///< per triangle; -1: not yet
  std::vector<Cone> whole_;
};

/// Whether two cones certainly share no interior: a plane of one has the other
/// on its outer side. (Cones that only a slanted plane separates are missed;
/// they cost time, not correctness.)
bool Apart(ViewGeometry& geometry, const Cone& a, const Cone& b);

/// Whether plane by plane all directions of `inner` lie in the closed `outer`.
bool Contains(ViewGeometry& geometry, const Cone& outer, const Cone& inner);

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_CONE_H_
