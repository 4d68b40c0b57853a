// SPDX-License-Identifier: GPL-3.0-or-later
// The visible contour of one source from one receiver (method.md, section 4).
//
// Notation, besides that of cone.h:
//   candidate  an edge of a part, on which arcs of the contour may lie
//   owner      the part whose edges are swept; where candidates coincide, only
//              the one with the least number owns the arcs
//   cover      the interval of a candidate that lies inside a cone
//   diagonal   an edge with the source on both sides: not a candidate

#ifndef TRUELUX_VISIBILITY_EDGES_SOURCE_CONTOUR_H_
#define TRUELUX_VISIBILITY_EDGES_SOURCE_CONTOUR_H_

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "visibility/edges/blocker_parts.h"
#include "visibility/edges/coverage.h"
#include "visibility/edges/open_range.h"
#include "visibility/edges/part_bins.h"
#include "visibility/edges/source_cones.h"
#include "visibility/edges/source_intervals.h"

namespace truelux {

/// An arc in terms of the view geometry's ids, before it joins a Contour.
struct ViewArc {
  ViewEdge edge;
  VisiblePiece piece;
  PieceId owner;    ///< the piece whose edge it is; none: the horizon
  EdgeId own_edge;  ///< the source's edge that it lies on, or none
};

/// Finds the arcs of a source from its cones and its blockers.
template <class Geometry>
class SourceContour {
 public:
  /// The arguments must outlive the object.
  SourceContour(const ConvexPieces& pieces, Geometry& geometry,
                ConeMaker<Geometry>& cones, SourceCones<Geometry>& source,
                BlockerParts<Geometry>& blockers,
                SourceIntervals<Geometry>& intervals);

  /// Appends the arcs that bound what is visible of the source behind its
  /// blockers; none if nothing is visible.
  void AppendArcs(std::vector<ViewArc>& arcs);

 private:
  /// A part whose edges are being swept, and which it is.
  struct Owner {
    Part* part = nullptr;
    std::size_t index = 0;  ///< among the blockers or the sources
    bool is_blocker = false;
  };

  void NumberCandidates();
  void NumberEdges(std::span<Part> parts, bool are_blockers, CandidateId& next);
  bool IsInner(EdgeId edge);
  static bool IsOwnedBefore(const Part& part, const Cover& cover,
                            CandidateId id);

  void SweepPart(const Owner& owner);
  std::uint32_t StartEdges(const Owner& owner);
  void StartBlocker(const Owner& owner);
  bool Hide(const Owner& owner, std::size_t p, std::uint32_t& open);
  void AddArc(const Owner& owner, std::size_t k, const VisiblePiece& piece);

  const ConvexPieces& pieces_;
  Geometry& geometry_;
  ConeMaker<Geometry>& cones_;
  SourceCones<Geometry>& source_;
  BlockerParts<Geometry>& blockers_;
  SourceIntervals<Geometry>& intervals_;  ///< of the edge that is started
  PartBins bins_;
  std::vector<ViewArc>* arcs_ = nullptr;  ///< of the call that is running

  // Of the part that is being swept, per edge of its cone.
  std::array<OpenRanges<Geometry>, Cone::kMaxEdges> ranges_;
  std::array<ViewEdge, Cone::kMaxEdges> edges_{};
  std::array<ImageBox, Cone::kMaxEdges> boxes_;
  std::array<bool, Cone::kMaxEdges> needs_positive_{};
  std::array<BundleSides, Cone::kMaxEdges> sides_;
};

extern template class SourceContour<ViewGeometry>;
extern template class SourceContour<UnfilteredViewGeometry>;
extern template class SourceContour<DisplacedViewGeometry>;

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_EDGES_SOURCE_CONTOUR_H_
