// SPDX-License-Identifier: GPL-3.0-or-later
// Exact vectors in canonical form, to tell whether two are the same direction.

#ifndef TRUELUX_EXACT_PRIMITIVE_H_
#define TRUELUX_EXACT_PRIMITIVE_H_

#include <gmpxx.h>

#include "truelux/geometry.h"

#include "exact/number.h"
#include "exact/vec3.h"

namespace truelux {

/// Integers without a common factor; equal exactly for vectors that are
/// positive multiples of each other.
struct PrimitiveVector {
  mpz_class x;
  mpz_class y;
  mpz_class z;

  friend bool operator==(const PrimitiveVector&,
                         const PrimitiveVector&) = default;

  friend bool operator<(const PrimitiveVector& a, const PrimitiveVector& b);
};

/// The primitive positive multiple of v; (0, 0, 0) stays.
PrimitiveVector MakePrimitive(const Vec3<Exact>& v);
PrimitiveVector MakePrimitive(const Vec3<mpq_class>& v);

/// The same numbers.
inline Vec3<mpq_class> RationalOf(const PrimitiveVector& v) {
  return {mpq_class(v.x), mpq_class(v.y), mpq_class(v.z)};
}

/// v or -v, so that equal planes with opposite normals become equal.
PrimitiveVector WithoutSign(const PrimitiveVector& v);

/// v divided by its largest component in absolute value; each component
/// within 1 ulp.
Vector3 ToDouble(const PrimitiveVector& v);

}  // namespace truelux

#endif  // TRUELUX_EXACT_PRIMITIVE_H_
