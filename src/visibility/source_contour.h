// The visible contour of one source from one receiver (method.md, section 4).

#ifndef TRUELUX_VISIBILITY_SOURCE_CONTOUR_H_
#define TRUELUX_VISIBILITY_SOURCE_CONTOUR_H_

#include <span>
#include <vector>

#include "truelux/scene.h"

#include "exact/view_geometry.h"
#include "visibility/cone.h"
#include "visibility/coverage.h"
#include "visibility/image_box.h"

namespace truelux {

/// An arc in terms of the view geometry's ids, before it joins a Contour.
struct ViewArc {
  ViewEdge edge;
  VisiblePiece piece;
  int triangle = -1;  ///< whose edge it is; -1: the horizon
};

/// Finds the visible contour of sources, one after the other. The parts that
/// a source and a blocker play are separate steps, so that the blockers can
/// come from any superset of those that matter.
class SourceContour {
 public:
  /// The arguments must outlive the object.
  SourceContour(const Scene& scene, ViewGeometry& geometry, ConeMaker& cones);

  /// Chooses the source: the union of a facet's triangles, above the horizon.
  /// False if nothing of it is. Requires r strictly in front of the facet.
  bool SetSource(int facet);

  /// Adds a triangle that may block the source. Ignores triangles of the
  /// source itself and those that cannot hide any of it. Requires r not in its
  /// plane.
  void AddBlocker(int triangle);

  /// How many blocker parts there are.
  [[nodiscard]] std::size_t blockers() const { return blockers_.size(); }

  /// Whether one blocker alone certainly hides the whole source.
  [[nodiscard]] bool Hidden() const { return hidden_; }

  /// The arcs that bound what is visible; none if nothing is. Valid until the
  /// next SetSource.
  const std::vector<ViewArc>& Arcs();

 private:
  /// A cone with its box and, per edge, the id of the candidate edge it is;
  /// kNoCandidate for an edge that is left out.
  struct Part {
    Cone cone;
    ImageBox box;
    std::array<int, Cone::kMaxEdges> candidates{};
  };

  /// A candidate edge; its id is its index.
  struct Candidate {
    ViewEdge edge;
    ImageBox box;
    const Part* owner = nullptr;
    bool is_blocker = false;  ///< the owner is a blocker, not the source
  };

  /// One edge of a part, for finding the other side of an inner edge.
  struct EdgeOfPart {
    EdgeKey key = kNoEdgeKey;
    std::size_t part = 0;
    std::size_t edge = 0;
  };

  /// The sides of an edge on which an arc may see the source.
  struct NeededSides {
    bool positive = false;
    bool negative = false;
  };

  static constexpr int kNoCandidate = -1;

  [[nodiscard]] ImageBox BoxOf(const Cone& cone);
  /// False if a triangle certainly shares no direction with the source.
  [[nodiscard]] bool MayMeetSource(const std::array<int, 3>& corners);
  void AddCandidate(Part& part, std::size_t edge, bool is_blocker);
  void CollectCandidates();
  void CollectSourceEdges();
  void CollectBlockerEdges();
  bool HasOppositeBlocker(std::span<const EdgeOfPart> group,
                          const EdgeOfPart& edge);
  void Sweep(int id);
  bool SweepParts(const Candidate& candidate, int id);
  bool SweepSource(const Candidate& candidate, int id, NeededSides& needed);
  static bool IsOwnedBefore(const Part& part, const Cover& cover, int id);

  std::span<const Triangle> triangles_;
  std::span<const Facet> facets_;
  ViewGeometry& geometry_;
  ConeMaker& cones_;
  EdgeSweep sweep_;

  int facet_ = -1;
  int plane_triangle_ = -1;  ///< carries the source's plane
  std::optional<ImageChart> chart_;
  ImageBox source_box_;
  std::vector<Part> sources_;
  std::vector<Part> blockers_;
  std::vector<Candidate> candidates_;
  std::vector<EdgeOfPart> edges_;
  std::vector<ViewArc> arcs_;
  bool hidden_ = false;
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_SOURCE_CONTOUR_H_
