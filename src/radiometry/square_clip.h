// SPDX-License-Identifier: GPL-3.0-or-later
// Cutting visible contours to a square on the image plane (S, Lemma 1).

#ifndef TRUELUX_RADIOMETRY_SQUARE_CLIP_H_
#define TRUELUX_RADIOMETRY_SQUARE_CLIP_H_

#include "base/id_vector.h"
#include "base/ids.h"
#include "radiometry/weighted_contour.h"
#include "visibility/contour.h"

namespace truelux {

/// A contour all of whose vertices have finite projections.
struct BoundedContour {
  /// Its sources are those of the contour it was made from, in that order; one
  /// that was cut off whole has no arcs.
  Contour contour;
  IdVector<SourceId, bool> is_cut;
};

/// What is cut off a source at most, as a form factor [1]: 1 / (1 + R^2), the
/// irradiance from outside of the disc in the square (Lemma 1; the sharper
/// bound for the square is 0.818 R^-2).
double FormFactorBeyond(double half_side);

/// Cuts every source to |x|, |y| <= half_side on the image plane at unit
/// distance from the receiver, exactly: half-planes are taken one after the
/// other (Sutherland and Hodgman), and where the contour leaves one at a point
/// p and comes back at q, the arcs from p to a fixed point of its border and
/// from there to q close it. The axes of the square are rounded to doubles, so
/// that it is turned and off square by a few u, and the half-side as well.
BoundedContour CutToSquare(const WeightedContour& contour, double half_side);

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_SQUARE_CLIP_H_
