// SPDX-License-Identifier: GPL-3.0-or-later
// A scene projected onto the image plane of a receiver, in double: what vertex
// tracing works on (Stark and Riesenfeld 2000, sections 2 and 4).

#ifndef TRUELUX_BASELINES_TRACING_VIEW_H_
#define TRUELUX_BASELINES_TRACING_VIEW_H_

#include <array>
#include <limits>
#include <vector>

#include "truelux/geometry.h"
#include "truelux/receiver.h"
#include "truelux/scene.h"

#include "base/id_vector.h"
#include "base/ids.h"
#include "scene/index/convex_pieces.h"

namespace truelux {

/// Half-side of the square of the image plane to which all polygons are
/// clipped, as section 2.2 of the paper allows. What lies outside of it gives
/// at most M / (1 + 2^40) of E.
inline constexpr double kTracingHalfSide = 0x1p20;

/// A bounding box in the image plane, at unit distance from the receiver [1].
struct ImageExtent {
  double x_low = std::numeric_limits<double>::infinity();
  double x_high = -std::numeric_limits<double>::infinity();
  double y_low = std::numeric_limits<double>::infinity();
  double y_high = -std::numeric_limits<double>::infinity();

  void Add(double x, double y);
  [[nodiscard]] bool Holds(double x, double y, double margin) const;
  [[nodiscard]] bool Meets(const ImageExtent& other, double margin) const;
};

struct TracingVertex {
  double x = 0;
  double y = 0;
  double depth = 0;  ///< height above the receiver plane [scene length unit]
  std::vector<int> edges;  ///< that end here
};

struct ImageEdge {
  int a = 0;  ///< a < b, whatever the polygon: shared edges are one edge
  int b = 0;
  std::vector<int> polygons;
  /// False where two polygons of equal exitance meet side by side: no part of
  /// such an edge can be seen, and only silhouettes need be examined.
  bool is_contour = true;
};

/// A convex polygon, clockwise in the image plane.
struct ImagePolygon {
  std::vector<int> vertices;
  std::vector<int> edges;  ///< entry i: from vertex i to vertex i + 1
  Rgb exitance{};          ///< [W/m^2]; black if seen from behind
  std::array<double, 3> inverse_depth{};  ///< . (x, y, 1) = 1 / depth
  ImageExtent extent;
};

struct TracingView {
  std::vector<TracingVertex> vertices;
  std::vector<ImageEdge> edges;
  std::vector<ImagePolygon> polygons;  ///< those that emit come first
  int source_count = 0;

  /// Twice the area of a, b, p for the edge a b: its sign says on which side
  /// of the edge (x, y) lies.
  [[nodiscard]] double Side(const ImageEdge& edge, double x, double y) const;
};

/// The polygons that matter: those that emit towards the receiver, and those
/// that overlap the extent of one of these and are not all behind its plane.
/// ignored: per facet, or empty. cone_angle [rad]: how far an overlap can be
/// missed in the image and still matter; 0 for rays.
[[nodiscard]] TracingView MakeTracingView(
    const Scene& scene, const ConvexPieces& pieces, const Receiver& receiver,
    const IdVector<FacetId, bool>& ignored, double cone_angle);

/// How far in the image plane [1] a cone around (x, y) can reach, rounded
/// up generously. cone_angle [rad]: 0 for rays.
[[nodiscard]] double ConeReach(double x, double y, double cone_angle);

}  // namespace truelux

#endif  // TRUELUX_BASELINES_TRACING_VIEW_H_
