// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/visible_contour.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <optional>
#include <utility>

#include "exact/primitive.h"
#include "exact/recipe_evaluator.h"
#include "scene/scene_access.h"
#include "visibility/arc_cleanup.h"
#include "visibility/coincidence.h"
#include "visibility/view/edges_at.h"
#include "visibility/view/nearest_edge.h"
#include "visibility/view/relevant_triangles.h"

namespace truelux {
namespace {

/// What could bound one source.
class SourceEdges {
 public:
  SourceEdges(const ContourQuery& query, FacetId facet, bool in_detail)
      : front_(query, facet), index_(query, TrianglesOfSource(query, front_)) {
    if (in_detail) nearest_.emplace(index_, front_);
  }

  SourceEdges(const SourceEdges&) = delete;
  SourceEdges& operator=(const SourceEdges&) = delete;

  [[nodiscard]] FacetId facet() const { return front_.facet(); }

  [[nodiscard]] std::vector<EdgeHit> Through(const Vec3<Exact>& d) const {
    return EdgesAt(index_, d).OfSource(facet());
  }

  /// Nothing unless in_detail was asked for.
  [[nodiscard]] std::optional<EdgeMiss> NearestTo(const Vec3<Exact>& d) const {
    return nearest_ ? nearest_->To(d) : std::nullopt;
  }

 private:
  FacetFront front_;
  EdgeIndex index_;
  std::optional<NearestEdge> nearest_;
};

/// Describes one contour; keeps the vertices found so far.
class Describer {
 public:
  Describer(const ContourQuery& query, const Contour& contour)
      : query_(query),
        contour_(contour),
        view_(ViewOf(query)),
        evaluator_(view_) {
    assert(!contour.is_joined);
  }

  /// The same with VertexEdges, one per vertex.
  ContourInDetail DescribeInDetail() {
    in_detail_ = true;
    ContourInDetail result;
    result.contour = Describe();
    result.edges = std::move(edges_);
    return result;
  }

  VisibleContour Describe() {
    for (const SourceArcs& source : contour_.sources)
      DescribeSource(source);
    CleanUpArcs();
    DropUnusedVertices();
    result_.statistics = contour_.statistics;
    return std::move(result_);
  }

 private:
  void DescribeSource(const SourceArcs& source) {
    const SourceEdges edges(query_, source.facet, in_detail_);
    const FaceNumber face = NumberOf(FaceOf(query_.scene, source.facet));
    for (const Arc& arc : contour_.ArcsOf(source)) {
      ContourArc described;
      described.from = VertexOf(arc.from, edges);
      described.to = VertexOf(arc.to, edges);
      described.source = face.value();
      described.edge_face = arc.edge_face.value();
      const Vec3<Exact> normal = evaluator_.Plane(
          contour_.planes[arc.plane], contour_.explicit_vectors.All());
      const PrimitiveVector plane =
          MakePrimitive(arc.positive ? normal : -normal);
      described.plane_normal = ToDouble(plane);
      arcs_.push_back({described, plane});
    }
  }

  /// Undoes what is the engine's own: split arcs and opposite pairs.
  void CleanUpArcs() {
    std::vector<PrimitiveVector> directions(result_.vertices.size());
    for (const auto& [direction, vertex] : index_) {
      directions[static_cast<std::size_t>(vertex)] = direction;
    }
    arcs_ =
        JoinedArcs(WithoutOppositeArcs(arcs_, directions), result_.vertices);
    for (const ExactArc& a : arcs_)
      result_.arcs.push_back(a.arc);
  }

  void DropUnusedVertices() {
    std::vector<int> new_index(result_.vertices.size(), -1);
    std::vector<ContourVertex> used;
    std::vector<VertexEdges> used_edges;
    const auto renumber = [&](int& vertex) {
      int& index = new_index[static_cast<std::size_t>(vertex)];
      if (index < 0) {
        index = static_cast<int>(used.size());
        used.push_back(result_.vertices[static_cast<std::size_t>(vertex)]);
        used_edges.push_back(
            std::move(edges_[static_cast<std::size_t>(vertex)]));
      }
      vertex = index;
    };
    for (ContourArc& arc : result_.arcs) {
      renumber(arc.from);
      renumber(arc.to);
    }
    result_.vertices = std::move(used);
    edges_ = std::move(used_edges);
  }

  /// The public vertex of a direction. A vertex that bounds several sources
  /// is described by what coincides in front of any of them.
  int VertexOf(DirectionId direction, const SourceEdges& edges) {
    const Vec3<Exact> d =
        evaluator_.Direction(contour_.directions[direction], contour_.planes,
                             contour_.explicit_vectors.All());
    const auto [entry, is_new] = index_.try_emplace(
        MakePrimitive(d), static_cast<int>(result_.vertices.size()));
    const auto index = static_cast<std::size_t>(entry->second);
    if (is_new) {
      result_.vertices.emplace_back();
      coincidences_.emplace_back();
      described_for_.emplace_back();
      edges_.emplace_back();
    }
    if (described_for_[index] == edges.facet()) return entry->second;
    described_for_[index] = edges.facet();
    Coincidence& c = coincidences_[index];
    Collect(edges, d, c, edges_[index]);
    const bool on_horizon =
        SignOf(Dot(evaluator_.ReceiverNormal(), d)) == Sign::kZero;
    ContourVertex& vertex = result_.vertices[index];
    vertex.direction = ToDouble(entry->first);
    c.Describe(on_horizon, vertex);
    return entry->second;
  }

  void Collect(const SourceEdges& edges, const Vec3<Exact>& d, Coincidence& c,
               VertexEdges& of_vertex) {
    const Vec3<Exact> normal = evaluator_.ReceiverNormal();
    for (const EdgeHit& hit : edges.Through(d)) {
      c.Add(hit.plane, hit.vertex, normal);
      if (in_detail_) of_vertex.through.push_back(hit.edge);
    }
    if (!in_detail_) return;
    std::ranges::sort(of_vertex.through);
    of_vertex.through.erase(
        std::unique(of_vertex.through.begin(), of_vertex.through.end()),
        of_vertex.through.end());
    const auto miss = edges.NearestTo(d);
    if (!miss) return;
    if (of_vertex.nearest && of_vertex.nearest_angle <= miss->angle) return;
    of_vertex.nearest = miss->edge;
    of_vertex.nearest_angle = miss->angle;
  }

  const ContourQuery& query_;
  const Contour& contour_;
  ReceiverView view_;
  RecipeEvaluator<Exact> evaluator_;
  VisibleContour result_;
  std::vector<ExactArc> arcs_;
  std::map<PrimitiveVector, int> index_;
  std::vector<Coincidence> coincidences_;  ///< per vertex of the result
  std::vector<FacetId> described_for_;     ///< per vertex: last facet
  std::vector<VertexEdges> edges_;         ///< per vertex; empty if not asked
  bool in_detail_ = false;
};

}  // namespace

VisibleContour DescribeContour(const ContourQuery& query,
                               const Contour& contour) {
  return Describer(query, contour).Describe();
}

ContourInDetail DescribeInDetail(const ContourQuery& query,
                                 const Contour& contour) {
  return Describer(query, contour).DescribeInDetail();
}

}  // namespace truelux
