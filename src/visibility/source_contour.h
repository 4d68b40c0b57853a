// The visible contour of one source from one receiver (method.md, section 4).

#ifndef TRUELUX_VISIBILITY_SOURCE_CONTOUR_H_
#define TRUELUX_VISIBILITY_SOURCE_CONTOUR_H_

#include <vector>

#include "visibility/coverage.h"
#include "visibility/part_bins.h"
#include "visibility/source_parts.h"

namespace truelux {

/// An arc in terms of the view geometry's ids, before it joins a Contour.
struct ViewArc {
  ViewEdge edge;
  VisiblePiece piece;
  int owner = -1;     ///< the piece whose edge it is; -1: the horizon
  int own_edge = -1;  ///< the source's own edge that it lies on, or kNoEdge
};

/// Finds the arcs of a source from its parts.
template <class Geometry>
class SourceContour {
 public:
  /// The arguments must outlive the object.
  SourceContour(const ConvexPieces& pieces, Geometry& geometry,
                ConeMaker<Geometry>& cones, SourceParts<Geometry>& parts);

  /// The arcs that bound what is visible of the source that `parts` holds;
  /// none if nothing is. Valid until the next call.
  const std::vector<ViewArc>& FindArcs();

 private:
  /// A candidate edge; its id is its index.
  struct Candidate {
    int part = -1;  ///< index into the blockers or the sources
    int edge = -1;  ///< of the part's cone
    bool is_blocker = false;
  };

  /// The sides of an edge on which an arc may see the source.
  struct NeededSides {
    bool positive = false;
    bool negative = false;
  };

  Part& OwnerOf(const Candidate& candidate);
  void CollectCandidates();
  void CollectEdges(std::span<Part> parts, bool are_blockers);
  bool IsDiagonal(int edge) const;
  bool IsInner(int edge);
  void Sweep(int id);
  bool SweepParts(const Candidate& candidate, int id);
  bool SweepSource(const Candidate& candidate, int id);
  bool SweepBlocker(Part& part, int id);
  bool TrimBy(const Cover& cover);
  static bool IsOwnedBefore(const Part& part, const Cover& cover, int id);

  const ConvexPieces& pieces_;
  Geometry& geometry_;
  ConeMaker<Geometry>& cones_;
  SourceParts<Geometry>& parts_;
  EdgeSweep<Geometry> sweep_;
  PartBins bins_;
  std::vector<Candidate> candidates_;
  std::vector<ViewArc> arcs_;

  // Of the candidate that is being swept.
  ViewEdge edge_;
  NeededSides needed_;
  Sign source_side_ = Sign::kZero;  ///< where the source is, if one piece
  EdgePosition begin_;              ///< what comes before holds no arc
  EdgePosition end_;                ///< nor what comes after
};

extern template class SourceContour<ViewGeometry>;
extern template class SourceContour<UnfilteredViewGeometry>;

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_SOURCE_CONTOUR_H_
