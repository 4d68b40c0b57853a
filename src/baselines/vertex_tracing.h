// SPDX-License-Identifier: GPL-3.0-or-later
// Irradiance by vertex tracing, as Stark and Riesenfeld published it in 2000:
// the algorithm that truelux replaces.

#ifndef TRUELUX_BASELINES_VERTEX_TRACING_H_
#define TRUELUX_BASELINES_VERTEX_TRACING_H_

#include "truelux/geometry.h"
#include "truelux/receiver.h"
#include "truelux/scene.h"

#include "baselines/vertex_tracer.h"
#include "scene/index/convex_pieces.h"

namespace truelux {

/// kRays: what coincides is what plain double comparisons say.
/// kCones: what comes near a traced vertex is snapped to it.
enum class Tracing { kRays, kCones };

struct VertexTracingOptions {
  Tracing tracing = Tracing::kRays;
  /// Of kCones: the angle between a cone and its axis [rad], in (0, 0.1].
  /// The paper found 1e-7 to 1e-6 to work well.
  double nape_angle = 1e-6;
  /// Of kCones, and not in the paper: the crossing of two edges that was
  /// traced without anything else in its cone is not taken once more in the
  /// cone of another crossing near it, to which the paper's tables, which are
  /// looked at before a vertex is traced only, leave it open.
  bool strict_bookkeeping = false;
};

/// The sum over all apparent vertices of what is seen, each found by itself:
/// a ray or cone is traced from r through every vertex and through every
/// apparent crossing of two edges, the polygons that it meets become angular
/// spans, and formula (9) of the paper gives the vertex' share of E.
///
/// Everything is double, in the image plane, within the square of half-side
/// 2^20 around its origin; what lies outside of it is cut off, which costs at
/// most M / (1 + 2^40). As section 4 of the paper allows, only silhouettes
/// are intersected, and only what overlaps a source and is not all behind it.
/// Polygons that are not convex, and those with more than seven corners, are
/// taken as triangles.
///
/// What it cannot do:
/// - Rays: several edges or vertices that coincide in the image (conjunctive
///   vertices) are found only if rounding happens to leave them exactly
///   together. Else a term can be lost or counted twice; one is O(side) and
///   the sum O(side^2) of the source's side in the image.
/// - Cones: what is nearer to a vertex than the nape angle is moved there, an
///   error of that order, or that of a lost or repeated term where a snap is
///   seen from one side only.
/// - No error bound, no warning.
/// - Polygons that pass through each other: their line of intersection is no
///   edge. Coplanar polygons that overlap, or that touch without common
///   vertices: their order in depth is what rounding makes of it.
class VertexTracing {
 public:
  /// std::invalid_argument if the nape angle is out of range.
  explicit VertexTracing(Scene scene, const VertexTracingOptions& options = {});

  /// E [W/m^2] per channel, Ke read as exitance. Faces whose plane contains
  /// the receiver (height zero in double) are not seen; on_face as in
  /// Receiver. May be called from several threads.
  [[nodiscard]] Rgb Evaluate(const Receiver& receiver) const;

 private:
  Scene scene_;
  ConvexPieces pieces_;
  TracerOptions options_;
};

}  // namespace truelux

#endif  // TRUELUX_BASELINES_VERTEX_TRACING_H_
