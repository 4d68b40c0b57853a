#include "radiometry/stages/exact_sum.h"

namespace truelux {

ExactPlane ExactPlaneOf(const Vec3<Exact>& n, const Exact& n_square,
                        const Vec3<Exact>& normal) {
  const Exact square = Dot(normal, normal);
  return {square, Dot(n, normal), square * n_square};
}

ExactTerm EndTerm(std::size_t plane, const Vec3<Exact>& n,
                  const Vec3<Exact>& ascent, const Vec3<Exact>& d,
                  bool negative) {
  return {plane, Dot(d, ascent), Dot(n, d), false, true, negative};
}

ExactTerm HorizonEndTerm(std::size_t plane, const Vec3<Exact>& d,
                         const Vec3<Exact>& other, const Exact& across,
                         bool negative) {
  return {plane, Dot(d, d) - Dot(d, other), across, true, false, negative};
}

}  // namespace truelux
