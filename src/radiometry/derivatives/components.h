// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers that derivatives consist of, one by one.

#ifndef TRUELUX_RADIOMETRY_DERIVATIVES_COMPONENTS_H_
#define TRUELUX_RADIOMETRY_DERIVATIVES_COMPONENTS_H_

#include <array>
#include <cstddef>

namespace truelux {

/// Which entry of Components a quantity begins at; what follows are its
/// components, matrices row after row.
enum ComponentIndex : std::size_t {  // NOLINT(cert-enum): offsets, not kinds
  kGradientAt = 0,
  kTangentialAt = 3,
  kNormalAt = 6,
  kVectorAt = 9,
  kJacobianAt = 12,
  kSphereAt = 21,
  kFluxAt = 24,
  kSphereJacobianAt = 25,
  kComponentCount = 34,
};

/// One entry per component, of one channel.
template <class T>
using ComponentArray = std::array<T, kComponentCount>;

/// Whether a component is a derivative by r, in W/m^3 (else W/m^2).
constexpr bool IsByPosition(std::size_t component) {
  return component < kNormalAt ||
         (component >= kJacobianAt && component < kSphereAt) ||
         component >= kSphereJacobianAt;
}

/// Whether a component belongs to the whole sphere.
constexpr bool IsOfSphere(std::size_t component) {
  return component >= kSphereAt;
}

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_DERIVATIVES_COMPONENTS_H_
