// SPDX-License-Identifier: GPL-3.0-or-later
// One number of the light on a surface, and how it changes along it.

#ifndef TRUELUX_ISOLUX_LIGHT_PROBE_H_
#define TRUELUX_ISOLUX_LIGHT_PROBE_H_

#include <atomic>
#include <cstdint>

#include "truelux/geometry.h"
#include "truelux/irradiance.h"

#include "isolux/plan_frame.h"

namespace truelux {

/// Irradiance at a receiver.
struct LightValue {
  double value = 0;  ///< [W/m^2]
  double bound = 0;  ///< on its error

  /// Whether it is proven that the irradiance is above (below) a level.
  [[nodiscard]] bool IsAbove(double level) const {
    return value - level > bound;
  }

  [[nodiscard]] bool IsBelow(double level) const {
    return level - value > bound;
  }
};

/// The same with the gradient along the surface.
struct LightSample {
  LightValue light;
  PlanPoint gradient;         ///< [W/m^3]
  double gradient_bound = 0;  ///< on the length of its error
  bool is_defined = true;     ///< whether there is a gradient
};

/// Asks an oracle about one side of a surface. May be used from several threads.
class LightProbe {
 public:
  /// weights: what is asked for is their sum over the channels.
  LightProbe(const Oracle& oracle, const PlanFrame& plan, const Rgb& weights)
      : oracle_(oracle), plan_(plan), weights_(weights) {}

  [[nodiscard]] LightValue ValueAt(const PlanPoint& p) const;
  [[nodiscard]] LightSample SampleAt(const PlanPoint& p) const;

  /// How often it was asked.
  [[nodiscard]] std::uint64_t count() const { return count_; }

  [[nodiscard]] const PlanFrame& plan() const { return plan_; }

 private:
  [[nodiscard]] LightValue Weighted(const Irradiance& irradiance) const;

  const Oracle& oracle_;
  const PlanFrame& plan_;
  Rgb weights_;
  mutable std::atomic<std::uint64_t> count_ = 0;
};

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_LIGHT_PROBE_H_
