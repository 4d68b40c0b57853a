// SPDX-License-Identifier: GPL-3.0-or-later
// The input of every evaluation stage: a visible contour, what its recipes
// refer to, and what each source emits.
//
// Letters: r the receiver, n its normal; N the normal of a plane through r; M
// the exitance and L the radiance of a source, M = pi L; E the irradiance, F
// the form factor, E = sum of M F.

#ifndef TRUELUX_RADIOMETRY_WEIGHTED_CONTOUR_H_
#define TRUELUX_RADIOMETRY_WEIGHTED_CONTOUR_H_

#include <cstddef>
#include <optional>
#include <span>

#include "truelux/geometry.h"

#include "base/id_vector.h"
#include "base/ids.h"
#include "visibility/contour.h"

namespace truelux {

/// Refers to its parts, which must outlive it.
struct WeightedContour {
  ReceiverView view;
  const Contour& contour;
  /// One entry per entry of contour.sources: M [W/m^2], or L [W/m^2/sr] with
  /// Emission::kRadiance; finite and not negative.
  std::span<const Rgb> weights;

  /// What a source emits.
  [[nodiscard]] const Rgb& WeightOf(SourceId source) const {
    return weights[source.index()];
  }

  /// The arcs of one source.
  [[nodiscard]] std::span<const Arc> ArcsOf(SourceId source) const {
    return contour.ArcsOf(contour.sources[source]);
  }

  /// Whether a source has arcs and emits in some channel.
  [[nodiscard]] bool IsLit(SourceId source) const;

  /// Whether a source has arcs and emits in this channel. E is exactly 0 in
  /// the channels in which none does.
  [[nodiscard]] bool IsLit(SourceId source, std::size_t channel) const {
    return contour.sources[source].arc_count > 0 &&
           WeightOf(source)[channel] > 0;
  }
};

/// What all sources that are lit emit, if they emit the same; nothing also if
/// none is lit.
std::optional<Rgb> CommonWeights(const WeightedContour& contour);

/// For each plane of a contour, whether it is exactly the receiver plane.
using HorizonPlanes = IdVector<PlaneId, bool>;

/// For each plane of the contour whether it is exactly the receiver plane,
/// N x n = 0. Such arcs have a row of their own in Figure 11.
HorizonPlanes PlanesOnHorizon(const WeightedContour& contour);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_WEIGHTED_CONTOUR_H_
