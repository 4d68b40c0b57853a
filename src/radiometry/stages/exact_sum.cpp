// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/stages/exact_sum.h"

#include <cassert>
#include <utility>

namespace truelux {

ExactPlane ExactPlaneOf(const Vec3<Exact>& n, const Exact& n_square,
                        const Vec3<Exact>& normal) {
  const Exact square = Dot(normal, normal);
  return {square, Dot(n, normal), square * n_square};
}

ExactTerm EndTerm(ExactPlaneId plane, const Vec3<Exact>& n,
                  const Vec3<Exact>& ascent, const Vec3<Exact>& d,
                  bool negative) {
  Exact height = Dot(n, d);
  assert(SignOf(height) != Sign::kNegative);
  return {plane, Dot(d, ascent), std::move(height), false, true, negative};
}

ExactTerm HorizonEndTerm(ExactPlaneId plane, const Vec3<Exact>& d,
                         const Vec3<Exact>& other, const Exact& across,
                         bool negative) {
  return {plane, Dot(d, d) - Dot(d, other), across, true, false, negative};
}

}  // namespace truelux
