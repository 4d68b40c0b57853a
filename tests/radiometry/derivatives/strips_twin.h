// SPDX-License-Identifier: GPL-3.0-or-later
// Kink sizes without any step: what is seen in the strips beside a plane, in
// rational numbers at the receiver itself. The twin of the limits at displaced
// receivers, with which it shares neither arcs nor contours nor sources.
//
// In a plane P through r with the normal m, a motion by s t m (s = 1 or -1, t
// small) moves a point of P at the distance rho along w to the angle -s t / rho
// from P. So the place of a strip is told by z, an inverse distance, and by s.
// At w, whatever z is,
//   - a face that P crosses along w is seen at every z, at its own 1/rho,
//   - a face with an edge in P is seen on one side of its edge's z,
//   - a face in P is seen between its near and its far edge, at 1/rho = z.
// What is nearest at z gives M(z, s). It changes at lines of P alone, and each
// line has z = g.w with a vector g. With J the steps of M in z,
//
//     b = -(1/2pi|n|) integral over w in P, n.w > 0, of
//             n.w (sum over s and lines of J g.w) dw
//
// Two faces at one distance all along P meet in P: the one that is nearer
// beside P counts, that is the one with more s (g.m)(g.w - z). This covers cuts
// and faces that touch, sources and blockers alike, and sources in P.
//
// Faces must be planar and convex, and the receiver must lie on none. Faces in
// one plane are in the order of docs/scene_format.md, without --two-sided.

#ifndef TRUELUX_TESTS_RADIOMETRY_DERIVATIVES_STRIPS_TWIN_H_
#define TRUELUX_TESTS_RADIOMETRY_DERIVATIVES_STRIPS_TWIN_H_

#include <array>
#include <span>
#include <vector>

#include "truelux/geometry.h"
#include "truelux/receiver.h"

#include "exact/rational.h"
#include "support/scenes.h"

namespace truelux::testing {

/// A plane through the receiver that holds a face or two lines of the scene.
struct TwinPlane {
  Vector3 normal;  ///< of length 1, rounded once, as Kink::normal
  Rgb size{};      ///< b, rounded once; 0 if there is no kink
};

/// A planar convex face relative to the receiver.
struct Sheet {
  int number = 0;  ///< of the face, from 1
  std::vector<RationalVector> corners;
  RationalVector normal;  ///< of the front
  mpq_class height;       ///< normal . corner; 0: seen edge-on
  std::array<mpq_class, 3> emission;

  /// Whether it emits in any channel.
  [[nodiscard]] bool Emits() const;

  /// Of a face whose height is not 0: 1/rho along w is this times w.
  [[nodiscard]] RationalVector InverseDistance() const;
};

/// The kinks at one receiver.
class StripsTwin {
 public:
  /// Throws std::invalid_argument for a face that is not planar and convex.
  StripsTwin(std::span<const TestFace> faces, const Receiver& receiver);

  /// The faces that the receiver lies on, by their numbers. If there are any,
  /// nothing else here has a meaning.
  [[nodiscard]] std::vector<int> Touched() const;

  /// Whether a face lies in the receiver plane or parallel to it.
  [[nodiscard]] bool IsLevel(int number) const;

  /// Whether an emitting face, hidden or not, is not seen from its back.
  [[nodiscard]] bool MayBeLit() const;

  /// Every plane that holds a face or two different lines: edges, or lines
  /// where two faces may meet, whether they are seen or not.
  [[nodiscard]] std::vector<TwinPlane> Planes() const;

 private:
  std::vector<Sheet> sheets_;
  RationalVector receiver_normal_;
};

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_RADIOMETRY_DERIVATIVES_STRIPS_TWIN_H_
