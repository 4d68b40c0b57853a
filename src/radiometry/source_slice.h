// SPDX-License-Identifier: GPL-3.0-or-later
// Some sources of a contour as a contour of their own.

#ifndef TRUELUX_RADIOMETRY_SOURCE_SLICE_H_
#define TRUELUX_RADIOMETRY_SOURCE_SLICE_H_

#include <vector>

#include "base/id_vector.h"
#include "base/ids.h"
#include "visibility/contour.h"

namespace truelux {

/// Takes sources out of one contour, a few at a time; all of them together cost
/// as much as the contour is long.
class SourceSlicer {
 public:
  /// The contour must outlive the object, and must not be joined.
  explicit SourceSlicer(const Contour& contour);

  /// Makes `slice`, whose memory is used again, the contour of `count` sources
  /// from `first` on: their arcs, with the planes and directions that these
  /// need. Its statistics are zero.
  void Take(SourceId first, int count, Contour& slice);

 private:
  void AddSource(const SourceArcs& source);
  PlaneId PlaneOf(PlaneId plane);
  DirectionId DirectionOf(DirectionId direction);

  const Contour& contour_;
  Contour* slice_ = nullptr;  ///< of the call that is running
  // Per plane and direction of the contour, its id in the slice, or none.
  IdVector<PlaneId, PlaneId> plane_in_slice_;
  IdVector<DirectionId, DirectionId> direction_in_slice_;
  // Those that the slice has, to be taken back.
  std::vector<PlaneId> planes_;
  std::vector<DirectionId> directions_;
};

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_SOURCE_SLICE_H_
