// SPDX-License-Identifier: GPL-3.0-or-later
// Three numbers of any ring type.

#ifndef TRUELUX_EXACT_VEC3_H_
#define TRUELUX_EXACT_VEC3_H_

namespace truelux {

template <class NT>
struct Vec3 {
  NT x;
  NT y;
  NT z;
};

template <class NT>
Vec3<NT> operator+(const Vec3<NT>& a, const Vec3<NT>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class NT>
Vec3<NT> operator-(const Vec3<NT>& a, const Vec3<NT>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class NT>
Vec3<NT> operator-(const Vec3<NT>& a) {
  return {-a.x, -a.y, -a.z};
}

template <class NT>
Vec3<NT> operator*(const NT& s, const Vec3<NT>& a) {
  return {s * a.x, s * a.y, s * a.z};
}

template <class NT>
NT Dot(const Vec3<NT>& a, const Vec3<NT>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class NT>
Vec3<NT> Cross(const Vec3<NT>& a, const Vec3<NT>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// det(a, b, c), the rows a, b, c.
template <class NT>
NT Determinant(const Vec3<NT>& a, const Vec3<NT>& b, const Vec3<NT>& c) {
  return Dot(Cross(a, b), c);
}

/// Whether a vector of exact numbers is (0, 0, 0).
template <class NT>
bool IsZero(const Vec3<NT>& v) {
  return v.x.is_zero() && v.y.is_zero() && v.z.is_zero();
}

}  // namespace truelux

#endif  // TRUELUX_EXACT_VEC3_H_
