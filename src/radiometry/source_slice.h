// Some sources of a contour as a contour of their own.

#ifndef TRUELUX_RADIOMETRY_SOURCE_SLICE_H_
#define TRUELUX_RADIOMETRY_SOURCE_SLICE_H_

#include <cstddef>
#include <vector>

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
  void Take(std::size_t first, std::size_t count, Contour& slice);

 private:
  void AddSource(const SourceArcs& source);
  int PlaneIndex(int plane);
  int DirectionIndex(int direction);

  const Contour& contour_;
  Contour* slice_ = nullptr;  ///< of the call that is running
  // Per plane and direction of the contour, its index in the slice, or -1.
  std::vector<int> plane_index_;
  std::vector<int> direction_index_;
  // Those that the slice has, to be taken back.
  std::vector<int> planes_;
  std::vector<int> directions_;
};

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_SOURCE_SLICE_H_
