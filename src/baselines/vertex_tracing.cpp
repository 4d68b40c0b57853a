// SPDX-License-Identifier: GPL-3.0-or-later
#include "baselines/vertex_tracing.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "baselines/tracing_view.h"
#include "visibility/contour.h"

namespace truelux {
namespace {

constexpr double kLargestNapeAngle = 0.1;

std::size_t Index(int i) {
  return static_cast<std::size_t>(i);
}

/// The sum over the vertices of one view.
class VertexSum {
 public:
  VertexSum(const TracingView& view, const TracerOptions& options)
      : view_(view), cone_angle_(options.cone_angle), tracer_(view, options) {}

  /// Before AddApparentVertices: an edge is snapped to the cone of a vertex
  /// near it, but not always the vertex to the cones on the edge.
  void AddIntrinsicVertices();
  void AddApparentVertices();

  /// pi E [W/m^2].
  [[nodiscard]] const Rgb& sum() const { return sum_; }

 private:
  struct Span {
    double x_low;
    double x_high;
    double y_low;
    double y_high;
    int edge;
  };

  [[nodiscard]] bool MayBeLit(double x, double y) const;
  [[nodiscard]] std::vector<Span> Silhouettes() const;
  void AddCrossing(int first, int second);
  void Add(const TracedVertex& vertex);

  const TracingView& view_;
  double cone_angle_;
  VertexTracer tracer_;
  Rgb sum_{};
};

bool VertexSum::MayBeLit(double x, double y) const {
  const double reach = ConeReach(x, y, cone_angle_);
  for (std::size_t i = 0; i < Index(view_.source_count); ++i) {
    if (view_.polygons[i].extent.Holds(x, y, reach)) return true;
  }
  return false;
}

void VertexSum::Add(const TracedVertex& vertex) {
  if (!MayBeLit(vertex.x, vertex.y)) return;
  const Rgb share = tracer_.Trace(vertex);
  for (std::size_t c = 0; c < sum_.size(); ++c)
    sum_[c] += share[c];
}

void VertexSum::AddIntrinsicVertices() {
  for (std::size_t i = 0; i < view_.vertices.size(); ++i) {
    const TracingVertex& v = view_.vertices[i];
    const auto is_contour = [this](int edge) {
      return view_.edges[Index(edge)].is_contour;
    };
    if (std::ranges::any_of(v.edges, is_contour))
      Add({v.x, v.y, static_cast<int>(i), {-1, -1}});
  }
}

std::vector<VertexSum::Span> VertexSum::Silhouettes() const {
  std::vector<Span> spans;
  for (std::size_t i = 0; i < view_.edges.size(); ++i) {
    const ImageEdge& edge = view_.edges[i];
    if (!edge.is_contour) continue;
    const TracingVertex& a = view_.vertices[Index(edge.a)];
    const TracingVertex& b = view_.vertices[Index(edge.b)];
    spans.push_back({std::min(a.x, b.x), std::max(a.x, b.x), std::min(a.y, b.y),
                     std::max(a.y, b.y), static_cast<int>(i)});
  }
  std::ranges::sort(spans, {}, &Span::x_low);
  return spans;
}

void VertexSum::AddApparentVertices() {
  const std::vector<Span> spans = Silhouettes();
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const Span& first = spans[i];
    for (std::size_t k = i + 1;
         k < spans.size() && spans[k].x_low <= first.x_high; ++k) {
      const Span& second = spans[k];
      if (second.y_low <= first.y_high && first.y_low <= second.y_high)
        AddCrossing(first.edge, second.edge);
    }
  }
}

void VertexSum::AddCrossing(int first, int second) {
  const ImageEdge& e = view_.edges[Index(first)];
  const ImageEdge& f = view_.edges[Index(second)];
  if (e.a == f.a || e.a == f.b || e.b == f.a || e.b == f.b) return;
  const TracingVertex& a = view_.vertices[Index(e.a)];
  const TracingVertex& b = view_.vertices[Index(e.b)];
  const TracingVertex& c = view_.vertices[Index(f.a)];
  const TracingVertex& d = view_.vertices[Index(f.b)];
  const double at_a = view_.Side(f, a.x, a.y);
  const double at_b = view_.Side(f, b.x, b.y);
  const double at_c = view_.Side(e, c.x, c.y);
  const double at_d = view_.Side(e, d.x, d.y);
  if (!((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0))) return;
  if (!((at_c < 0 && at_d > 0) || (at_c > 0 && at_d < 0))) return;
  const double t = at_a / (at_a - at_b);
  Add({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), -1, {first, second}});
}

TracerOptions Checked(const VertexTracingOptions& options) {
  if (options.tracing == Tracing::kRays) return {};
  const double angle = options.nape_angle;
  if (!(angle > 0 && angle <= kLargestNapeAngle))
    throw std::invalid_argument("the nape angle is in (0, 0.1] rad");
  return {angle, options.strict_bookkeeping};
}

}  // namespace

VertexTracing::VertexTracing(Scene scene, const VertexTracingOptions& options)
    : scene_(std::move(scene)), pieces_(scene_), options_(Checked(options)) {}

Rgb VertexTracing::Evaluate(const Receiver& receiver) const {
  const TracingView view =
      MakeTracingView(scene_, pieces_, receiver,
                      IgnoredFacets({scene_, receiver}), options_.cone_angle);
  if (view.source_count == 0) return {};
  VertexSum vertices(view, options_);
  vertices.AddIntrinsicVertices();
  vertices.AddApparentVertices();
  Rgb e = vertices.sum();
  for (double& channel : e)
    channel /= std::numbers::pi;
  return e;
}

}  // namespace truelux
