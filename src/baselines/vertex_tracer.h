// SPDX-License-Identifier: GPL-3.0-or-later
// One ray or cone through one vertex of the image, and all that it meets
// (Stark and Riesenfeld 2000, sections 3.3 and 5).

#ifndef TRUELUX_BASELINES_VERTEX_TRACER_H_
#define TRUELUX_BASELINES_VERTEX_TRACER_H_

#include <array>
#include <cstdint>
#include <optional>
#include <unordered_set>
#include <vector>

#include "truelux/geometry.h"

#include "baselines/span_list.h"
#include "baselines/tracing_view.h"

namespace truelux {

/// Where to trace, and whose vertex it is: an intrinsic vertex of the view, or
/// the apparent vertex where two of its edges cross. -1: none.
struct TracedVertex {
  double x = 0;
  double y = 0;
  int vertex = -1;
  std::array<int, 2> edges{-1, -1};
};

/// How to trace.
struct TracerOptions {
  double cone_angle = 0;   ///< [rad] between a cone and its axis; 0: rays
  bool is_strict = false;  ///< VertexTracingOptions::strict_bookkeeping
};

/// Traces and remembers: no vertex of the view, no pair of its edges is
/// taken twice.
///
/// What a ray meets besides the traced vertex or edges themselves is what the
/// comparisons of plain double numbers say: the same coordinates, a point that
/// Side() puts exactly on an edge. What a cone meets is snapped to its axis: a
/// vertex by an angle of up to cone_angle; an edge, if neither of its ends is
/// met. Of a polygon, vertices in a row give one span, from the edge before
/// them to the edge behind; and several such spans, as of the two sides of a
/// strip that is narrower than the cone, give what they have in common. A
/// polygon all of whose vertices are met is gone.
class VertexTracer {
 public:
  /// The view must live longer.
  VertexTracer(const TracingView& view, const TracerOptions& options);

  /// pi times the vertex' share of E [W/m^2]; 0 if it was snapped to another.
  [[nodiscard]] Rgb Trace(const TracedVertex& vertex);

 private:
  /// Adds what is met of the polygon; whether that is anything.
  bool Meet(const ImagePolygon& polygon);
  void AddChain(const ImagePolygon& polygon, std::size_t before);
  void AddEdge(const ImagePolygon& polygon, std::size_t at);
  [[nodiscard]] bool Holds(const ImagePolygon& polygon) const;
  [[nodiscard]] bool MeetsVertex(int vertex) const;
  /// Where an edge is met that has no end there: 0 at its a, 1 at its b.
  [[nodiscard]] std::optional<double> MeetsEdge(int edge) const;
  [[nodiscard]] SpanDirection Towards(int from, int to) const;

  [[nodiscard]] bool WasVisited(const TracedVertex& vertex) const;
  /// Whether the edge has been traced by itself with one that is traced now.
  [[nodiscard]] bool WasTracedElsewhere(int edge) const;
  [[nodiscard]] bool IsConjunctive() const;
  void MarkVisited();

  const TracingView& view_;
  TracerOptions options_;
  double sine_;  ///< of the cone's angle
  TracedVertex traced_;
  SpanList spans_;
  // Of the polygon that is being met:
  std::vector<bool> is_met_;  ///< per vertex
  std::vector<ImageSector> sectors_;
  double depth_ = 0;  ///< of the first sector
  // Of the vertex that is being traced, with repetitions:
  std::vector<int> met_vertices_;
  std::vector<int> met_edges_;
  // Consulted once a conjunctive vertex was found:
  bool found_conjunction_ = false;
  std::vector<bool> visited_vertices_;
  std::unordered_set<std::uint64_t> visited_pairs_;
  std::unordered_set<std::uint64_t> simple_pairs_;  ///< traced alone; strict
};

}  // namespace truelux

#endif  // TRUELUX_BASELINES_VERTEX_TRACER_H_
