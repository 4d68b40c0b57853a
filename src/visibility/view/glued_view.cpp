// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/view/glued_view.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <utility>

#include "exact/recipe_evaluator.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

/// A part of the view in one of the charts, numbered over all charts.
using PartId = Id<struct PartTag>;

/// Which parts have been found to be the same.
class Partition {
 public:
  PartId Add() { return parent_.push_back(parent_.end_id()); }

  PartId Root(PartId i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }

  void Unite(PartId i, PartId j) { parent_[Root(i)] = Root(j); }

  [[nodiscard]] std::size_t size() const { return parent_.size(); }

 private:
  IdVector<PartId, PartId> parent_;
};

/// What is on one side of an edge.
struct EdgeSide {
  FacetId facet = kOutside;
  PartId part;
};

/// A piece of a cut between two charts, as one of them has it.
struct CutPiece {
  GluedVertexId from;  ///< the end nearer to the receiver's normal
  GluedVertexId to;
  EdgeSide side;
};

/// The quarter of a great circle from the receiver's normal to the horizon
/// that two charts share.
struct Cut {
  Vec3<Exact> normal;           ///< normal x its end on the horizon
  std::vector<CutPiece> left;   ///< of the chart on the side of `normal`
  std::vector<CutPiece> right;  ///< of the other
};

class Gluing {
 public:
  explicit Gluing(const ContourQuery& query)
      : query_(query), exact_(ViewOf(query)) {}

  void Add(const ChartView& view) {
    const ViewMap& map = view.map;
    part_of_.clear();
    for (int i = 0; i < map.part_count; ++i)
      part_of_.push_back(partition_.Add());
    vertex_of_.clear();
    for (const ImageDirection& d : map.vertices)
      vertex_of_.push_back(VertexOf(view.chart.WorldFromImage(d)));
    for (const MapEdge& edge : map.edges)
      AddMapEdge(view, edge);
  }

  GluedView Finish() {
    for (auto& entry : cuts_)
      JoinCut(entry.second);
    for (GluedVertex& vertex : view_.vertices) {
      std::ranges::sort(vertex.around);
      vertex.around.erase(
          std::unique(vertex.around.begin(), vertex.around.end()),
          vertex.around.end());
    }
    NumberRegions();
    return std::move(view_);
  }

 private:
  GluedVertexId VertexOf(const Vec3<Exact>& direction) {
    PrimitiveVector key = MakePrimitive(direction);
    const auto [entry, is_new] =
        index_.try_emplace(key, view_.vertices.end_id());
    if (is_new) {
      const bool on_horizon = Dot(exact_.ReceiverNormal(), direction).is_zero();
      view_.vertices.push_back({direction, std::move(key), on_horizon, {}});
    }
    return entry->second;
  }

  [[nodiscard]] const Vec3<Exact>& Direction(GluedVertexId vertex) const {
    return view_.vertices[vertex].direction;
  }

  void AddMapEdge(const ChartView& view, const MapEdge& edge) {
    const auto side = [&](FacetId facet, int part) {
      return EdgeSide{facet, part_of_[static_cast<std::size_t>(part)]};
    };
    EdgeSide left = side(edge.left, edge.left_part);
    EdgeSide right = side(edge.right, edge.right_part);
    GluedVertexId from = vertex_of_[edge.from];
    GluedVertexId to = vertex_of_[edge.to];
    if (left.facet == kOutside) {
      std::swap(left, right);
      std::swap(from, to);
    }
    const bool on_wall = right.facet == kOutside;
    if (!on_wall ||
        (view_.vertices[from].on_horizon && view_.vertices[to].on_horizon)) {
      AddArc(from, to, left, right);
    } else {
      AddCutPiece(view, edge, {from, to, left});
    }
  }

  /// piece: with its chart on the left, whichever end is first.
  void AddCutPiece(const ChartView& view, const MapEdge& edge, CutPiece piece) {
    const ViewMap& map = view.map;
    const bool on_a = ViewChart::OnCutA(map.vertices[edge.from]) &&
                      ViewChart::OnCutA(map.vertices[edge.to]);
    const ImageDirection corner{Exact(on_a ? 0 : 1), Exact(on_a ? 1 : 0),
                                Exact(1)};
    const Vec3<Exact> end = view.chart.WorldFromImage(corner);
    Cut& cut = cuts_[MakePrimitive(end)];
    if (cut.left.empty() && cut.right.empty())
      cut.normal = Cross(exact_.ReceiverNormal(), end);
    if (IsBefore(cut, piece.from, piece.to)) {
      cut.left.push_back(piece);
    } else {
      std::swap(piece.from, piece.to);
      cut.right.push_back(piece);
    }
  }

  [[nodiscard]] bool IsBefore(const Cut& cut, GluedVertexId a,
                              GluedVertexId b) const {
    return SignOf(Dot(Cross(Direction(a), Direction(b)), cut.normal)) ==
           Sign::kPositive;
  }

  /// Both charts have pieces all along a cut; where they show different faces
  /// there is a border.
  void JoinCut(Cut& cut) {
    const auto before = [&](const CutPiece& a, const CutPiece& b) {
      return IsBefore(cut, a.from, b.from);
    };
    std::ranges::sort(cut.left, before);
    std::ranges::sort(cut.right, before);
    auto left = cut.left.begin();
    auto right = cut.right.begin();
    GluedVertexId from;
    if (left != cut.left.end()) from = left->from;
    while (left != cut.left.end() && right != cut.right.end()) {
      const bool same_end = left->to == right->to;
      const bool left_first = same_end || IsBefore(cut, left->to, right->to);
      const GluedVertexId to = left_first ? left->to : right->to;
      AddArc(from, to, left->side, right->side);
      from = to;
      if (same_end || !left_first) ++right;
      if (left_first) ++left;
    }
    if (left != cut.left.end() || right != cut.right.end())
      throw std::logic_error("two charts differ in how long their cut is");
  }

  /// Whether two facets are of one face, or none, or both outside.
  [[nodiscard]] bool AreOfOneFace(FacetId a, FacetId b) const {
    if (!a.valid() || !b.valid()) return a == b;
    return FaceOf(query_.scene, a) == FaceOf(query_.scene, b);
  }

  void AddArc(GluedVertexId from, GluedVertexId to, const EdgeSide& left,
              const EdgeSide& right) {
    for (const GluedVertexId vertex : {from, to}) {
      for (const EdgeSide& side : {left, right}) {
        if (side.facet != kOutside)
          view_.vertices[vertex].around.push_back(side.facet);
      }
    }
    if (AreOfOneFace(left.facet, right.facet)) {
      partition_.Unite(left.part, right.part);
      return;
    }
    view_.arcs.push_back({from, to, left.facet, right.facet, {}, {}, from, to});
    arc_parts_.push_back({left.part, right.part});
  }

  /// In the order of the arcs that bound them.
  void NumberRegions() {
    IdVector<PartId, RegionId> region_of(partition_.size());
    const auto number = [&](PartId part) {
      RegionId& region = region_of[partition_.Root(part)];
      if (!region.valid()) region = RegionId(view_.region_count++);
      return region;
    };
    for (const GluedArcId a : view_.arcs.ids()) {
      GluedArc& arc = view_.arcs[a];
      arc.left_region = number(arc_parts_[a].left);
      if (!arc.on_horizon()) arc.right_region = number(arc_parts_[a].right);
    }
  }

  /// The parts on both sides of an arc.
  struct ArcParts {
    PartId left;
    PartId right;
  };

  const ContourQuery& query_;
  RecipeEvaluator<Exact> exact_;
  GluedView view_;
  IdVector<GluedArcId, ArcParts> arc_parts_;
  std::map<PrimitiveVector, GluedVertexId> index_;
  Partition partition_;                  ///< the parts of all charts
  std::map<PrimitiveVector, Cut> cuts_;  ///< by their ends on the horizon
  std::vector<PartId> part_of_;          ///< per part of the chart being added
  /// Of the chart being added.
  IdVector<MapVertexId, GluedVertexId> vertex_of_;
};

}  // namespace

GluedView Glue(const ContourQuery& query, std::span<const ChartView> charts) {
  Gluing gluing(query);
  for (const ChartView& chart : charts)
    gluing.Add(chart);
  return gluing.Finish();
}

}  // namespace truelux
