// SPDX-License-Identifier: GPL-3.0-or-later
// The vector irradiance and its Jacobian, and what is made of them, at any
// number type.

#ifndef TRUELUX_RADIOMETRY_DERIVATIVES_FIELD_H_
#define TRUELUX_RADIOMETRY_DERIVATIVES_FIELD_H_

#include <array>
#include <cstddef>

#include "exact/vec3.h"
#include "radiometry/derivatives/components.h"

namespace truelux {

/// V and J = dV/dr: entry p of `jacobian` is the gradient of component p of V.
template <class R>
struct Field {
  Vec3<R> vector;
  std::array<Vec3<R>, 3> jacobian;
};

/// a + s b, for every number of the fields.
template <class R>
void AddTimes(const Field<R>& b, const R& s, Field<R>& a) {
  a.vector = a.vector + s * b.vector;
  for (std::size_t p = 0; p < 3; ++p)
    a.jacobian[p] = a.jacobian[p] + s * b.jacobian[p];
}

template <class R>
void Put(const Vec3<R>& v, std::size_t at, ComponentArray<R>& components) {
  components[at] = v.x;
  components[at + 1] = v.y;
  components[at + 2] = v.z;
}

/// v less what it has along m, which is not zero.
template <class R>
Vec3<R> Tangential(const Vec3<R>& v, const Vec3<R>& m) {
  return v - (Dot(v, m) / Dot(m, m)) * m;
}

/// All components of one channel. hemisphere: V and J over the hemisphere of n;
/// sphere: over the whole sphere; n: the receiver's normal, of any length; m: a
/// normal of the surface that the receiver lies on.
template <class R>
ComponentArray<R> ComponentsOf(const Field<R>& hemisphere,
                               const Field<R>& sphere, const Vec3<R>& n,
                               const Vec3<R>& m) {
  ComponentArray<R> components;
  const auto& j = hemisphere.jacobian;
  const R length = Sqrt(Dot(n, n));
  const R inverse = (length / length) / length;
  const Vec3<R> gradient = inverse * (n.x * j[0] + (n.y * j[1] + n.z * j[2]));
  Put(gradient, kGradientAt, components);
  Put(Tangential(gradient, m), kTangentialAt, components);
  Put(Tangential(hemisphere.vector, n), kNormalAt, components);
  Put(hemisphere.vector, kVectorAt, components);
  for (std::size_t p = 0; p < 3; ++p)
    Put(j[p], kJacobianAt + 3 * p, components);
  Put(sphere.vector, kSphereAt, components);
  components[kFluxAt] = inverse * Dot(n, sphere.vector);
  for (std::size_t p = 0; p < 3; ++p)
    Put(sphere.jacobian[p], kSphereJacobianAt + 3 * p, components);
  return components;
}

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_DERIVATIVES_FIELD_H_
