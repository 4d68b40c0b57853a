#include "radiometry/ball_geometry.h"

#include <utility>

namespace truelux {
namespace {

/// A vector whose components, relative to the largest, are known better than
/// this is good enough; a worse one is evaluated exactly, which costs some
/// microseconds. The values leave a margin over the usual error of a crossing
/// (a few u, a few u^2) and are far below what would spoil a result.
template <class T>
constexpr double kGoodEnough = 0;
template <>
constexpr double kGoodEnough<double> = 0x1p-32;
template <>
constexpr double kGoodEnough<DoubleDouble> = 0x1p-88;

template <class T>
bool IsGood(const ScaledVector<T>& v) {
  return v.usable && v.Error() <= kGoodEnough<T>;
}

}  // namespace

template <class T>
BallGeometry<T>::BallGeometry(const WeightedContour& contour, Formula formula)
    : contour_(contour),
      recipes_(contour.view),
      exact_recipes_(contour.view),
      receiver_normal_(EvaluatePlane({.kind = PlaneRecipe::Kind::kHorizon})) {
  const Contour& c = contour.contour;
  const Vec3<Ball<T>>& n = receiver_normal_.vector;
  const Ball<T> receiver_length = Sqrt(Dot(n, n));
  planes_.reserve(c.planes.size());
  for (const PlaneRecipe& recipe : c.planes) {
    planes_.push_back(
        Complete(EvaluatePlane(recipe), receiver_length, formula));
  }
  directions_.reserve(c.directions.size());
  for (const DirectionRecipe& recipe : c.directions) {
    directions_.push_back(EvaluateDirection(recipe));
  }
}

template <class T>
BallPlane<T> BallGeometry<T>::Complete(const ScaledVector<T>& normal,
                                       const Ball<T>& receiver_length,
                                       Formula formula) const {
  const Vec3<Ball<T>>& n = receiver_normal_.vector;
  BallPlane<T> plane;
  plane.normal = normal;
  plane.length = Sqrt(Dot(normal.vector, normal.vector));
  plane.cosine = Dot(n, normal.vector) / (receiver_length * plane.length);
  if (formula == Formula::kHomogeneous) plane.ascent = Cross(n, normal.vector);
  return plane;
}

template <class T>
ScaledVector<T> BallGeometry<T>::EvaluatePlane(
    const PlaneRecipe& recipe) const {
  const auto& explicit_vectors = contour_.contour.explicit_vectors;
  if (recipe.kind != PlaneRecipe::Kind::kExplicit) {
    ScaledVector<T> rounded =
        ScaleToUnit(recipes_.Plane(recipe, explicit_vectors));
    if (IsGood(rounded)) return rounded;
  }
  return ScaleToUnit<T>(exact_recipes_.Plane(recipe, explicit_vectors));
}

template <class T>
ScaledVector<T> BallGeometry<T>::EvaluateDirection(
    const DirectionRecipe& recipe) const {
  const Contour& c = contour_.contour;
  if (recipe.kind == DirectionRecipe::Kind::kCrossing) {
    // From the scaled planes: of degree 2 in numbers near 1, not of degree 4
    // in the coordinates.
    const Vec3<Ball<T>> crossing =
        Cross(Plane(recipe.a).normal.vector, Plane(recipe.b).normal.vector);
    ScaledVector<T> rounded =
        ScaleToUnit(recipe.negated ? -crossing : crossing);
    if (IsGood(rounded)) return rounded;
  } else if (recipe.kind != DirectionRecipe::Kind::kExplicit) {
    ScaledVector<T> rounded =
        ScaleToUnit(recipes_.Direction(recipe, c.planes, c.explicit_vectors));
    if (IsGood(rounded)) return rounded;
  }
  return ScaleToUnit<T>(
      exact_recipes_.Direction(recipe, c.planes, c.explicit_vectors));
}

template <class T>
std::optional<Ball<T>> BallGeometry<T>::CrossOfWholeEdge(const Arc& arc) const {
  const Contour& c = contour_.contour;
  const PlaneRecipe& plane = c.planes[static_cast<std::size_t>(arc.plane)];
  if (plane.kind != PlaneRecipe::Kind::kEdge) return std::nullopt;
  const auto from = static_cast<std::size_t>(arc.from);
  const auto to = static_cast<std::size_t>(arc.to);
  const DirectionRecipe& first = c.directions[from];
  const DirectionRecipe& last = c.directions[to];
  if (first.kind != DirectionRecipe::Kind::kVertex ||
      last.kind != DirectionRecipe::Kind::kVertex ||
      std::minmax(first.a, last.a) != std::minmax(plane.a, plane.b)) {
    return std::nullopt;
  }
  // (a - r) x (b - r) = (a - r) x (b - a) = +-N; undo the three scalings.
  const long exponent = Plane(arc.plane).normal.exponent -
                        directions_[from].exponent - directions_[to].exponent;
  if (exponent < -800 || exponent > 800) return std::nullopt;
  return Scaled(Plane(arc.plane).length,
                std::ldexp(1.0, static_cast<int>(exponent)));
}

template class BallGeometry<double>;
template class BallGeometry<DoubleDouble>;

}  // namespace truelux
