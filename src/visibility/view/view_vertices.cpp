// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/view/view_vertices.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "scene/scene_access.h"
#include "visibility/coincidence.h"

namespace truelux {
namespace {

/// The end of an arc's first or last piece that is not the vertex; an arc that
/// was not joined yet.
GluedVertexId OtherEnd(const GluedArc& arc, GluedVertexId vertex) {
  return arc.from == vertex ? arc.to : arc.from;
}

bool IsStraight(const Vec3<Exact>& before, const Vec3<Exact>& here,
                const Vec3<Exact>& after) {
  const Vec3<Exact> plane = Cross(before, here);
  return Dot(plane, after).is_zero() &&
         SignOf(Dot(plane, Cross(here, after))) == Sign::kPositive;
}

/// The arc run through the other way.
GluedArc Turned(const GluedArc& a) {
  return {a.to,           a.from,        a.right,    a.left,
          a.right_region, a.left_region, a.piece_to, a.piece_from};
}

}  // namespace

ArcsAround ArcsAroundVertices(const GluedView& view) {
  ArcsAround around(view.vertices.size());
  for (const GluedArcId a : view.arcs.ids()) {
    for (const GluedVertexId vertex : {view.arcs[a].from, view.arcs[a].to}) {
      if (vertex.valid()) around[vertex].push_back(a);
    }
  }
  return around;
}

ViewVertices::ViewVertices(const ContourQuery& query, FacetViews views,
                           const EdgeIndex& edges)
    : query_(query), views_(views), edges_(edges), exact_(ViewOf(query)) {
  for (const VertexId v : VerticesOf(query.scene).ids()) {
    const Vec3<Exact> d = exact_.FromReceiver(v);
    if (SignOf(Dot(exact_.ReceiverNormal(), d)) != Sign::kNegative)
      scene_vertices_.insert(MakePrimitive(d));
  }
}

bool ViewVertices::IsSource(FacetId facet) const {
  return facet.valid() && views_[facet].is_source;
}

bool ViewVertices::CanJoin(const GluedView& view, GluedVertexId vertex,
                           std::span<const GluedArcId> arcs) const {
  if (arcs.size() != 2 || arcs[0] == arcs[1]) return false;
  const GluedArc& a = view.arcs[arcs[0]];
  const GluedArc& b = view.arcs[arcs[1]];
  const auto direction = [&view](GluedVertexId v) -> const Vec3<Exact>& {
    return view.vertices[v].direction;
  };
  if (!IsStraight(direction(OtherEnd(a, vertex)), direction(vertex),
                  direction(OtherEnd(b, vertex)))) {
    return false;
  }
  const GluedVertex& here = view.vertices[vertex];
  if (!scene_vertices_.contains(here.key)) return true;
  const bool bounds_source = IsSource(a.left) || IsSource(a.right) ||
                             IsSource(b.left) || IsSource(b.right);
  return Describe(here, bounds_source).vertex.kind != VertexKind::kIntrinsic;
}

void ViewVertices::JoinArcs(GluedView& view) const {
  const ArcsAround around = ArcsAroundVertices(view);
  IdVector<GluedVertexId, bool> joins;
  for (const GluedVertexId v : around.ids())
    joins.push_back(CanJoin(view, v, around[v]));
  IdVector<GluedArcId, GluedArc> joined;
  IdVector<GluedArcId, bool> done(view.arcs.size(), false);
  /// Lengthens an arc at its end as far as it goes on.
  const auto extend = [&](GluedArc& arc, GluedArcId last) {
    while (joins[arc.to]) {
      const std::vector<GluedArcId>& there = around[arc.to];
      const GluedArcId next = there[0] == last ? there[1] : there[0];
      if (done[next]) break;  // once around the horizon
      done[next] = true;
      arc.to = OtherEnd(view.arcs[next], arc.to);
      last = next;
    }
  };
  for (const GluedArcId a : view.arcs.ids()) {
    if (done[a]) continue;
    done[a] = true;
    GluedArc arc = view.arcs[a];
    extend(arc, a);
    arc = Turned(arc);
    extend(arc, a);
    arc = Turned(arc);
    if (arc.from == arc.to && joins[arc.from]) arc.from = arc.to = {};
    joined.push_back(arc);
  }
  view.arcs = std::move(joined);
}

/// Whether just one source borders on a vertex, and its border goes straight
/// through it: then it is no vertex of that border.
bool ViewVertices::PassesStraight(const GluedView& view, GluedVertexId vertex,
                                  std::span<const GluedArcId> arcs) const {
  std::vector<std::pair<FaceId, const GluedArc*>> borders;
  for (const GluedArcId a : arcs) {
    const GluedArc& arc = view.arcs[a];
    for (const FacetId facet : {arc.left, arc.right}) {
      if (!IsSource(facet)) continue;
      borders.emplace_back(FaceOf(query_.scene, facet), &arc);
    }
  }
  if (borders.size() != 2 || borders[0].first != borders[1].first) return false;
  // All of the horizon is straight, and its arcs can be longer than pi.
  if (borders[0].second->on_horizon() && borders[1].second->on_horizon())
    return true;
  const auto beyond = [&](const GluedArc& arc) -> const Vec3<Exact>& {
    const GluedVertexId end =
        arc.from == vertex ? arc.piece_to : arc.piece_from;
    return view.vertices[end].direction;
  };
  return IsStraight(beyond(*borders[0].second), view.vertices[vertex].direction,
                    beyond(*borders[1].second));
}

WholeViewVertex ViewVertices::Classify(const GluedView& view,
                                       GluedVertexId vertex,
                                       std::span<const GluedArcId> arcs) const {
  const GluedVertex& here = view.vertices[vertex];
  const bool any_source = std::ranges::any_of(arcs, [&](GluedArcId a) {
    const GluedArc& arc = view.arcs[a];
    return IsSource(arc.left) || IsSource(arc.right);
  });
  if (!any_source) return Describe(here, false);
  WholeViewVertex result = Describe(here, true);
  if (result.vertex.kind != VertexKind::kIntrinsic &&
      PassesStraight(view, vertex, arcs)) {
    return Describe(here, false);
  }
  return result;
}

std::vector<EdgeHit> ViewVertices::HitsOf(const EdgesAt& edges,
                                          const GluedVertex& vertex,
                                          bool bounds_source) const {
  if (bounds_source) {
    std::vector<EdgeHit> hits;
    for (const FacetId facet : vertex.around) {
      if (!IsSource(facet)) continue;
      std::ranges::move(edges.OfSource(facet), std::back_inserter(hits));
    }
    return hits;
  }
  FacetId farthest = vertex.around.front();  // none, nothing, comes first
  for (const FacetId facet : vertex.around) {
    if (farthest.valid() &&
        edges_.DepthOrder(facet, farthest, vertex.direction) ==
            Sign::kPositive) {
      farthest = facet;
    }
  }
  return edges.NotBehind(farthest);
}

WholeViewVertex ViewVertices::Describe(const GluedVertex& vertex,
                                       bool bounds_source) const {
  const EdgesAt edges(edges_, vertex.direction);
  Coincidence c;
  WholeViewVertex result;
  const Vec3<Exact> normal = exact_.ReceiverNormal();
  for (const EdgeHit& hit : HitsOf(edges, vertex, bounds_source)) {
    c.Add(hit.plane, hit.vertex, normal);
    result.edges.push_back(hit.edge);
  }
  std::ranges::sort(result.edges);
  result.edges.erase(std::unique(result.edges.begin(), result.edges.end()),
                     result.edges.end());
  result.vertex.direction = ToDouble(vertex.key);
  c.Describe(vertex.on_horizon, result.vertex);
  result.bounds_source = bounds_source;
  result.planes_with_hidden = result.vertex.planes;
  if (result.vertex.conjunctive) {
    for (const EdgeHit& hit : edges.NotBehind(FacetId()))
      c.Add(hit.plane, hit.vertex, normal);
    ContourVertex all;
    c.Describe(vertex.on_horizon, all);
    result.planes_with_hidden = all.planes;
  }
  return result;
}

}  // namespace truelux
