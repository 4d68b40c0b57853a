// SPDX-License-Identifier: GPL-3.0-or-later
// Irradiance by shadow rays in double: what shadow rays miss apart from
// rounding.

#ifndef TRUELUX_BENCH_DOUBLE_RAYS_H_
#define TRUELUX_BENCH_DOUBLE_RAYS_H_

#include <array>
#include <vector>

#include "truelux/receiver.h"
#include "truelux/scene.h"

#include "baselines/emitter_samples.h"

namespace truelux::bench {

/// The estimate of ShadowRays without its rounding. Every ray is held against
/// every triangle, so it is for scenes of a few triangles.
class DoubleRays {
 public:
  /// Copies the triangles of the scene.
  explicit DoubleRays(const Scene& scene);

  /// The mean over the samples of M V cos cos' / (pi d^2) times the emitters'
  /// area: an estimate of E [W/m^2] in the first channel. on_face is not
  /// looked at.
  [[nodiscard]] double Estimate(const Receiver& receiver,
                                const EmitterSamples& samples) const;

 private:
  using Corners = std::array<Point3, 3>;
  std::vector<Corners> triangles_;
};

}  // namespace truelux::bench

#endif  // TRUELUX_BENCH_DOUBLE_RAYS_H_
