// SPDX-License-Identifier: GPL-3.0-or-later
// The edge that all but passes through a direction.

#ifndef TRUELUX_VISIBILITY_VIEW_NEAREST_EDGE_H_
#define TRUELUX_VISIBILITY_VIEW_NEAREST_EDGE_H_

#include <optional>
#include <vector>

#include "visibility/view/edge_index.h"

namespace truelux {

/// An edge that passes a direction by, and the angle in between [rad], > 0.
struct EdgeMiss {
  SeenEdge edge;
  double angle = 0;
};

/// The segments that could bound one source, by their distance from directions.
class NearestEdge {
 public:
  /// Edges are those of the index that could bound the source, and its cuts.
  /// The arguments must outlive the object.
  NearestEdge(const EdgeIndex& index, const FacetFront& source);

  /// Of the segments that do not pass through a direction d to the source, the
  /// nearest one; nothing if there is none. That a segment misses d is exact;
  /// the angle is good to a few digits, except:
  /// - A segment that passes through d only behind the source's plane is
  ///   measured to its ends.
  /// - A segment that misses d by less than 1e-15, the rounding of directions
  ///   of length 1, may be passed over.
  /// - The angle to a segment that is all but seen end on, or that all but
  ///   passes through r, is not known.
  [[nodiscard]] std::optional<EdgeMiss> To(const Vec3<Exact>& d) const;

 private:
  /// A segment, and its ends at length 1, rounded.
  struct Candidate {
    Segment segment;
    Vec3<double> from;
    Vec3<double> to;
    double length = 0;  ///< the angle between these two
  };

  void Add(const Segment& segment);
  [[nodiscard]] bool Passes(const Segment& segment, const Vec3<Exact>& d) const;
  [[nodiscard]] double CloseAngle(const Candidate& candidate,
                                  const Vec3<Exact>& d,
                                  const Vec3<double>& unit, double angle) const;

  const FacetFront& source_;
  RecipeEvaluator<Exact> exact_;
  RecipeEvaluator<Interval> interval_;
  std::vector<Candidate> candidates_;
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_VIEW_NEAREST_EDGE_H_
