// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/view/whole_view.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>

#include "exact/recipe_evaluator.h"
#include "visibility/arrangement/arrangement_view.h"
#include "visibility/view/edge_index.h"
#include "visibility/view/glued_view.h"
#include "visibility/view/relevant_triangles.h"
#include "visibility/view/view_loops.h"
#include "visibility/view/view_vertices.h"

namespace truelux {
namespace {

/// Puts the public view together.
class ViewAssembly {
 public:
  ViewAssembly(const ContourQuery& query, FacetViews views,
               const GluedView& glued, const EdgeIndex& edges)
      : query_(query),
        views_(views),
        glued_(glued),
        edges_(edges),
        exact_(ViewOf(query)) {}

  WholeView Assemble(ViewVertices& vertices) {
    for (const GluedArc& arc : glued_.arcs)
      AddArc(arc);
    AddRegions();
    AddVertices(vertices);
    return std::move(view_);
  }

 private:
  void AddArc(const GluedArc& glued) {
    WholeViewArc arc;
    arc.from = glued.from.value();
    arc.to = glued.to.value();
    arc.left = glued.left_region.value();
    arc.right = glued.right_region.value();
    SetEdge(glued, arc);
    Vec3<Exact> plane = PlaneOf(arc);
    if (arc.kind != ViewArcKind::kHorizon &&
        SignOf(Dot(plane, Cross(Direction(glued.piece_from),
                                Direction(glued.piece_to)))) ==
            Sign::kNegative) {
      plane = -plane;
    }
    arc.at_least_pi =
        glued.from == glued.to ||
        SignOf(Dot(plane, Cross(Direction(glued.from), Direction(glued.to)))) !=
            Sign::kPositive;
    arc.plane_normal = ToDouble(MakePrimitive(plane));
    planes_.push_back(std::move(plane));
    view_.arcs.push_back(arc);
  }

  const Vec3<Exact>& Direction(GluedVertexId vertex) const {
    return glued_.vertices[vertex].direction;
  }

  /// The plane through r that holds an arc, with any sign.
  Vec3<Exact> PlaneOf(const WholeViewArc& arc) const {
    if (arc.kind == ViewArcKind::kHorizon) return exact_.ReceiverNormal();
    if (arc.edge.a >= 0) {
      return Cross(exact_.FromReceiver(VertexId(arc.edge.a)),
                   exact_.FromReceiver(VertexId(arc.edge.b)));
    }
    return meeting_plane_;
  }

  /// What separates the two sides of an arc.
  void SetEdge(const GluedArc& glued, WholeViewArc& arc) {
    arc.kind = ViewArcKind::kHorizon;
    if (glued.on_horizon()) return;
    arc.kind = ViewArcKind::kSilhouette;
    const Vec3<Exact>& from = Direction(glued.piece_from);
    const Vec3<Exact>& to = Direction(glued.piece_to);
    FacetId near = std::max(glued.left, glued.right);
    const FacetId far = std::min(glued.left, glued.right);
    Sign order = Sign::kPositive;  // far is farther
    if (far.valid()) {
      order = edges_.DepthOrder(far, near, from);
      if (order == Sign::kZero) order = edges_.DepthOrder(far, near, to);
    }
    if (order == Sign::kZero) {
      SetEdgeOfEqualDepth(far, near, from, to, arc);
      return;
    }
    if (order == Sign::kNegative) near = far;
    const auto edge = edges_.AlongArc(near, from, to);
    if (!edge) throw std::logic_error("a face ends where it has no edge");
    arc.edge = *edge;
  }

  /// Both facets are equally far all along; a < b.
  void SetEdgeOfEqualDepth(FacetId a, FacetId b, const Vec3<Exact>& from,
                           const Vec3<Exact>& to, WholeViewArc& arc) {
    const auto edge_a = edges_.AlongArc(a, from, to);
    const auto edge_b = edges_.AlongArc(b, from, to);
    arc.kind = ViewArcKind::kContact;
    if (edge_a) arc.edge = *edge_a;  // the first one is in front
    if (!edge_a && edge_b) arc.edge = *edge_b;
    if (edge_a && edge_b && *edge_a == *edge_b) arc.kind = ViewArcKind::kInner;
    if (edge_a || edge_b) return;
    arc.kind = ViewArcKind::kMeeting;
    meeting_plane_ = edges_.MeetingPlane(a, b);
    arc.edge = {std::min(edges_.FaceNumber(a), edges_.FaceNumber(b)), -1, -1,
                std::max(edges_.FaceNumber(a), edges_.FaceNumber(b))};
  }

  void AddRegions() {
    const auto loops = LoopsOf(glued_, planes_);
    for (const std::vector<ViewLoop>& around : loops) {
      ViewRegion region;
      region.loops = around;
      view_.regions.push_back(std::move(region));
    }
    for (const GluedArc& arc : glued_.arcs) {
      SetFacet(arc.left_region, arc.left);
      SetFacet(arc.right_region, arc.right);
    }
  }

  void SetFacet(RegionId id, FacetId facet) {
    if (!id.valid() || !facet.valid()) return;
    ViewRegion& region = view_.regions[id.index()];
    if (region.facet >= 0 && region.facet <= facet.value()) return;
    region.facet = facet.value();
    region.face = edges_.FaceNumber(facet);
    region.front = SignOf(views_[facet].height) == Sign::kNegative;
  }

  /// Those where arcs end, in the order of the arcs.
  void AddVertices(ViewVertices& vertices) {
    const ArcsAround around = ArcsAroundVertices(glued_);
    IdVector<GluedVertexId, int> new_index(glued_.vertices.size(), -1);
    const auto renumber = [&](int& vertex) {
      const GluedVertexId glued(vertex);
      if (!glued.valid()) return;
      int& index = new_index[glued];
      if (index < 0) {
        index = static_cast<int>(view_.vertices.size());
        view_.vertices.push_back(
            vertices.Classify(glued_, glued, around[glued]));
      }
      vertex = index;
    };
    for (WholeViewArc& arc : view_.arcs) {
      renumber(arc.from);
      renumber(arc.to);
    }
  }

  const ContourQuery& query_;
  FacetViews views_;
  const GluedView& glued_;
  const EdgeIndex& edges_;
  RecipeEvaluator<Exact> exact_;
  WholeView view_;
  IdVector<GluedArcId, Vec3<Exact>> planes_;  ///< to the arc's left
  Vec3<Exact> meeting_plane_;                 ///< of the last arc of that kind
};

}  // namespace

WholeView WholeViewOf(const ContourQuery& query,
                      const std::function<void(int)>& on_step) {
  constexpr std::size_t kCharts = kWholeViewSteps - 1;
  const IdVector<FacetId, FacetView> views = FacetViewsOf(query);
  std::vector<ChartView> charts;
  for (std::size_t chart = 0; chart < kCharts; ++chart) {
    if (on_step) on_step(static_cast<int>(chart));
    charts.push_back(WholeChartViewOf(query, views, chart));
  }
  if (on_step) on_step(static_cast<int>(kCharts));
  GluedView glued = Glue(query, charts);
  const EdgeIndex edges(query, RelevantTriangles(query));
  ViewVertices vertices(query, views, edges);
  vertices.JoinArcs(glued);
  return ViewAssembly(query, views, glued, edges).Assemble(vertices);
}

}  // namespace truelux
