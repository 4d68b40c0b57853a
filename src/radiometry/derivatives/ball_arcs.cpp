// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/derivatives/ball_arcs.h"

#include "radiometry/stages/ball_terms.h"

namespace truelux {

template <class T>
BallArcs<T>::BallArcs(const WeightedContour& contour, BallGeometry<T>& geometry)
    : contour_(contour), geometry_(geometry) {
  geometry.Evaluate(contour);
  const Contour& c = contour.contour;
  const Ball<T> one(1.0);
  for (const DirectionId id : c.directions.ids()) {
    const BallVector<T>& d = geometry.Direction(id).scaled.vector;
    const Ball<T> length = Length(d);
    lengths_.push_back(length);
    units_.push_back(Times(one / length, d));
  }
  for (const PlaneId id : c.planes.ids()) {
    const BallPlane<T>& plane = geometry.Plane(id);
    normals_.push_back(Times(one / plane.length, plane.normal.vector));
  }
}

/// The sine of an arc's angle.
template <class T>
Ball<T> BallArcs<T>::SineOf(const Arc& arc) const {
  const BallPlane<T>& plane = geometry_.Plane(arc.plane);
  const BallDirection<T>& d1 = geometry_.Direction(arc.from);
  const BallDirection<T>& d2 = geometry_.Direction(arc.to);
  const Ball<T> across =
      plane.length * CrossAlongAxis(plane, d1, d2, arc.positive);
  return across / (plane.along_axis * lengths_[arc.from] * lengths_[arc.to]);
}

template <class T>
BallArc<T> BallArcs<T>::At(const Arc& arc) const {
  BallArc<T> result;
  // Out of the visible side: -N where that is N.d > 0.
  result.inward = arc.positive ? normals_[arc.plane] : -normals_[arc.plane];
  const Ball<T> sine = ClampToNonNegative(SineOf(arc));
  const Ball<T> cosine = Dot(units_[arc.from], units_[arc.to]);
  result.angle = AngleInHalfPlane(sine, cosine);
  if (contour_.contour.planes[arc.plane].kind() == PlaneRecipe::Kind::kHorizon)
    return result;
  const Ball<T> quarter(0.25);
  const Ball<T> wide = Ball<T>(1.0) + cosine;
  result.a = quarter * (result.angle + sine) / wide;
  result.b = quarter * (result.angle - sine) * wide / (sine * sine);
  return result;
}

template class BallArcs<double>;
template class BallArcs<DoubleDouble>;

}  // namespace truelux
