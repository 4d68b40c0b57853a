// SPDX-License-Identifier: GPL-3.0-or-later
#include "baselines/vertex_tracer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "exact/vec3.h"

namespace truelux {
namespace {

using Vec = Vec3<double>;

std::size_t Index(int i) {
  return static_cast<std::size_t>(i);
}

std::uint64_t PairKey(int a, int b) {
  if (a > b) std::swap(a, b);
  return static_cast<std::uint64_t>(a) << 32U | static_cast<std::uint64_t>(b);
}

/// p x q for points of the image plane as directions (x, y, 1). By their
/// difference, so that near ones keep their bits.
Vec CrossOfImages(double px, double py, double qx, double qy) {
  const double dx = qx - px;
  const double dy = qy - py;
  return {-dy, dx, px * dy - py * dx};
}

bool IsBetween(double a, double x, double b) {
  return std::min(a, b) <= x && x <= std::max(a, b);
}

}  // namespace

VertexTracer::VertexTracer(const TracingView& view,
                           const TracerOptions& options)
    : view_(view),
      options_(options),
      sine_(std::sin(options.cone_angle)),
      visited_vertices_(view.vertices.size()) {}

bool VertexTracer::MeetsVertex(int vertex) const {
  if (vertex == traced_.vertex) return true;
  const TracingVertex& v = view_.vertices[Index(vertex)];
  if (v.x == traced_.x && v.y == traced_.y) return true;
  if (sine_ == 0) return false;
  const Vec cross = CrossOfImages(traced_.x, traced_.y, v.x, v.y);
  const double axis = 1 + traced_.x * traced_.x + traced_.y * traced_.y;
  const double size = 1 + v.x * v.x + v.y * v.y;
  return Dot(cross, cross) <= sine_ * sine_ * axis * size &&
         traced_.x * v.x + traced_.y * v.y + 1 > 0;
}

std::optional<double> VertexTracer::MeetsEdge(int edge) const {
  const ImageEdge& e = view_.edges[Index(edge)];
  const TracingVertex& a = view_.vertices[Index(e.a)];
  const TracingVertex& b = view_.vertices[Index(e.b)];
  const Vec normal = CrossOfImages(a.x, a.y, b.x, b.y);
  // The foot of the axis on the edge's plane is a combination of the ends.
  const double of_a =
      Dot(CrossOfImages(traced_.x, traced_.y, b.x, b.y), normal);
  const double of_b =
      Dot(CrossOfImages(a.x, a.y, traced_.x, traced_.y), normal);
  const double t = of_b / (of_a + of_b);
  if (traced_.edges[0] == edge || traced_.edges[1] == edge) return t;
  const double side = view_.Side(e, traced_.x, traced_.y);
  if (sine_ == 0) {
    if (side != 0 || !IsBetween(a.x, traced_.x, b.x) ||
        !IsBetween(a.y, traced_.y, b.y))
      return {};
    return t;
  }
  if (!(of_a >= 0) || !(of_b >= 0) || WasTracedElsewhere(edge)) return {};
  const double axis = 1 + traced_.x * traced_.x + traced_.y * traced_.y;
  if (side * side > sine_ * sine_ * axis * Dot(normal, normal)) return {};
  return t;
}

SpanDirection VertexTracer::Towards(int from, int to) const {
  const TracingVertex& a = view_.vertices[Index(from)];
  const TracingVertex& b = view_.vertices[Index(to)];
  return MakeImageDirection(b.x - a.x, b.y - a.y);
}

void VertexTracer::AddChain(const ImagePolygon& polygon, std::size_t before) {
  const std::size_t count = polygon.vertices.size();
  const int start = polygon.vertices[before];
  std::size_t k = (before + 1) % count;
  const int first = polygon.vertices[k];
  int last = first;
  for (; is_met_[k]; k = (k + 1) % count)
    last = polygon.vertices[k];
  if (sectors_.empty()) depth_ = view_.vertices[Index(first)].depth;
  ImageSector sector{Towards(first, start), Towards(last, polygon.vertices[k])};
  // The polygon is convex: more than half a turn is less than nothing, the
  // rounding of a polygon that is seen edge-on.
  if (IsMoreThanHalfTurn(sector)) sector.to = sector.from;
  sectors_.push_back(sector);
}

void VertexTracer::AddEdge(const ImagePolygon& polygon, std::size_t at) {
  const int edge = polygon.edges[at];
  const std::optional<double> t = MeetsEdge(edge);
  if (!t) return;
  met_edges_.push_back(edge);
  const ImageEdge& e = view_.edges[Index(edge)];
  if (sectors_.empty()) {
    const double at_a = 1 / view_.vertices[Index(e.a)].depth;
    const double at_b = 1 / view_.vertices[Index(e.b)].depth;
    depth_ = 1 / (at_a + *t * (at_b - at_a));
  }
  const int from = polygon.vertices[at];
  const int to = e.a == from ? e.b : e.a;
  sectors_.push_back({Towards(to, from), Towards(from, to)});
}

bool VertexTracer::Holds(const ImagePolygon& polygon) const {
  for (std::size_t k = 0; k < polygon.edges.size(); ++k) {
    const ImageEdge& edge = view_.edges[Index(polygon.edges[k])];
    const double side = view_.Side(edge, traced_.x, traced_.y);
    const bool along = edge.a == polygon.vertices[k];
    if (along ? side >= 0 : side <= 0) return false;
  }
  return true;
}

bool VertexTracer::Meet(const ImagePolygon& polygon) {
  const double reach = ConeReach(traced_.x, traced_.y, options_.cone_angle);
  if (!polygon.extent.Holds(traced_.x, traced_.y, reach)) return false;
  const std::size_t count = polygon.vertices.size();
  is_met_.assign(count, false);
  std::size_t met = 0;
  for (std::size_t k = 0; k < count; ++k) {
    if (!MeetsVertex(polygon.vertices[k])) continue;
    is_met_[k] = true;
    met_vertices_.push_back(polygon.vertices[k]);
    ++met;
  }
  if (met == count) return true;
  sectors_.clear();
  for (std::size_t k = 0; k < count; ++k) {
    if (is_met_[k]) continue;
    if (is_met_[(k + 1) % count]) {
      AddChain(polygon, k);
    } else {
      AddEdge(polygon, k);
    }
  }
  if (sectors_.empty() && !Holds(polygon)) return false;
  const auto& slope = polygon.inverse_depth;
  SpanContent content{depth_, polygon.exitance, slope[0], slope[1]};
  if (!sectors_.empty()) {
    spans_.InsertCommonPart(sectors_, content);
  } else {
    content.depth =
        1 / (slope[0] * traced_.x + slope[1] * traced_.y + slope[2]);
    spans_.InsertFull(content);
  }
  return true;
}

bool VertexTracer::WasVisited(const TracedVertex& vertex) const {
  if (vertex.vertex >= 0) return visited_vertices_[Index(vertex.vertex)];
  return visited_pairs_.contains(PairKey(vertex.edges[0], vertex.edges[1]));
}

bool VertexTracer::WasTracedElsewhere(int edge) const {
  return std::ranges::any_of(traced_.edges, [&](int own) {
    return own >= 0 && simple_pairs_.contains(PairKey(own, edge));
  });
}

bool VertexTracer::IsConjunctive() const {
  const auto is_own_edge = [this](int edge) {
    return edge == traced_.edges[0] || edge == traced_.edges[1];
  };
  return std::ranges::any_of(
             met_vertices_,
             [this](int vertex) { return vertex != traced_.vertex; }) ||
         !std::ranges::all_of(met_edges_, is_own_edge);
}

void VertexTracer::MarkVisited() {
  const auto keep_once = [](std::vector<int>& items) {
    std::ranges::sort(items);
    items.erase(std::unique(items.begin(), items.end()), items.end());
  };
  keep_once(met_vertices_);
  for (const int vertex : met_vertices_) {
    visited_vertices_[Index(vertex)] = true;
    // A pair of a vertex and an edge is kept as the pairs of that edge with
    // the edges that end at the vertex.
    const auto& edges = view_.vertices[Index(vertex)].edges;
    met_edges_.insert(met_edges_.end(), edges.begin(), edges.end());
  }
  keep_once(met_edges_);
  for (std::size_t i = 0; i < met_edges_.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k)
      visited_pairs_.insert(PairKey(met_edges_[i], met_edges_[k]));
  }
}

Rgb VertexTracer::Trace(const TracedVertex& vertex) {
  if (found_conjunction_ && WasVisited(vertex)) return {};
  traced_ = vertex;
  spans_.Clear();
  met_vertices_.clear();
  met_edges_.clear();
  bool meets_source = false;
  for (std::size_t i = 0; i < view_.polygons.size(); ++i) {
    // Nothing is lit where no source is.
    if (i == Index(view_.source_count) && !meets_source) return {};
    if (Meet(view_.polygons[i]) && i < Index(view_.source_count))
      meets_source = true;
  }
  if (vertex.vertex >= 0) visited_vertices_[Index(vertex.vertex)] = true;
  if (IsConjunctive()) {
    found_conjunction_ = true;
    MarkVisited();
  } else if (options_.is_strict && vertex.vertex < 0) {
    simple_pairs_.insert(PairKey(vertex.edges[0], vertex.edges[1]));
  }
  return spans_.Contribution(vertex.x, vertex.y);
}

}  // namespace truelux
