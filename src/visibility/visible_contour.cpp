#include "visibility/visible_contour.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "exact/primitive.h"
#include "visibility/view_edges.h"

namespace truelux {
namespace {

/// What coincides in the direction of one vertex.
struct Coincidence {
  std::set<PrimitiveVector> planes;  ///< of edges, without sign
  std::set<int> vertices;            ///< scene vertices exactly there
  bool passed = false;  ///< an edge passes that does not end at such a vertex
};

/// Several of: scene vertex, crossing of edges, horizon point. A scene vertex
/// explains all edges that end there; two planes make one crossing.
bool IsConjunctive(const Coincidence& c, bool on_horizon) {
  const std::size_t edges = c.planes.size();
  if (on_horizon) return !c.vertices.empty() || edges > 1;
  if (c.vertices.size() > 1) return true;
  return c.vertices.empty() ? edges > 2 : c.passed;
}

/// Describes one contour; keeps the vertices found so far.
class Describer {
 public:
  Describer(const ContourQuery& query, const Contour& contour)
      : query_(query),
        contour_(contour),
        view_(ViewOf(query)),
        evaluator_(view_) {}

  VisibleContour Describe() {
    for (const SourceArcs& source : contour_.sources)
      DescribeSource(source);
    JoinArcs();
    DropUnusedVertices();
    result_.statistics = contour_.statistics;
    return std::move(result_);
  }

 private:
  void DescribeSource(const SourceArcs& source) {
    const ViewEdges edges(query_, source.facet);
    const int face =
        query_.scene.facets()[static_cast<std::size_t>(source.facet)].face;
    for (int a = source.first_arc; a < source.first_arc + source.arc_count;
         ++a) {
      const Arc& arc = contour_.arcs[static_cast<std::size_t>(a)];
      ContourArc described;
      described.from = VertexOf(arc.from, edges);
      described.to = VertexOf(arc.to, edges);
      described.source = face + 1;
      described.edge_face = arc.edge_face;
      const Vec3<Exact> normal =
          evaluator_.Plane(contour_.planes[static_cast<std::size_t>(arc.plane)],
                           contour_.explicit_vectors);
      planes_.push_back(MakePrimitive(arc.positive ? normal : -normal));
      described.plane_normal = ToDouble(planes_.back());
      result_.arcs.push_back(described);
    }
  }

  /// Joins two arcs where nothing but they meet and one goes on as the other:
  /// an engine may split an arc anywhere. Arcs of equal opposite planes (the
  /// arrangement's cuts) are left as they are.
  void JoinArcs() {
    const std::size_t count = result_.vertices.size();
    std::vector<std::vector<std::size_t>> arriving(count);
    std::vector<std::vector<std::size_t>> leaving(count);
    for (std::size_t a = 0; a < result_.arcs.size(); ++a) {
      leaving[static_cast<std::size_t>(result_.arcs[a].from)].push_back(a);
      arriving[static_cast<std::size_t>(result_.arcs[a].to)].push_back(a);
    }
    std::vector<bool> gone(result_.arcs.size(), false);
    for (std::size_t v = 0; v < count; ++v) {
      if (result_.vertices[v].kind == VertexKind::kIntrinsic ||
          arriving[v].size() != 1 || leaving[v].size() != 1) {
        continue;
      }
      const std::size_t first = arriving[v][0];
      const std::size_t second = leaving[v][0];
      if (first == second ||
          result_.arcs[first].source != result_.arcs[second].source ||
          planes_[first] != planes_[second]) {
        continue;
      }
      const int end = result_.arcs[second].to;
      result_.arcs[first].to = end;
      gone[second] = true;
      auto& into_end = arriving[static_cast<std::size_t>(end)];
      *std::ranges::find(into_end, second) = first;
    }
    std::size_t kept = 0;
    for (std::size_t a = 0; a < gone.size(); ++a) {
      if (!gone[a]) result_.arcs[kept++] = result_.arcs[a];
    }
    result_.arcs.resize(kept);
  }

  void DropUnusedVertices() {
    std::vector<int> new_index(result_.vertices.size(), -1);
    std::vector<ContourVertex> used;
    const auto renumber = [&](int& vertex) {
      int& index = new_index[static_cast<std::size_t>(vertex)];
      if (index < 0) {
        index = static_cast<int>(used.size());
        used.push_back(result_.vertices[static_cast<std::size_t>(vertex)]);
      }
      vertex = index;
    };
    for (ContourArc& arc : result_.arcs) {
      renumber(arc.from);
      renumber(arc.to);
    }
    result_.vertices = std::move(used);
  }

  /// The public vertex of a direction. A vertex that bounds several sources
  /// is described by what coincides in front of any of them.
  int VertexOf(int direction, const ViewEdges& edges) {
    const Vec3<Exact> d = evaluator_.Direction(
        contour_.directions[static_cast<std::size_t>(direction)],
        contour_.planes, contour_.explicit_vectors);
    const auto [entry, is_new] = index_.try_emplace(
        MakePrimitive(d), static_cast<int>(result_.vertices.size()));
    const auto index = static_cast<std::size_t>(entry->second);
    if (is_new) {
      result_.vertices.emplace_back();
      coincidences_.emplace_back();
      described_for_.push_back(-1);
    }
    if (described_for_[index] == edges.facet()) return entry->second;
    described_for_[index] = edges.facet();
    Coincidence& c = coincidences_[index];
    Collect(edges, d, c);
    const bool on_horizon =
        SignOf(Dot(evaluator_.ReceiverNormal(), d)) == Sign::kZero;
    ContourVertex& vertex = result_.vertices[index];
    vertex.direction = ToDouble(entry->first);
    vertex.conjunctive = IsConjunctive(c, on_horizon);
    vertex.planes = static_cast<int>(c.planes.size()) + (on_horizon ? 1 : 0);
    if (!c.vertices.empty()) {
      vertex.kind = VertexKind::kIntrinsic;
      vertex.vertex = *c.vertices.begin();
    } else if (on_horizon) {
      vertex.kind = VertexKind::kHorizon;
    }
    return entry->second;
  }

  void Collect(const ViewEdges& edges, const Vec3<Exact>& d, Coincidence& c) {
    const Vec3<Exact> normal = evaluator_.ReceiverNormal();
    for (const ViewEdges::Hit& hit : edges.Through(d)) {
      const bool is_horizon =
          SignOf(Dot(Cross(hit.plane, normal), Cross(hit.plane, normal))) ==
          Sign::kZero;
      if (!is_horizon) c.planes.insert(WithoutSign(MakePrimitive(hit.plane)));
      if (hit.vertex >= 0) {
        c.vertices.insert(hit.vertex);
      } else {
        c.passed = true;
      }
    }
  }

  const ContourQuery& query_;
  const Contour& contour_;
  ReceiverView view_;
  RecipeEvaluator<Exact> evaluator_;
  VisibleContour result_;
  std::vector<PrimitiveVector> planes_;  ///< per arc of the result
  std::map<PrimitiveVector, int> index_;
  std::vector<Coincidence> coincidences_;  ///< per vertex of the result
  std::vector<int> described_for_;         ///< per vertex: last facet
};

}  // namespace

VisibleContour DescribeContour(const ContourQuery& query,
                               const Contour& contour) {
  return Describer(query, contour).Describe();
}

}  // namespace truelux
