// SPDX-License-Identifier: GPL-3.0-or-later
// From sums per source to sums per channel.

#ifndef TRUELUX_RADIOMETRY_STAGES_CHANNEL_SUMS_H_
#define TRUELUX_RADIOMETRY_STAGES_CHANNEL_SUMS_H_

#include <array>
#include <cstddef>

#include "base/ids.h"
#include "exact/ball.h"
#include "radiometry/weighted_contour.h"

namespace truelux {

/// Adds what each source gives, times its weight, per channel.
///
/// Weights are taken relative to the channel's largest, so that neither faint
/// nor very bright sources leave the range in which balls are narrow.
template <class T>
class ChannelSums {
 public:
  /// `contour` must outlive this object.
  explicit ChannelSums(const WeightedContour& contour);

  /// Adds what a lit source gives, in the channels in which it emits.
  void Add(SourceId source, const Ball<T>& sum);

  /// The sums, all times `factor`.
  [[nodiscard]] std::array<Ball<T>, 3> Finish(const Ball<T>& factor) const;

 private:
  const WeightedContour& contour_;
  std::array<int, 3> exponents_;
  /// An earlier channel with the same weights, or the channel itself.
  std::array<std::size_t, 3> alike_;
  std::array<Ball<T>, 3> sums_;
};

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_STAGES_CHANNEL_SUMS_H_
