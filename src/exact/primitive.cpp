// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/primitive.h"

#include <algorithm>
#include <tuple>

namespace truelux {
namespace {

/// The primitive positive multiple of (x, y, z). scale: a common denominator.
PrimitiveVector WithScale(const mpq_class& x, const mpq_class& y,
                          const mpq_class& z, const mpz_class& scale) {
  PrimitiveVector p{x.get_num() * (scale / x.get_den()),
                    y.get_num() * (scale / y.get_den()),
                    z.get_num() * (scale / z.get_den())};
  const mpz_class common = gcd(gcd(p.x, p.y), p.z);
  if (common > 1) {
    p.x /= common;
    p.y /= common;
    p.z /= common;
  }
  return p;
}

}  // namespace

bool operator<(const PrimitiveVector& a, const PrimitiveVector& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

PrimitiveVector MakePrimitive(const Vec3<Exact>& v) {
  const auto rational = [](const Exact& c) {
    auto q = static_cast<mpq_class>(c);
    q.canonicalize();
    return q;
  };
  const mpq_class x = rational(v.x);
  const mpq_class y = rational(v.y);
  const mpq_class z = rational(v.z);
  // The denominators are powers of two: the largest is the common one.
  return WithScale(x, y, z, std::max({x.get_den(), y.get_den(), z.get_den()}));
}

PrimitiveVector MakePrimitive(const Vec3<mpq_class>& v) {
  return WithScale(v.x, v.y, v.z,
                   lcm(lcm(v.x.get_den(), v.y.get_den()), v.z.get_den()));
}

PrimitiveVector WithoutSign(const PrimitiveVector& v) {
  const int sign =
      sgn(v.x) != 0 ? sgn(v.x) : (sgn(v.y) != 0 ? sgn(v.y) : sgn(v.z));
  if (sign >= 0) return v;
  return {-v.x, -v.y, -v.z};
}

Vector3 ToDouble(const PrimitiveVector& v) {
  const mpz_class size =
      std::max({mpz_class(abs(v.x)), mpz_class(abs(v.y)), mpz_class(abs(v.z))});
  if (size == 0) return {};
  const auto ratio = [&size](const mpz_class& c) {
    return mpq_class(c, size).get_d();
  };
  return {ratio(v.x), ratio(v.y), ratio(v.z)};
}

}  // namespace truelux
