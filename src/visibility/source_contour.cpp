#include "visibility/source_contour.h"

#include <algorithm>

namespace truelux {

SourceContour::SourceContour(const Scene& scene, ViewGeometry& geometry,
                             ConeMaker& cones)
    : triangles_(scene.triangles()),
      facets_(scene.facets()),
      geometry_(geometry),
      cones_(cones),
      sweep_(geometry) {}

bool SourceContour::SetSource(int facet) {
  facet_ = facet;
  sources_.clear();
  blockers_.clear();
  hidden_ = false;
  const Facet& f = facets_[static_cast<std::size_t>(facet)];
  plane_triangle_ = f.first_triangle;
  // r is in front, where N . d < 0: -N points away from r.
  chart_.emplace(-geometry_.TriangleNormalInterval(plane_triangle_));
  for (int t = f.first_triangle; t < f.first_triangle + f.triangle_count; ++t) {
    if (const auto cone = cones_.AboveHorizon(t)) {
      sources_.push_back({*cone, BoxOf(*cone), {}});
    }
  }
  if (sources_.empty()) return false;
  source_box_ = sources_.front().box;
  for (const Part& part : sources_)
    source_box_.Include(part.box);
  return true;
}

ImageBox SourceContour::BoxOf(const Cone& cone) {
  ImageBox box = chart_->Of(geometry_.DirectionInterval(cone.directions[0]));
  for (std::size_t k = 1; k < cone.size; ++k) {
    box.Include(chart_->Of(geometry_.DirectionInterval(cone.directions[k])));
  }
  return box;
}

bool SourceContour::MayMeetSource(const std::array<int, 3>& corners) {
  ImageBox box;
  bool misses = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3<Interval>& d =
        geometry_.DirectionInterval(geometry_.VertexDirection(corners[k]));
    misses = misses && chart_->Misses(d);
    if (k == 0) {
      box = chart_->Of(d);
    } else {
      box.Include(chart_->Of(d));
    }
  }
  return !misses && box.Meets(source_box_);
}

void SourceContour::AddBlocker(int triangle) {
  const Triangle& t = triangles_[static_cast<std::size_t>(triangle)];
  if (hidden_ || t.facet == facet_) return;
  const std::array<int, 3> corners = t.vertices;
  if (std::ranges::none_of(corners, [this](int v) {
        return cones_.HorizonSide(v) == Sign::kPositive;
      })) {
    return;
  }
  if (!MayMeetSource(corners)) return;
  const int own_face = facets_[static_cast<std::size_t>(facet_)].face;
  const int face = facets_[static_cast<std::size_t>(t.facet)].face;
  const auto part =
      cones_.InFrontOf(plane_triangle_, triangle, face < own_face);
  if (!part) return;
  if (std::ranges::all_of(sources_, [&](const Part& source) {
        return Apart(geometry_, source.cone, *part);
      })) {
    return;
  }
  if (std::ranges::all_of(sources_, [&](const Part& source) {
        return Contains(geometry_, *part, source.cone);
      })) {
    hidden_ = true;
    return;
  }
  blockers_.push_back({*part, BoxOf(*part), {}});
}

void SourceContour::AddCandidate(Part& part, std::size_t edge,
                                 bool is_blocker) {
  const Cone& cone = part.cone;
  Candidate candidate{{cone.planes[edge], cone.From(edge), cone.To(edge)},
                      {},
                      &part,
                      is_blocker};
  candidate.box = chart_->Of(geometry_.DirectionInterval(cone.From(edge)));
  candidate.box.Include(chart_->Of(geometry_.DirectionInterval(cone.To(edge))));
  part.candidates[edge] = static_cast<int>(candidates_.size());
  candidates_.push_back(candidate);
}

void SourceContour::CollectSourceEdges() {
  // A diagonal of the facet is no edge where the triangles on both its sides
  // survived the horizon; then its key occurs twice.
  edges_.clear();
  for (std::size_t p = 0; p < sources_.size(); ++p) {
    for (std::size_t k = 0; k < sources_[p].cone.size; ++k) {
      edges_.push_back({sources_[p].cone.keys[k], p, k});
    }
  }
  std::ranges::sort(edges_, {}, &EdgeOfPart::key);
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const EdgeKey key = edges_[i].key;
    const bool diagonal = key != kNoEdgeKey &&
                          ((i > 0 && edges_[i - 1].key == key) ||
                           (i + 1 < edges_.size() && edges_[i + 1].key == key));
    Part& part = sources_[edges_[i].part];
    if (diagonal) {
      part.candidates[edges_[i].edge] = kNoCandidate;
    } else {
      AddCandidate(part, edges_[i].edge, false);
    }
  }
}

bool SourceContour::HasOppositeBlocker(std::span<const EdgeOfPart> group,
                                       const EdgeOfPart& edge) {
  const Cone& own = blockers_[edge.part].cone;
  return std::ranges::any_of(group, [&](const EdgeOfPart& other) {
    if (other.part == edge.part) return false;
    const Cone& cone = blockers_[other.part].cone;
    const Cone& whole = cones_.Whole(cone.triangle);
    // The corner of the other triangle that is not on this edge.
    for (std::size_t k = 0; k < 3; ++k) {
      if (whole.keys[k] != edge.key) continue;
      return geometry_
                 .PlaneSide(own.planes[edge.edge],
                            whole.directions[(k + 2) % 3])
                 .sign == Sign::kNegative;
    }
    return false;
  });
}

void SourceContour::CollectBlockerEdges() {
  edges_.clear();
  for (std::size_t p = 0; p < blockers_.size(); ++p) {
    for (std::size_t k = 0; k < blockers_[p].cone.size; ++k) {
      edges_.push_back({blockers_[p].cone.keys[k], p, k});
    }
  }
  std::ranges::sort(edges_, {}, &EdgeOfPart::key);
  for (std::size_t begin = 0; begin < edges_.size();) {
    std::size_t end = begin + 1;
    while (end < edges_.size() && edges_[end].key == edges_[begin].key)
      ++end;
    const std::span group(edges_.data() + begin, end - begin);
    for (const EdgeOfPart& edge : group) {
      Part& part = blockers_[edge.part];
      if (edge.key != kNoEdgeKey && group.size() > 1 &&
          HasOppositeBlocker(group, edge)) {
        part.candidates[edge.edge] = kNoCandidate;
      } else {
        AddCandidate(part, edge.edge, true);
      }
    }
    begin = end;
  }
}

void SourceContour::CollectCandidates() {
  candidates_.clear();
  CollectSourceEdges();
  CollectBlockerEdges();
}

/// Whether a cover of the edge's own plane belongs to a candidate that owns
/// the arcs there instead of candidate `id`.
bool SourceContour::IsOwnedBefore(const Part& part, const Cover& cover,
                                  int id) {
  if (cover.side == Sign::kZero) return false;
  const int owner = part.candidates[static_cast<std::size_t>(cover.coincident)];
  return owner != kNoCandidate && owner < id;
}

/// Adds the source's triangles to the sweep; tells on which sides of the edge
/// there is any source at all. False if another candidate owns all arcs.
bool SourceContour::SweepSource(const Candidate& candidate, int id,
                                NeededSides& needed) {
  for (const Part& part : sources_) {
    std::optional<Cover> cover;
    if (&part == candidate.owner) {
      // Along its own edge a part holds the inner side of the whole edge.
      cover = Cover{.side = Sign::kPositive};
    } else if (part.box.Meets(candidate.box)) {
      cover = CoverOf(geometry_, candidate.edge, part.cone);
      if (cover && IsOwnedBefore(part, *cover, id)) {
        if (cover->Whole()) return false;
        sweep_.AddOwner(*cover);
      }
    }
    if (!cover) continue;
    sweep_.AddSource(*cover);
    needed.negative = needed.negative || cover->side != Sign::kPositive;
    needed.positive = needed.positive || cover->side != Sign::kNegative;
  }
  return true;
}

/// False if no piece of the edge can be an arc. Left early only when one
/// blocker hides, over the whole edge, every side on which there is source
/// that the edge's own blocker leaves open, or another candidate owns it all.
bool SourceContour::SweepParts(const Candidate& candidate, int id) {
  NeededSides needed;
  if (!SweepSource(candidate, id, needed)) return false;
  if (candidate.is_blocker) {
    sweep_.AddBlocker(Cover{.side = Sign::kPositive});
    needed.positive = false;
  }
  if (!needed.positive && !needed.negative) return false;
  for (const Part& part : blockers_) {
    if (&part == candidate.owner || !part.box.Meets(candidate.box)) continue;
    const auto cover = CoverOf(geometry_, candidate.edge, part.cone);
    if (!cover) continue;
    const bool owned = IsOwnedBefore(part, *cover, id);
    if (cover->Whole()) {
      const bool hides_positive = cover->side != Sign::kNegative;
      const bool hides_negative = cover->side != Sign::kPositive;
      if (owned || ((hides_positive || !needed.positive) &&
                    (hides_negative || !needed.negative))) {
        return false;
      }
    }
    sweep_.AddBlocker(*cover);
    if (owned) sweep_.AddOwner(*cover);
  }
  return true;
}

void SourceContour::Sweep(int id) {
  const Candidate& candidate = candidates_[static_cast<std::size_t>(id)];
  if (!candidate.box.Meets(source_box_)) return;
  sweep_.Start(candidate.edge);
  if (!SweepParts(candidate, id)) return;
  for (const VisiblePiece& piece : sweep_.Finish()) {
    const bool horizon = candidate.edge.plane == cones_.horizon();
    arcs_.push_back(
        {candidate.edge, piece, horizon ? -1 : candidate.owner->cone.triangle});
  }
}

const std::vector<ViewArc>& SourceContour::Arcs() {
  arcs_.clear();
  if (hidden_) return arcs_;
  CollectCandidates();
  for (std::size_t id = 0; id < candidates_.size(); ++id) {
    Sweep(static_cast<int>(id));
  }
  return arcs_;
}

}  // namespace truelux
