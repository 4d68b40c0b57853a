// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/frame_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "exact/ball_recipe.h"
#include "exact/exact_conversion.h"
#include "exact/recipe_evaluator.h"
#include "radiometry/stages/ball_geometry.h"
#include "radiometry/working_number.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

/// An exact vector, rounded.
Vec3<Multiprecision> Rounded(const Vec3<Exact>& v, mpfr_prec_t precision) {
  return {MultiprecisionOf(precision, v.x), MultiprecisionOf(precision, v.y),
          MultiprecisionOf(precision, v.z)};
}

/// The frame is used where coordinates can be scaled by this at most.
constexpr int kMaxExponent = 1000;

/// A vector of balls as its three components.
Vec3<Ball<DoubleDouble>> Balls(const BallVector<DoubleDouble>& v) {
  return {Component(v, 0), Component(v, 1), Component(v, 2)};
}

/// b - a.
template <class W>
Vec3<W> Difference(const Point3& a, const Point3& b, mpfr_prec_t precision) {
  if constexpr (std::is_same_v<W, Multiprecision>) {
    return Rounded(RecipeEvaluator<Exact>::Between(a, b), precision);
  } else {
    return RecipeEvaluator<W>::Between(a, b);
  }
}

bool IsVertex(const DirectionRecipe& d) {
  return d.kind() == DirectionRecipe::Kind::kVertex && !d.negated();
}

/// The exponent of the largest coordinate relative to r of the scene vertices
/// that a source's arcs end at; without any, of the ends of their edges.
int LargestExponent(const WeightedContour& contour, SourceId source) {
  const Contour& c = contour.contour;
  double largest = 0;
  const auto take = [&](VertexId v) {
    const Point3& p = contour.view.vertices[v];
    const Point3& r = contour.view.position;
    largest = std::max({largest, std::fabs(p.x - r.x), std::fabs(p.y - r.y),
                        std::fabs(p.z - r.z)});
  };
  for (const Arc& arc : contour.ArcsOf(source)) {
    for (const DirectionId end : {arc.from, arc.to}) {
      const DirectionRecipe& d = c.directions[end];
      if (IsVertex(d)) take(d.vertex());
    }
  }
  for (const Arc& arc : contour.ArcsOf(source)) {
    const PlaneRecipe& plane = c.planes[arc.plane];
    if (largest > 0 || plane.kind() != PlaneRecipe::Kind::kEdge) continue;
    take(plane.from());
    take(plane.to());
  }
  if (largest == 0 || !std::isfinite(largest)) return 0;
  return std::clamp(std::ilogb(largest), -kMaxExponent, kMaxExponent);
}

template <class W>
void LoadVectors(const WeightedContour& contour, mpfr_prec_t precision,
                 IdVector<DirectionId, Vec3<W>>& directions,
                 IdVector<PlaneId, Vec3<W>>& planes) {
  const Contour& c = contour.contour;
  if constexpr (std::is_same_v<W, Multiprecision>) {
    const RecipeEvaluator<Exact> exact(contour.view);
    for (const DirectionRecipe& d : c.directions) {
      directions.push_back(Normalized(Rounded(
          exact.Direction(d, c.planes, c.explicit_vectors.All()), precision)));
    }
    for (const PlaneRecipe& p : c.planes) {
      planes.push_back(Normalized(
          Rounded(exact.Plane(p, c.explicit_vectors.All()), precision)));
    }
  } else {
    BallGeometry<DoubleDouble> geometry;
    geometry.Evaluate(contour);
    for (const DirectionId id : c.directions.ids())
      directions.push_back(Balls(geometry.Direction(id).scaled.vector));
    for (const PlaneId id : c.planes.ids())
      planes.push_back(Balls(geometry.Plane(id).normal.vector));
  }
}

/// A triangle in the plane of a facet; none if there is no such triangle.
TriangleId TriangleOf(const WeightedContour& contour, FacetId facet) {
  const auto triangles = contour.view.triangles.values();
  const auto found = std::ranges::lower_bound(
      triangles, facet, {}, [](const Triangle& t) { return FacetOf(t); });
  if (found == triangles.end() || FacetOf(*found) != facet) return {};
  return TriangleId(static_cast<int>(found - triangles.begin()));
}

/// A worse determinant is taken from exact numbers.
constexpr double kGoodDeterminant = 0x1p-100;

}  // namespace

template <class W>
FrameGeometry<W>::FrameGeometry(const WeightedContour& contour,
                                mpfr_prec_t precision)
    : contour_(contour),
      precision_(precision),
      frame_(contour.view.normal, precision),
      is_horizon_(PlanesOnHorizon(contour)) {
  for (const SourceId source : contour.contour.sources.ids())
    exponents_.push_back(LargestExponent(contour, source));
  LoadVectors(contour, precision, directions_, planes_);
  FindHorizon();
}

template <class W>
void FrameGeometry<W>::FindHorizon() {
  const Contour& c = contour_.contour;
  const RecipeEvaluator<Exact> exact(contour_.view);
  const Vec3<W> normal = ScaledNormal<W>(contour_.view.normal);
  for (const DirectionId id : c.directions.ids()) {
    if constexpr (!std::is_same_v<W, Multiprecision>) {
      const W height = Dot(normal, directions_[id]);
      if (LowerMagnitude(height.value) > height.error) {
        on_horizon_.push_back(false);
        continue;
      }
    }
    const Vec3<Exact> d =
        exact.Direction(c.directions[id], c.planes, c.explicit_vectors.All());
    on_horizon_.push_back(Dot(exact.ReceiverNormal(), d).is_zero());
  }
}

template <class W>
W FrameGeometry<W>::OntoPlane(SourceId source, DirectionId id) const {
  const Vec3<W>& d = directions_[id];
  const int exponent = exponents_[source];
  const TriangleId triangle =
      TriangleOf(contour_, contour_.contour.sources[source].facet);
  double factor = 0;
  if (triangle.valid()) {
    if constexpr (!std::is_same_v<W, Multiprecision>) {
      const RecipeEvaluator<W> rounded(contour_.view);
      const W distance =
          rounded.Height(triangle) / Dot(rounded.TriangleNormal(triangle), d);
      if (IsBounded(distance)) {
        factor = std::ldexp(Leading(distance.value), -exponent);
      }
    }
    // Exact numbers where those were, or have become, too large or too small.
    if (!(factor > 0)) {
      const RecipeEvaluator<Exact> exact(contour_.view);
      const auto normal =
          Rounded(exact.TriangleNormal(triangle), kConversionBits);
      const Multiprecision height =
          MultiprecisionOf(kConversionBits, exact.Height(triangle));
      const Vec3<Multiprecision> ray = {Middle(d.x), Middle(d.y), Middle(d.z)};
      factor = TimesTwoTo(height / Dot(normal, ray), -exponent).ToDouble();
    }
  }
  // Any positive factor is right; this one only makes differences short. It is
  // not 2^60 off where the source is, but where only near blockers bound it.
  if (!(factor > 0x1p-60 && factor < 0x1p60)) factor = 1;
  return FromDouble<W>(factor);
}

template <class W>
Vec3<W> FrameGeometry<W>::Point(SourceId source, DirectionId id) const {
  const DirectionRecipe& recipe = contour_.contour.directions[id];
  Vec3<W> point =
      IsVertex(recipe)
          ? Scaled(source, contour_.view.position,
                   contour_.view.vertices[recipe.vertex()])
          : frame_.FromScene(OntoPlane(source, id) * directions_[id]);
  point.z = OnHorizon(id) ? FromDouble<W>(0) : NotBelowZero(point.z);
  return point;
}

template <class W>
Vec3<W> FrameGeometry<W>::Between(SourceId source, DirectionId a,
                                  DirectionId b) const {
  const DirectionRecipe& from = contour_.contour.directions[a];
  const DirectionRecipe& to = contour_.contour.directions[b];
  Vec3<W> difference = IsVertex(from) && IsVertex(to)
                           ? Edge(source, from.vertex(), to.vertex())
                           : Point(source, b) - Point(source, a);
  if (OnHorizon(a) && OnHorizon(b)) difference.z = FromDouble<W>(0);
  return difference;
}

template <class W>
Vec3<W> FrameGeometry<W>::Scaled(SourceId source, const Point3& a,
                                 const Point3& b) const {
  return frame_.FromScene(
      TimesTwoTo(Difference<W>(a, b, precision_), -exponents_[source]));
}

template <class W>
Vec3<W> FrameGeometry<W>::Edge(SourceId source, VertexId a, VertexId b) const {
  return Scaled(source, contour_.view.vertices[a], contour_.view.vertices[b]);
}

template <class W>
Vec3<W> FrameGeometry<W>::Plane(PlaneId id) const {
  Vec3<W> normal = frame_.FromScene(planes_[id]);
  if (IsHorizon(id)) normal.x = normal.y = FromDouble<W>(0);
  return normal;
}

template <class W>
W FrameGeometry<W>::UnitDeterminant(DirectionId a, DirectionId b,
                                    DirectionId c) const {
  if constexpr (!std::is_same_v<W, Multiprecision>) {
    const Vec3<W>& x = directions_[a];
    const Vec3<W>& y = directions_[b];
    const Vec3<W>& z = directions_[c];
    const W determinant = Determinant(x, y, z) / Sqrt(Dot(x, x)) /
                          Sqrt(Dot(y, y)) / Sqrt(Dot(z, z));
    if (determinant.error <=
        kGoodDeterminant * LowerMagnitude(determinant.value)) {
      return determinant;
    }
  }
  const RecipeEvaluator<Exact> exact(contour_.view);
  const Contour& contour = contour_.contour;
  const auto direction = [&](DirectionId id) {
    return exact.Direction(contour.directions[id], contour.planes,
                           contour.explicit_vectors.All());
  };
  const std::array<Vec3<Exact>, 3> d = {direction(a), direction(b),
                                        direction(c)};
  const mpfr_prec_t precision =
      std::is_same_v<W, Multiprecision> ? precision_ : kConversionBits;
  Multiprecision result =
      MultiprecisionOf(precision, Determinant(d[0], d[1], d[2]));
  for (const Vec3<Exact>& v : d) {
    result = result / Sqrt(MultiprecisionOf(precision, Dot(v, v)));
  }
  if constexpr (std::is_same_v<W, Multiprecision>) {
    return result;
  } else {
    return BallOfRounded(std::move(result));
  }
}

template class FrameGeometry<Ball<DoubleDouble>>;
template class FrameGeometry<Multiprecision>;

}  // namespace truelux
