// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/view/edges_at.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <utility>

#include "scene/scene_access.h"

namespace truelux {
namespace {

Vec3<Interval> RoughOf(const Vec3<Exact>& v) {
  return {FromExact<Interval>::Of(v.x), FromExact<Interval>::Of(v.y),
          FromExact<Interval>::Of(v.z)};
}

}  // namespace

EdgesAt::EdgesAt(const EdgeIndex& index, const Vec3<Exact>& d)
    : index_(index),
      d_(d),
      sides_(static_cast<std::size_t>(index.edges().size())) {
  assert(!IsZero(d));
  FindSides();
  FindTriangles();
}

/// Sets the sides that intervals know, and asks for the others exactly: those
/// are few, and the edges through d are among them.
void EdgesAt::FindSides() {
  std::vector<SceneEdgeId> open;
  const Vec3<Interval> rough = RoughOf(d_);
  {
    const RoundUpward rounding;
    for (const SceneEdgeId e : index_.edges()) {
      const auto sign = TrySign(Dot(index_.RoughPlane(e), rough));
      if (sign && *sign != Sign::kZero) {
        sides_[e] = *sign;
      } else {
        open.push_back(e);
      }
    }
  }
  const RecipeEvaluator<Exact>& exact = index_.exact();
  for (const SceneEdgeId e : open) {
    const Segment segment = index_.SegmentOf(e);
    sides_[e] = SignOf(Determinant(exact.FromReceiver(segment.a),
                                   exact.FromReceiver(segment.b), d_));
    if (sides_[e] != Sign::kZero) continue;
    auto passing = Pass(segment);
    if (!passing) continue;
    passing->edge = e;
    passing_.push_back(*std::move(passing));
  }
}

void EdgesAt::FindTriangles() {
  for (const TriangleId t : index_.triangles()) {
    const bool holds =
        std::ranges::all_of(index_.EdgesOf(t), [this](const TriangleEdge& own) {
          return sides_[own.edge] * own.side != Sign::kNegative;
        });
    if (holds) triangles_.push_back(t);
  }
}

std::optional<EdgesAt::Passing> EdgesAt::Pass(const Segment& segment) const {
  const RecipeEvaluator<Exact>& exact = index_.exact();
  auto point = PointOnArc(exact.Direction(segment.from, {}, {}),
                          exact.Direction(segment.to, {}, {}), d_);
  if (!point) return std::nullopt;
  return Passing{{}, segment, *std::move(point)};
}

EdgeHit EdgesAt::HitOf(const Passing& passing) {
  const Segment& segment = passing.segment;
  VertexId vertex;
  if (passing.point.IsFrom()) vertex = segment.a;
  if (passing.point.IsTo()) vertex = segment.b;
  return {passing.point.plane, vertex, segment.edge};
}

std::vector<EdgeHit> EdgesAt::OfSource(FacetId facet) const {
  const FacetFront source(index_.query(), facet);
  std::vector<EdgeHit> hits;
  for (const Passing& passing : passing_) {
    if (index_.CouldBound(passing.edge, source) &&
        !source.IsBehind(passing.segment, passing.point)) {
      hits.push_back(HitOf(passing));
    }
  }
  for (const TriangleId t : triangles_) {
    const auto cut = index_.CutOf(t, source);
    const auto passing = cut ? Pass(*cut) : std::nullopt;
    if (passing) hits.push_back(HitOf(*passing));
  }
  return hits;
}

std::vector<EdgeHit> EdgesAt::NotBehind(FacetId facet) const {
  std::optional<FacetFront> front;
  if (facet.valid()) front.emplace(index_.query(), facet);
  std::vector<EdgeHit> hits;
  for (const Passing& passing : passing_) {
    if (index_.IsDiagonal(passing.edge)) continue;
    if (!front || !front->IsBehind(passing.segment, passing.point))
      hits.push_back(HitOf(passing));
  }
  AddMeetings(facet, hits);
  return hits;
}

/// Adds the lines where two faces meet that are no edges of the scene.
void EdgesAt::AddMeetings(FacetId facet, std::vector<EdgeHit>& hits) const {
  const auto is_edge = [this](const EdgeHit& meeting) {
    return std::ranges::any_of(passing_, [&meeting](const Passing& p) {
      return IsZero(Cross(p.point.plane, meeting.plane));
    });
  };
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const FacetId own = index_.FacetOf(triangles_[i]);
    const bool is_behind = facet.valid() && own != facet &&
                           index_.DepthOrder(own, facet, d_) == Sign::kPositive;
    if (is_behind) continue;
    for (std::size_t j = i + 1; j < triangles_.size(); ++j) {
      auto meeting = MeetingOf(triangles_[i], triangles_[j]);
      if (meeting && !is_edge(*meeting)) hits.push_back(*std::move(meeting));
    }
  }
}

/// Whether a scene vertex lies in the direction.
bool EdgesAt::IsVertex(VertexId vertex) const {
  const Vec3<Exact> v = index_.exact().FromReceiver(vertex);
  return IsZero(Cross(v, d_)) && SignOf(Dot(v, d_)) == Sign::kPositive;
}

EdgesAt::Reach EdgesAt::ReachOf(TriangleId triangle,
                                const Vec3<Exact>& plane) const {
  const auto corners = CornersOf(TrianglesOf(index_.query().scene)[triangle]);
  std::array<Vec3<Exact>, 3> at;
  std::array<Exact, 3> side;
  for (std::size_t k = 0; k < 3; ++k) {
    at[k] = index_.exact().FromReceiver(corners[k]);
    side[k] = Dot(plane, at[k]);
  }
  Reach reach;
  const auto add_end = [&](const Vec3<Exact>& end) {
    const Sign turn = SignOf(Dot(Cross(d_, end), plane));
    reach.back = reach.back || turn == Sign::kNegative;
    reach.on = reach.on || turn == Sign::kPositive;
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (side[k].is_zero()) {
      add_end(at[k]);
      if (IsVertex(corners[k])) reach.vertex = corners[k];
    } else if (SignOf(side[k]) * SignOf(side[next]) == Sign::kNegative) {
      const Vec3<Exact> end = side[k] * at[next] - side[next] * at[k];
      add_end(SignOf(side[k]) == Sign::kPositive ? end : -end);
    }
  }
  return reach;
}

/// The segment in which two triangles cross, if d is on it.
std::optional<EdgeHit> EdgesAt::MeetingOf(TriangleId s, TriangleId t) const {
  const FacetId own = index_.FacetOf(s);
  const FacetId other = index_.FacetOf(t);
  const int face = index_.FaceNumber(own);
  const int other_face = index_.FaceNumber(other);
  if (face == other_face) return std::nullopt;
  const auto triangles = TrianglesOf(index_.query().scene);
  const auto v = CornersOf(triangles[s]);
  const auto w = CornersOf(triangles[t]);
  const auto shared = std::ranges::count_if(
      v, [&w](VertexId i) { return std::ranges::find(w, i) != w.end(); });
  if (shared > 1) return std::nullopt;
  if (index_.DepthOrder(own, other, d_) != Sign::kZero) return std::nullopt;
  const Vec3<Exact> plane = index_.MeetingPlane(own, other);
  if (IsZero(plane)) return std::nullopt;
  // The segment is where the parts of both triangles overlap. It is more than
  // a point if both parts lead from d to the same side.
  const Reach a = ReachOf(s, plane);
  const Reach b = ReachOf(t, plane);
  const bool goes_back = a.back && b.back;
  const bool goes_on = a.on && b.on;
  if (!goes_back && !goes_on) return std::nullopt;
  const VertexId corner = b.vertex.valid() ? b.vertex : a.vertex;
  return EdgeHit{
      plane, goes_back && goes_on ? VertexId() : corner,
      SeenEdge{std::min(face, other_face), -1, -1, std::max(face, other_face)}};
}

}  // namespace truelux
