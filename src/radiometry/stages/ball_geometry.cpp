// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/stages/ball_geometry.h"

#include "exact/ball_recipe.h"
#include "exact/recipe_evaluator.h"

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

/// Written so that a NaN is not good.
template <class T>
bool IsGood(const BallVector<T>& v) {
  return v.error <= kGoodEnough<T> * v.length;
}

/// n, scaled.
template <class T>
BallVector<T> ReceiverNormal(const WeightedContour& contour) {
  const Vector3& n = contour.view.normal;
  ScaledVector<T> scaled;
  if (!ScaleToUnit(Components<T>{T{n.x}, T{n.y}, T{n.z}}, 0, scaled)) {
    scaled =
        ScaleToUnit<T>(RecipeEvaluator<Exact>(contour.view).ReceiverNormal());
  }
  return scaled.vector;
}

template <class T>
bool TryScale(const Vec3<Ball<T>>& v, ScaledVector<T>& scaled) {
  return ScaleToUnit(Components<T>{v.x.value, v.y.value, v.z.value},
                     RoundBoundUp(v.x.error + v.y.error + v.z.error), scaled) &&
         IsGood(scaled.vector);
}

/// The kinds of planes that are rare, and any plane exactly.
template <class T>
ScaledVector<T> AnyPlane(const WeightedContour& contour,
                         const PlaneRecipe& recipe) {
  const auto explicit_vectors = contour.contour.explicit_vectors.All();
  ScaledVector<T> rounded;
  if (recipe.kind() == PlaneRecipe::Kind::kCut &&
      TryScale(RecipeEvaluator<Ball<T>>(contour.view)
                   .Plane(recipe, explicit_vectors),
               rounded)) {
    return rounded;
  }
  return ScaleToUnit<T>(
      RecipeEvaluator<Exact>(contour.view).Plane(recipe, explicit_vectors));
}

/// The kinds of directions that are rare, and any direction exactly.
template <class T>
ScaledVector<T> AnyDirection(const WeightedContour& contour,
                             const DirectionRecipe& recipe) {
  const Contour& c = contour.contour;
  ScaledVector<T> rounded;
  if ((recipe.kind() == DirectionRecipe::Kind::kEdgeAtHorizon ||
       recipe.kind() == DirectionRecipe::Kind::kEdgeAtPlane) &&
      TryScale(RecipeEvaluator<Ball<T>>(contour.view)
                   .Direction(recipe, c.planes, c.explicit_vectors.All()),
               rounded)) {
    return rounded;
  }
  return ScaleToUnit<T>(
      RecipeEvaluator<Exact>(contour.view)
          .Direction(recipe, c.planes, c.explicit_vectors.All()));
}

}  // namespace

template <class T>
void BallGeometry<T>::Evaluate(const WeightedContour& contour) {
  const Contour& c = contour.contour;
  receiver_normal_ = ReceiverNormal<T>(contour);
  if (planes_.size() < c.planes.size()) planes_.resize(c.planes.size());
  for (const PlaneId id : c.planes.ids()) {
    const PlaneRecipe& recipe = c.planes[id];
    BallPlane<T>& plane = planes_[id];
    EvaluatePlane(contour, recipe, plane.normal);
    const BallVector<T>& normal = plane.normal.vector;
    plane.length = Length(normal);
    plane.rise = Dot(receiver_normal_, normal) / plane.length;
    plane.axis = LargestComponent(normal.value);
    const Ball<T> along_axis = Component(normal, plane.axis);
    plane.sign = Leading(along_axis.value) > 0 ? 1 : -1;
    plane.along_axis = TimesSign(along_axis, plane.sign);
    const bool is_edge = recipe.kind() == PlaneRecipe::Kind::kEdge;
    plane.first_vertex = is_edge ? recipe.from() : VertexId();
    plane.last_vertex = is_edge ? recipe.to() : VertexId();
  }
  if (directions_.size() < c.directions.size()) {
    directions_.resize(c.directions.size());
  }
  for (const DirectionId id : c.directions.ids()) {
    const DirectionRecipe& recipe = c.directions[id];
    EvaluateDirection(contour, recipe, directions_[id].scaled);
    const bool is_vertex = recipe.kind() == DirectionRecipe::Kind::kVertex;
    directions_[id].vertex = is_vertex ? recipe.vertex() : VertexId();
  }
}

template <class T>
void BallGeometry<T>::EvaluatePlane(const WeightedContour& contour,
                                    const PlaneRecipe& recipe,
                                    ScaledVector<T>& normal) const {
  if (recipe.kind() == PlaneRecipe::Kind::kEdge) {
    const Point3& a = contour.view.vertices[recipe.from()];
    const Point3& b = contour.view.vertices[recipe.to()];
    const auto to_a = Difference<T>(contour.view.position, a);
    const auto edge = Difference<T>(a, b);
    const Components<T> cross = CrossValue(to_a.value, edge.value);
    if (ScaleToUnit(recipe.negated() ? Negated(cross) : cross,
                    ErrorOfCross(to_a, edge), normal) &&
        IsGood(normal.vector)) {
      return;
    }
  } else if (recipe.kind() == PlaneRecipe::Kind::kHorizon) {
    normal.vector = recipe.negated() ? -receiver_normal_ : receiver_normal_;
    normal.exponent = 0;
    return;
  }
  normal = AnyPlane<T>(contour, recipe);
}

template <class T>
void BallGeometry<T>::EvaluateDirection(const WeightedContour& contour,
                                        const DirectionRecipe& recipe,
                                        ScaledVector<T>& direction) const {
  if (recipe.kind() == DirectionRecipe::Kind::kCrossing) {
    // From the scaled planes: of degree 2 in numbers near 1, not of degree 4
    // in the coordinates. A good one need not be scaled: its length is at most
    // 12, and not below 2^-22, as its error is at least 2^-54 (2^-105 in
    // double-double).
    BallVector<T>& crossing = direction.vector;
    const BallVector<T>& a =
        Plane(recipe.negated() ? recipe.second_plane() : recipe.first_plane())
            .normal.vector;
    const BallVector<T>& b =
        Plane(recipe.negated() ? recipe.first_plane() : recipe.second_plane())
            .normal.vector;
    crossing.value = CrossValue(a.value, b.value);
    crossing.length = LengthOf(crossing.value);
    crossing.error = ErrorOfCross(a, b);
    direction.exponent = 0;
    if (IsGood(crossing)) return;
  } else if (recipe.kind() == DirectionRecipe::Kind::kVertex) {
    Components<T> difference;
    double error = 0;
    SetDifference(contour.view.position, contour.view.vertices[recipe.vertex()],
                  difference, error);
    if (ScaleToUnit(recipe.negated() ? Negated(difference) : difference, error,
                    direction) &&
        IsGood(direction.vector)) {
      return;
    }
  }
  direction = AnyDirection<T>(contour, recipe);
}

template class BallGeometry<double>;
template class BallGeometry<DoubleDouble>;

}  // namespace truelux
