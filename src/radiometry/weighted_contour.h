// The input of every evaluation stage: a visible contour, what its recipes
// refer to, and what each source emits.

#ifndef TRUELUX_RADIOMETRY_WEIGHTED_CONTOUR_H_
#define TRUELUX_RADIOMETRY_WEIGHTED_CONTOUR_H_

#include <span>
#include <vector>

#include "truelux/geometry.h"

#include "visibility/contour.h"

namespace truelux {

/// Refers to its parts, which must outlive it.
struct WeightedContour {
  ReceiverView view;
  const Contour& contour;
  /// One entry per entry of contour.sources: M [W/m^2], or L [W/m^2/sr] with
  /// Emission::kRadiance; finite and not negative.
  std::span<const Rgb> weights;

  [[nodiscard]] std::span<const Arc> ArcsOf(const SourceArcs& source) const {
    return std::span(contour.arcs)
        .subspan(static_cast<std::size_t>(source.first_arc),
                 static_cast<std::size_t>(source.arc_count));
  }

  /// Whether source i has arcs and emits in some channel.
  [[nodiscard]] bool IsLit(std::size_t i) const;

  /// Whether any source has arcs and emits in this channel; E is exactly 0 in
  /// the others.
  [[nodiscard]] bool IsLit(std::size_t i, std::size_t channel) const {
    return contour.sources[i].arc_count > 0 && weights[i][channel] > 0;
  }
};

/// For each plane of the contour whether it is exactly the receiver plane,
/// N x n = 0. Such arcs have a row of their own in Figure 11.
std::vector<bool> PlanesOnHorizon(const WeightedContour& contour);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_WEIGHTED_CONTOUR_H_
