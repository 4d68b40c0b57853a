// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over pieces of a lamp that are small beside their distance.

#ifndef TRUELUX_ISOLUX_LAMP_PIECES_H_
#define TRUELUX_ISOLUX_LAMP_PIECES_H_

#include <algorithm>
#include <array>
#include <cmath>

#include "exact/vec3.h"

namespace truelux {

inline double LengthOf(const Vec3<double>& v) {
  return std::sqrt(Dot(v, v));
}

inline Vec3<double> UnitOf(const Vec3<double>& v) {
  return (1 / LengthOf(v)) * v;
}

/// The corners of a triangle of a lamp.
using LampTriangle = std::array<Vec3<double>, 3>;

/// Receivers within a distance of a point of the surface.
struct ReceiverDisc {
  Vec3<double> middle{0, 0, 0};
  double radius = 0;
};

/// Pieces are quartered until they are smaller than this share of their
/// distance.
inline constexpr double kFinePiece = 0.5;
/// Those that touch the disc from outside need no more.
inline constexpr int kMostQuarterings = 24;

/// A small piece, as seen from a disc.
struct LampPiece {
  double area = 0;
  double high = 0;      ///< the largest height over the surface, > 0
  double distance = 0;  ///< at least so far from all receivers
  Vec3<double> centre{0, 0, 0};
  double spread = 0;  ///< all of it is so near its centre
};

/// The sum of term(piece) over the pieces of a triangle above the surface; +inf
/// if the disc's ball touches it.
template <class Term>
double SumOverPieces(const LampTriangle& corners, const ReceiverDisc& disc,
                     const Term& term, int depth = 0) {
  const auto& [a, b, c] = corners;
  const double high = std::max({a.z, b.z, c.z});
  if (high <= 0) return 0;
  const Vec3<double> centre = (1.0 / 3) * (a + b + c);
  const double spread = std::max(
      {LengthOf(a - centre), LengthOf(b - centre), LengthOf(c - centre)});
  const double to_centre = LengthOf(centre - disc.middle) - disc.radius;
  if (to_centre <= 0) return HUGE_VAL;
  const double distance = to_centre - spread;
  if (spread <= kFinePiece * distance) {
    return term(LampPiece{LengthOf(Cross(b - a, c - a)) / 2, high, distance,
                          centre, spread});
  }
  if (depth >= kMostQuarterings) return HUGE_VAL;
  const Vec3<double> ab = a + 0.5 * (b - a);
  const Vec3<double> bc = b + 0.5 * (c - b);
  const Vec3<double> ca = c + 0.5 * (a - c);
  double sum = 0;
  for (const LampTriangle& quarter :
       {LampTriangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
    sum += SumOverPieces(quarter, disc, term, depth + 1);
  return sum;
}

}  // namespace truelux

#endif  // TRUELUX_ISOLUX_LAMP_PIECES_H_
