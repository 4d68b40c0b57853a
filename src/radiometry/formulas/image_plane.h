// SPDX-License-Identifier: GPL-3.0-or-later
// "image-plane": the sum over the vertices of the projection to the image
// plane, with the slopes of its edges. S (8) to (10), which are right as
// printed but for the constant (erratum 5: M / 2 pi). A term whose slope is
// not defined is 0.
//
// The region must be bounded on the image plane: radiometry/square_clip.h cuts
// it to a square (S, Lemma 1). Error: u / size^2, and u / elevation where a
// vertex is near the horizon.

#ifndef TRUELUX_RADIOMETRY_FORMULAS_IMAGE_PLANE_H_
#define TRUELUX_RADIOMETRY_FORMULAS_IMAGE_PLANE_H_

#include <cmath>

#include "radiometry/formulas/image_vertex.h"

namespace truelux {

/// F of S (9) for the line of slope m through (x, y).
template <class T>
T SlopeTerm(const T& x, const T& y, const T& m) {
  const T one = Make<T>(1);
  const T a = one / Sqrt(one + x * x);
  const T rise = y - m * x;
  const T c = one / Sqrt(one + m * m + rise * rise);
  return a * x * Angle(a * y, one) + c * rise * Angle(c * (x + m * y), one);
}

/// What an edge whose ends differ by `run` in x adds at most: pi / 2 |run|,
/// the integral of F_1 dx of S (5) with |F_1| <= pi / 4. Only a Ball has use
/// for it, where the slope is not certain.
template <class T>
T BoundedByRun(const T& term, const T& /*run*/) {
  return term;
}

inline Ball<double> BoundedByRun(const Ball<double>& term,
                                 const Ball<double>& run) {
  const double most = RoundBoundUp(1.6 * (std::fabs(run.value) + run.error));
  return term.error <= most ? term : Ball<double>{0, most};
}

/// The form factor [1] of a region without vertices on the horizon.
template <class T>
T ImagePlane(const Boundary<T>& region) {
  T sum = Make<T>(0);
  for (const BoundaryArc<T>& arc : region.arcs) {
    const ImageVertex<T> p = ImageOf(region.From(arc));
    const ImageVertex<T> q = ImageOf(region.To(arc));
    const T run = q.x - p.x;
    if (IsZero(run)) continue;
    const T m = (q.y - p.y) / run;
    const T term = SlopeTerm(q.x, q.y, m) - SlopeTerm(p.x, p.y, m);
    sum = sum + BoundedByRun(term, run);
  }
  return sum / (Make<T>(2) * region.pi);
}

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_FORMULAS_IMAGE_PLANE_H_
