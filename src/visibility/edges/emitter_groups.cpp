// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/edges/emitter_groups.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/disjoint_sets.h"
#include "base/id_vector.h"
#include "exact/number.h"
#include "scene/coplanar_overlap.h"
#include "scene/emitters.h"
#include "scene/index/box_overlap.h"
#include "scene/index/triangle_tree.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

class Grouping {
 public:
  Grouping(const Scene& scene, const ConvexPieces& pieces)
      : scene_(scene), pieces_(pieces), connected_(scene.facets().size()) {}

  std::vector<EmitterGroup> Find() {
    Connect();
    FindMembers();
    if (members_.empty()) return {};
    FindOverlapping();
    std::vector<std::vector<FacetId>> groups;
    IdVector<FacetId, int> index(scene_.facets().size(), -1);
    for (const FacetId facet : members_) {
      if (overlaps_[facet]) continue;
      int& group = index[connected_.LeastOf(facet)];
      if (group < 0) {
        group = static_cast<int>(groups.size());
        groups.emplace_back();
      }
      groups[static_cast<std::size_t>(group)].push_back(facet);
    }
    std::vector<EmitterGroup> found;
    for (std::vector<FacetId>& group : groups) {
      if (group.size() > 1) found.push_back(Sorted(std::move(group)));
    }
    return found;
  }

 private:
  [[nodiscard]] EmitterGroup Sorted(std::vector<FacetId> facets) const {
    const auto emission = [this](FacetId f) { return FaceOfFacet(f).emission; };
    std::ranges::sort(facets, [&](FacetId a, FacetId b) {
      return std::pair(emission(a), a) < std::pair(emission(b), b);
    });
    EmitterGroup group{std::move(facets), {}};
    for (std::size_t i = 1; i <= group.facets.size(); ++i) {
      if (i == group.facets.size() ||
          emission(group.facets[i]) != emission(group.facets[i - 1])) {
        group.alike_ends.push_back(i);
      }
    }
    return group;
  }

  [[nodiscard]] const Face& FaceOfFacet(FacetId facet) const {
    return FacesOf(scene_)[FaceOf(scene_, facet)];
  }

  [[nodiscard]] bool AreInOnePlane(FacetId a, FacetId b) const {
    return pieces_.FirstInPlaneOf(a) == pieces_.FirstInPlaneOf(b) &&
           FacetsOf(scene_)[a].is_back == FacetsOf(scene_)[b].is_back;
  }

  /// Joins facets that emit and look to the same side through their common
  /// edges.
  void Connect() {
    const auto corners = pieces_.corners();
    const RoundUpward rounding;
    std::vector<Point3> own;
    std::vector<Point3> others;
    for (const EdgeId edge : corners.ids()) {
      const FacetId facet = pieces_.pieces()[pieces_.PieceOf(edge)].facet;
      if (!Emits(FaceOfFacet(facet))) continue;
      // One other edge is enough: groups only save time, and of an edge with
      // thousands of pieces not all pairs may be looked at.
      const EdgeId other = pieces_.NextSameEdge(edge);
      if (corners[other] == corners[edge]) continue;
      const FacetId next = pieces_.pieces()[pieces_.PieceOf(other)].facet;
      if (next == facet || !Emits(FaceOfFacet(next)) ||
          !AreInOnePlane(facet, next)) {
        continue;
      }
      if (connected_.LeastOf(facet) == connected_.LeastOf(next)) continue;
      SetCorners(pieces_.PieceOf(edge), own);
      SetCorners(pieces_.PieceOf(other), others);
      if (LookAlike(own, others)) connected_.Join(facet, next);
    }
  }

  /// The facets that have been joined with others.
  void FindMembers() {
    std::vector<FacetId> emitting;
    IdVector<FacetId, int> sizes(scene_.facets().size());
    for (const FacetId facet : FacetsOf(scene_).ids()) {
      if (!Emits(FaceOfFacet(facet))) continue;
      emitting.push_back(facet);
      ++sizes[connected_.LeastOf(facet)];
    }
    for (const FacetId facet : emitting) {
      if (sizes[connected_.LeastOf(facet)] > 1) members_.push_back(facet);
    }
  }

  /// Finds the members that overlap any facet that emits, or that did before
  /// the scene was varied.
  void FindOverlapping() {
    overlaps_ = IdVector<FacetId, bool>(scene_.facets().size());
    std::vector<PieceId> emitting;
    std::vector<Box> boxes;
    for (const PieceId piece : pieces_.pieces().ids()) {
      const Face& face = FaceOfFacet(pieces_.pieces()[piece].facet);
      if (!face.is_emitter && !Emits(face)) continue;
      emitting.push_back(piece);
      Box& box = boxes.emplace_back();
      for (const VertexId vertex : pieces_.CornersOf(piece))
        box.Include(VerticesOf(scene_)[vertex]);
    }
    const TriangleTree tree(boxes);
    const RoundUpward rounding;
    std::vector<Point3> own;
    std::vector<Point3> others;
    for (const FacetId facet : members_) {
      for (const PieceId piece : pieces_.PiecesOf(facet)) {
        Box box;
        SetCorners(piece, own);
        for (const Point3& p : own)
          box.Include(p);
        BoxOverlap region(box);
        tree.Visit(region, [&](int index) {
          const PieceId other = emitting[static_cast<std::size_t>(index)];
          // A facet does not overlap itself.
          const bool is_own = pieces_.pieces()[other].facet == facet;
          if (overlaps_[facet] || is_own) return;
          SetCorners(other, others);
          if (!OverlapInPlane(own, others)) return;
          overlaps_[facet] = true;
          region = BoxOverlap(Box());  // nothing more to be found
        });
      }
    }
  }

  void SetCorners(PieceId piece, std::vector<Point3>& corners) const {
    corners.clear();
    for (const VertexId vertex : pieces_.CornersOf(piece))
      corners.push_back(VerticesOf(scene_)[vertex]);
  }

  const Scene& scene_;
  const ConvexPieces& pieces_;
  DisjointSets<FacetId> connected_;
  std::vector<FacetId> members_;
  IdVector<FacetId, bool> overlaps_;
};

}  // namespace

std::vector<EmitterGroup> EmitterGroupsOf(const Scene& scene,
                                          const ConvexPieces& pieces) {
  return Grouping(scene, pieces).Find();
}

}  // namespace truelux
