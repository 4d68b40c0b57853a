// SPDX-License-Identifier: GPL-3.0-or-later
// Where a blocker must be to matter: a convex region around receivers and a
// source.
//
// What hides any of a source S from a receiver r meets the convex hull of r
// and S. A shaft is an intersection of half-spaces {p : m . p >= c} that
// contains the hull for certain. It needs no error analysis of the normals m:
// for ANY doubles m, the least m . p over the points that span the hull,
// rounded downwards, is a valid c. How well m was computed only decides how
// tight the shaft is.

#ifndef TRUELUX_SCENE_INDEX_SHAFT_H_
#define TRUELUX_SCENE_INDEX_SHAFT_H_

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "truelux/geometry.h"
#include "truelux/scene.h"

#include "exact/vec3.h"
#include "scene/index/box.h"

namespace truelux {

/// What the shafts towards one source have in common; made once a source.
class ShaftSource {
 public:
  /// The source is the union of the triangles, which lie in one plane.
  /// vertices  the scene's
  /// facet     the triangles of one facet, at least one
  /// Requires RoundUpward.
  ShaftSource(std::span<const Point3> vertices,
              std::span<const Triangle> facet);

  /// The source's, exactly.
  [[nodiscard]] const Box& box() const { return box_; }

 private:
  friend class Shaft;

  /// An edge of a convex polygon around the source, nearly: the shaft's sides
  /// pass through these.
  struct Edge {
    Vec3<double> from;
    Vec3<double> along;  ///< of any length
  };

  void SetEdges(const Vec3<double>& normal);

  Box box_;                           ///< of the source, exactly
  std::vector<Vec3<double>> points_;  ///< their hull contains the source
  std::array<Edge, 4> edges_{};
  std::size_t edge_count_ = 0;
  Vec3<double> normal_{0, 0, 0};  ///< nearly; zero if the box says it all
  double normal_most_ = 0;        ///< at least m . p for m = normal_, p in S
  double normal_least_ = 0;       ///< at most m . p
};

/// Contains the convex hull of a box of receivers and a source: whatever hides
/// some of the source from one of the receivers meets the shaft. As tight as
/// the hull, up to rounding, for one receiver and a source with at most four
/// corners.
///
/// Overflow only makes a shaft wider. All members require a RoundUpward object
/// in the calling thread.
class Shaft {
 public:
  /// receivers  a box that holds the receivers; one receiver: Box::Of(r)
  /// normal     the normal n shared by all receivers, if they share one; then
  ///            the shaft leaves out what none of them sees because of
  ///            n . (p - r) < 0
  Shaft(const ShaftSource& source, const Box& receivers,
        const std::optional<Vector3>& normal = std::nullopt);

  /// Bit i is set unless box i is certainly outside the shaft. A box within
  /// another one is never kept when the other is not: the roundings of both
  /// tests are the same monotone function of the coordinates.
  [[nodiscard]] unsigned Kept(const FourBoxes& boxes) const;

  /// The same answer for one box.
  [[nodiscard]] bool Keeps(const Box& box) const;

 private:
  /// {p : normal . p >= least}.
  struct HalfSpace {
    Vec3<double> normal;
    double least;
    /// The rows of FourBoxes with the corner that has the greatest normal . p.
    std::array<std::size_t, 3> rows;
  };

  void Add(const Vec3<double>& normal, double least);
  void AddSides(const ShaftSource& source, const Box& receivers);
  void AddSourcePlane(const ShaftSource& source, const Box& receivers);
  void AddHorizon(const Box& receivers, const Vec3<double>& normal);

  Box box_;
  std::array<HalfSpace, 7> half_spaces_{};  ///< 4 sides, 2 of S, the horizon
  std::size_t count_ = 0;
};

}  // namespace truelux

#endif  // TRUELUX_SCENE_INDEX_SHAFT_H_
