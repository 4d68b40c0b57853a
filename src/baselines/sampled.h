// SPDX-License-Identifier: GPL-3.0-or-later
// Irradiance by shadow rays (Embree 3, single precision): what most lighting
// programs do.

#ifndef TRUELUX_BASELINES_SAMPLED_H_
#define TRUELUX_BASELINES_SAMPLED_H_

#include <memory>

#include "truelux/geometry.h"
#include "truelux/receiver.h"
#include "truelux/scene.h"

#include "baselines/emitter_samples.h"

namespace truelux {

/// Whether Embree was found when this was built.
[[nodiscard]] bool ShadowRaysAvailable();

/// A scene prepared for shadow rays. Const methods may be called from several
/// threads.
///
/// All triangles block, from both sides; what a ray meets in the last 1e-5 of
/// its length does not, which leaves out the source itself, nor in the first
/// 1e-5, which leaves out the surface that the receiver lies on. on_face is
/// not looked at.
class ShadowRays {
 public:
  /// std::runtime_error if Embree is not available or fails.
  explicit ShadowRays(const Scene& scene);
  ~ShadowRays();
  ShadowRays(ShadowRays&&) noexcept;
  ShadowRays& operator=(ShadowRays&&) noexcept;

  /// The mean over the samples of M V cos cos' / (pi d^2) times the emitters'
  /// area: an estimate of E [W/m^2], Ke read as exitance. kSobol and
  /// kRandom trace ray by ray (rtcOccluded1), kRowOrdered in streams that are
  /// marked as coherent (rtcOccluded1M); each is the faster one for its order. Samples behind the
  /// horizon or behind their emitter count as dark and cost no ray.
  [[nodiscard]] Rgb Estimate(const Receiver& receiver,
                             const EmitterSamples& samples) const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

}  // namespace truelux

#endif  // TRUELUX_BASELINES_SAMPLED_H_
