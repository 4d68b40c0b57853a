// SPDX-License-Identifier: GPL-3.0-or-later
// The outline of a source of several cones, and what of an edge lies inside it
// (method.md, section 4).

#ifndef TRUELUX_VISIBILITY_EDGES_SOURCE_OUTLINE_H_
#define TRUELUX_VISIBILITY_EDGES_SOURCE_OUTLINE_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/stamped_table.h"
#include "visibility/edges/cone.h"
#include "visibility/edges/coverage.h"
#include "visibility/edges/image_box.h"
#include "visibility/edges/part_bins.h"
#include "visibility/edges/source_cones.h"

namespace truelux {

/// An interval of an edge, not empty.
struct EdgeInterval {
  EdgePosition begin;
  EdgePosition end;
};

/// The edges of a source that are no diagonals. Along an edge that touches none
/// of their ends, and whose own ends lie on none of them, what is inside the
/// source begins and ends where the edge crosses them: the cones need not be
/// asked one by one. Allocates nothing in the steady state.
template <class Geometry>
class SourceOutline {
 public:
  /// The arguments must outlive the object.
  SourceOutline(Geometry& geometry, ConeMaker<Geometry>& cones,
                SourceCones<Geometry>& source)
      : geometry_(geometry), cones_(cones), source_(source) {}

  /// Starts with the source that has been set or narrowed.
  void SetSource();

  /// Calls visit(Cone&) -> bool for the source's cones whose boxes meet a box, as
  /// long as it returns true.
  template <class Visit>
  void ForEachConeNear(const ImageBox& box, const Visit& visit) {
    cone_bins_.ForEach(box, [&](std::size_t s) {
      return !source_.boxes()[s].Meets(box) || visit(source_.parts()[s].cone);
    });
  }

  /// Appends the intervals of an edge inside the source, in order. box: the
  /// edge's. False, and nothing said by what was appended, where the edge and
  /// the outline touch.
  bool Clip(const ViewEdge& edge, const ImageBox& box,
            std::vector<EdgeInterval>& intervals);

 private:
  /// Where a direction is to the source.
  enum class Place : std::uint8_t { kUnknown, kInside, kOutside };

  /// Where the outline crosses the edge.
  struct Passage {
    EdgePosition at;
    bool enters = false;  ///< the edge enters the source
  };

  bool FindPassages(const ViewEdge& edge, const ImageBox& box);
  Place PlaceOf(ViewDirectionId direction);
  Place FindPlace(ViewDirectionId direction);

  Geometry& geometry_;
  ConeMaker<Geometry>& cones_;
  SourceCones<Geometry>& source_;
  std::vector<ViewEdge> edges_;
  std::vector<ImageBox> boxes_;  ///< of edges_
  PartBins bins_;                ///< of boxes_
  PartBins cone_bins_;           ///< of the source's
  std::vector<Passage> passages_;
  StampedTable<Place, ViewDirectionId> places_;
};

extern template class SourceOutline<ViewGeometry>;
extern template class SourceOutline<UnfilteredViewGeometry>;
extern template class SourceOutline<DisplacedViewGeometry>;

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_EDGES_SOURCE_OUTLINE_H_
