// SPDX-License-Identifier: GPL-3.0-or-later
// What surrounds one vertex of the image: circular sectors with depth and
// emission (Stark and Riesenfeld 2000, section 3.2).

#ifndef TRUELUX_BASELINES_SPAN_LIST_H_
#define TRUELUX_BASELINES_SPAN_LIST_H_

#include <cstddef>
#include <limits>
#include <vector>

#include "truelux/geometry.h"

namespace truelux {

/// A direction in the image plane: (a, b) of any length and its angle
/// theta [rad] in (-pi, pi].
struct SpanDirection {
  double a = 0;
  double b = 0;
  double theta = 0;
};

[[nodiscard]] SpanDirection MakeImageDirection(double a, double b);

/// The directions from `from` counter-clockwise to `to`; none if equal.
struct ImageSector {
  SpanDirection from;
  SpanDirection to;
};

/// By clearly more than rounding.
[[nodiscard]] bool IsMoreThanHalfTurn(const ImageSector& sector);

/// What a polygon puts into a sector. The slope is the gradient of 1 / depth
/// over the image plane: of two polygons at one depth, which share an edge or
/// a vertex, it tells which one is in front.
struct SpanContent {
  double depth = std::numeric_limits<double>::infinity();  ///< background
  Rgb exitance{};
  double slope_x = 0;
  double slope_y = 0;
};

/// The circular list of angular spans. Contents may come in any order of
/// depth; the nearest one stays. Keeps its memory when it is used again.
class SpanList {
 public:
  void Clear();

  void Insert(const ImageSector& sector, const SpanContent& content);

  /// All directions.
  void InsertFull(const SpanContent& content);

  /// The part that all sectors have in common; sectors: at least one.
  void InsertCommonPart(const std::vector<ImageSector>& sectors,
                        const SpanContent& content);

  /// Sum over the spans of (M - M of the span before) F~(x, y; a, b), where
  /// (a, b) is the direction in which the span begins:
  ///
  ///   F~ = C k atan(C (a x + b y)) / 2,  k = a y - b x,
  ///   C = 1 / sqrt(a^2 + b^2 + k^2).
  ///
  /// That is (9) with the direction instead of tan theta, so that a vertical
  /// edge is no special case. pi times its share of E [W/m^2].
  [[nodiscard]] Rgb Contribution(double x, double y) const;

 private:
  struct Span {
    SpanDirection begin;
    SpanContent content;
  };

  /// The span that begins there, made by splitting if need be.
  std::size_t SplitAt(const SpanDirection& direction);
  void Cover(std::size_t span, const SpanContent& content);

  std::vector<Span> spans_;          ///< by theta, no two equal
  SpanContent around_;               ///< everywhere as long as there is no span
  std::vector<SpanDirection> ends_;  ///< of InsertCommonPart
};

}  // namespace truelux

#endif  // TRUELUX_BASELINES_SPAN_LIST_H_
