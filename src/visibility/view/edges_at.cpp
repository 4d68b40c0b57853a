// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/view/edges_at.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <utility>

namespace truelux {
namespace {

std::size_t Index(int i) {
  return static_cast<std::size_t>(i);
}

Vec3<Interval> RoughOf(const Vec3<Exact>& v) {
  return {FromExact<Interval>::Of(v.x), FromExact<Interval>::Of(v.y),
          FromExact<Interval>::Of(v.z)};
}

}  // namespace

EdgesAt::EdgesAt(const EdgeIndex& index, const Vec3<Exact>& d)
    : index_(index), d_(d), sides_(Index(index.edge_count())) {
  assert(!IsZero(d));
  FindSides();
  FindTriangles();
}

/// Sets the sides that intervals know, and asks for the others exactly: those
/// are few, and the edges through d are among them.
void EdgesAt::FindSides() {
  std::vector<int> open;
  const Vec3<Interval> rough = RoughOf(d_);
  {
    const RoundUpward rounding;
    for (int e = 0; e < index_.edge_count(); ++e) {
      const auto sign = TrySign(Dot(index_.RoughPlane(e), rough));
      if (sign && *sign != Sign::kZero) {
        sides_[Index(e)] = *sign;
      } else {
        open.push_back(e);
      }
    }
  }
  const RecipeEvaluator<Exact>& exact = index_.exact();
  for (const int e : open) {
    const Segment segment = index_.SegmentOf(e);
    sides_[Index(e)] =
        SignOf(Determinant(exact.FromReceiver(VertexId(segment.a)),
                           exact.FromReceiver(VertexId(segment.b)), d_));
    if (sides_[Index(e)] != Sign::kZero) continue;
    auto passing = Pass(segment);
    if (!passing) continue;
    passing->edge = e;
    passing_.push_back(*std::move(passing));
  }
}

void EdgesAt::FindTriangles() {
  for (const int t : index_.triangles()) {
    const bool holds =
        std::ranges::all_of(index_.EdgesOf(t), [this](const TriangleEdge& own) {
          return sides_[Index(own.edge)] * own.side != Sign::kNegative;
        });
    if (holds) triangles_.push_back(t);
  }
}

std::optional<EdgesAt::Passing> EdgesAt::Pass(const Segment& segment) const {
  const RecipeEvaluator<Exact>& exact = index_.exact();
  auto point = PointOnArc(exact.Direction(segment.from, {}, {}),
                          exact.Direction(segment.to, {}, {}), d_);
  if (!point) return std::nullopt;
  return Passing{-1, segment, *std::move(point)};
}

EdgeHit EdgesAt::HitOf(const Passing& passing) {
  const Segment& segment = passing.segment;
  int vertex = -1;
  if (passing.point.IsFrom()) vertex = segment.a;
  if (passing.point.IsTo()) vertex = segment.b;
  return {passing.point.plane, vertex, segment.edge};
}

std::vector<EdgeHit> EdgesAt::OfSource(int facet) const {
  const FacetFront source(index_.query(), facet);
  std::vector<EdgeHit> hits;
  for (const Passing& passing : passing_) {
    if (index_.CouldBound(passing.edge, source) &&
        !source.IsBehind(passing.segment, passing.point)) {
      hits.push_back(HitOf(passing));
    }
  }
  for (const int t : triangles_) {
    const auto cut = index_.CutOf(t, source);
    const auto passing = cut ? Pass(*cut) : std::nullopt;
    if (passing) hits.push_back(HitOf(*passing));
  }
  return hits;
}

std::vector<EdgeHit> EdgesAt::NotBehind(int facet) const {
  std::optional<FacetFront> front;
  if (facet >= 0) front.emplace(index_.query(), facet);
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
void EdgesAt::AddMeetings(int facet, std::vector<EdgeHit>& hits) const {
  const auto is_edge = [this](const EdgeHit& meeting) {
    return std::ranges::any_of(passing_, [&meeting](const Passing& p) {
      return IsZero(Cross(p.point.plane, meeting.plane));
    });
  };
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const int own = index_.FacetOf(triangles_[i]);
    const bool is_behind = facet >= 0 && own != facet &&
                           index_.DepthOrder(own, facet, d_) == Sign::kPositive;
    if (is_behind) continue;
    for (std::size_t j = i + 1; j < triangles_.size(); ++j) {
      auto meeting = MeetingOf(triangles_[i], triangles_[j]);
      if (meeting && !is_edge(*meeting)) hits.push_back(*std::move(meeting));
    }
  }
}

/// Whether a scene vertex lies in the direction.
bool EdgesAt::IsVertex(int vertex) const {
  const Vec3<Exact> v = index_.exact().FromReceiver(VertexId(vertex));
  return IsZero(Cross(v, d_)) && SignOf(Dot(v, d_)) == Sign::kPositive;
}

EdgesAt::Reach EdgesAt::ReachOf(int triangle, const Vec3<Exact>& plane) const {
  const auto& corners =
      index_.query().scene.triangles()[Index(triangle)].vertices;
  std::array<Vec3<Exact>, 3> at;
  std::array<Exact, 3> side;
  for (std::size_t k = 0; k < 3; ++k) {
    at[k] = index_.exact().FromReceiver(VertexId(corners[k]));
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
std::optional<EdgeHit> EdgesAt::MeetingOf(int s, int t) const {
  const int own = index_.FacetOf(s);
  const int other = index_.FacetOf(t);
  const int face = index_.FaceNumber(own);
  const int other_face = index_.FaceNumber(other);
  if (face == other_face) return std::nullopt;
  const auto triangles = index_.query().scene.triangles();
  const auto& v = triangles[Index(s)].vertices;
  const auto& w = triangles[Index(t)].vertices;
  const auto shared = std::ranges::count_if(
      v, [&w](int i) { return std::ranges::find(w, i) != w.end(); });
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
  const int corner = b.vertex >= 0 ? b.vertex : a.vertex;
  return EdgeHit{
      plane, goes_back && goes_on ? -1 : corner,
      SeenEdge{std::min(face, other_face), -1, -1, std::max(face, other_face)}};
}

}  // namespace truelux
