#include "radiometry/frame_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "exact/ball_recipe.h"
#include "exact/recipe_evaluator.h"
#include "radiometry/stages/ball_geometry.h"

namespace truelux {
namespace {

using DoubleDoubleBall = Ball<DoubleDouble>;

/// What an exact number is rounded to on its way to a double-double.
constexpr mpfr_prec_t kConversionBits = 160;

/// The frame is used where coordinates can be scaled by this at most.
constexpr int kMaxExponent = 1000;

template <class W>
W FromDouble(double x) {
  if constexpr (std::is_same_v<W, Multiprecision>) {
    return Make<Multiprecision>(x);
  } else {
    return W(x);
  }
}

/// Whether x 2^exponent is a normal number, or 0.
bool StaysNormal(double x, double power_of_two) {
  return x == 0 || std::fabs(x * power_of_two) >= 0x1p-1000;
}

DoubleDoubleBall TimesTwoTo(const DoubleDoubleBall& x, int exponent) {
  const double factor = PowerOfTwo(exponent);
  DoubleDoubleBall scaled = truelux::Scaled(x, factor);
  // Exact numbers stay exact: formulas ask for exact zeros.
  if (x.error == 0 && StaysNormal(x.value.high, factor) &&
      StaysNormal(x.value.low, factor)) {
    scaled.error = 0;
  }
  return scaled;
}

DoubleDoubleBall NotBelowZero(const DoubleDoubleBall& x) {
  return ClampToNonNegative(x);
}

Multiprecision NotBelowZero(const Multiprecision& x) {
  return NonNegative(x);
}

Multiprecision TimesTwoTo(Multiprecision x, int exponent) {
  mpfr_mul_2si(x.get(), x.get(), exponent, MPFR_RNDN);
  return x;
}

template <class W>
Vec3<W> TimesTwoTo(const Vec3<W>& v, int exponent) {
  return {TimesTwoTo(v.x, exponent), TimesTwoTo(v.y, exponent),
          TimesTwoTo(v.z, exponent)};
}

Vec3<DoubleDoubleBall> Balls(const BallVector<DoubleDouble>& v) {
  return {Component(v, 0), Component(v, 1), Component(v, 2)};
}

Vec3<Multiprecision> Rounded(const Vec3<Exact>& v, mpfr_prec_t precision) {
  return {{precision, v.x}, {precision, v.y}, {precision, v.z}};
}

const Multiprecision& Middle(const Multiprecision& x) {
  return x;
}

Multiprecision Middle(const DoubleDoubleBall& x) {
  return Multiprecision(kConversionBits, x.value.high) +
         Multiprecision(kConversionBits, x.value.low);
}

/// The same direction with a largest component in [1/2, 1).
Vec3<Multiprecision> Normalized(const Vec3<Multiprecision>& v) {
  mpfr_exp_t largest = mpfr_get_emin();
  for (const Multiprecision* x : {&v.x, &v.y, &v.z}) {
    if (mpfr_regular_p(x->get()) != 0) {
      largest = std::max(largest, mpfr_get_exp(x->get()));
    }
  }
  return TimesTwoTo(v, static_cast<int>(-largest));
}

const Point3& Vertex(const WeightedContour& contour, int v) {
  return contour.view.vertices[static_cast<std::size_t>(v)];
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
  return d.kind == DirectionRecipe::Kind::kVertex && !d.negated;
}

/// The exponent of the largest coordinate relative to r of the scene vertices
/// that a source's arcs end at; without any, of the ends of their edges.
int LargestExponent(const WeightedContour& contour, const SourceArcs& source) {
  const Contour& c = contour.contour;
  double largest = 0;
  const auto take = [&](int v) {
    const Point3& p = Vertex(contour, v);
    const Point3& r = contour.view.position;
    largest = std::max({largest, std::fabs(p.x - r.x), std::fabs(p.y - r.y),
                        std::fabs(p.z - r.z)});
  };
  for (const Arc& arc : contour.ArcsOf(source)) {
    for (const int end : {arc.from, arc.to}) {
      const DirectionRecipe& d = c.directions[static_cast<std::size_t>(end)];
      if (IsVertex(d)) take(d.a);
    }
  }
  for (const Arc& arc : contour.ArcsOf(source)) {
    const PlaneRecipe& plane = c.planes[static_cast<std::size_t>(arc.plane)];
    if (largest > 0 || plane.kind != PlaneRecipe::Kind::kEdge) continue;
    take(plane.a);
    take(plane.b);
  }
  if (largest == 0 || !std::isfinite(largest)) return 0;
  return std::clamp(std::ilogb(largest), -kMaxExponent, kMaxExponent);
}

template <class W>
void LoadVectors(const WeightedContour& contour, mpfr_prec_t precision,
                 std::vector<Vec3<W>>& directions,
                 std::vector<Vec3<W>>& planes) {
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
    for (std::size_t i = 0; i < c.directions.size(); ++i) {
      directions.push_back(
          Balls(geometry.Direction(static_cast<int>(i)).scaled.vector));
    }
    for (std::size_t i = 0; i < c.planes.size(); ++i) {
      planes.push_back(
          Balls(geometry.Plane(static_cast<int>(i)).normal.vector));
    }
  }
}

/// The receiver's normal, times a power of two.
template <class W>
Vec3<W> ReceiverNormal(const WeightedContour& contour) {
  const Vector3& n = contour.view.normal;
  const double largest =
      std::max({std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)});
  // A component that becomes subnormal loses less than 2^-1074 of the largest.
  const int exponent = -std::ilogb(largest);
  return {FromDouble<W>(std::ldexp(n.x, exponent)),
          FromDouble<W>(std::ldexp(n.y, exponent)),
          FromDouble<W>(std::ldexp(n.z, exponent))};
}

template <class W>
Vec3<W> UnitVector(const Vec3<W>& v) {
  const W length = Sqrt(Dot(v, v));
  return {v.x / length, v.y / length, v.z / length};
}

template <class W>
const W& At(const Vec3<W>& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/// The triangle that stands for a facet; -1 if there is none.
int TriangleOf(const WeightedContour& contour, int facet) {
  const auto triangles = contour.view.triangles;
  const auto found =
      std::ranges::lower_bound(triangles, facet, {}, &Triangle::facet);
  if (found == triangles.end() || found->facet != facet) return -1;
  return static_cast<int>(found - triangles.begin());
}

/// A worse determinant is taken from exact numbers.
constexpr double kGoodDeterminant = 0x1p-100;

DoubleDoubleBall BallOfRounded(Multiprecision x) {
  if (IsZero(x)) return DoubleDoubleBall(0.0);
  const double high = x.ToDouble();
  mpfr_sub_d(x.get(), x.get(), high, MPFR_RNDN);
  return {{high, x.ToDouble()}, RoundBoundUp(0x1p-104 * std::fabs(high))};
}

}  // namespace

template <class W>
FrameGeometry<W>::FrameGeometry(const WeightedContour& contour,
                                mpfr_prec_t precision)
    : contour_(contour),
      precision_(precision),
      is_horizon_(PlanesOnHorizon(contour)) {
  for (const SourceArcs& source : contour.contour.sources)
    exponents_.push_back(LargestExponent(contour, source));
  LoadVectors(contour, precision, directions_, planes_);
  FindFrame();
  FindHorizon();
}

template <class W>
void FrameGeometry<W>::FindFrame() {
  const Vector3& n = contour_.view.normal;
  const std::array<double, 3> size = {std::fabs(n.x), std::fabs(n.y),
                                      std::fabs(n.z)};
  if (std::ranges::count(size, 0.0) == 2) {
    axis_ = static_cast<int>(std::ranges::max_element(size) - size.begin());
    negative_axis_ = n.x < 0 || n.y < 0 || n.z < 0;
    return;
  }
  const auto least = std::ranges::min_element(size) - size.begin();
  Vec3<W> normal = ReceiverNormal<W>(contour_);
  if constexpr (std::is_same_v<W, Multiprecision>) {
    // Exact numbers of 53 bits are to be divided at the full precision.
    const Multiprecision one(precision_, 1.0);
    normal = one * normal;
  }
  n_ = UnitVector(normal);
  const W zero = FromDouble<W>(0);
  // e x n for the axis e that is least along n.
  if (least == 0) u_ = UnitVector<W>({zero, -n_.z, n_.y});
  if (least == 1) u_ = UnitVector<W>({n_.z, zero, -n_.x});
  if (least == 2) u_ = UnitVector<W>({-n_.y, n_.x, zero});
  v_ = Cross(n_, u_);
}

template <class W>
Vec3<W> FrameGeometry<W>::ToFrame(const Vec3<W>& v) const {
  if (axis_ < 0) return {Dot(u_, v), Dot(v_, v), Dot(n_, v)};
  const W& next = At(v, (axis_ + 1) % 3);
  const W& last = At(v, (axis_ + 2) % 3);
  const W& along = At(v, axis_);
  if (negative_axis_) return {last, next, -along};
  return {next, last, along};
}

template <class W>
void FrameGeometry<W>::FindHorizon() {
  const Contour& c = contour_.contour;
  const RecipeEvaluator<Exact> exact(contour_.view);
  const Vec3<W> normal = ReceiverNormal<W>(contour_);
  for (std::size_t i = 0; i < c.directions.size(); ++i) {
    if constexpr (!std::is_same_v<W, Multiprecision>) {
      const W height = Dot(normal, directions_[i]);
      if (LowerMagnitude(height.value) > height.error) {
        on_horizon_.push_back(false);
        continue;
      }
    }
    const Vec3<Exact> d =
        exact.Direction(c.directions[i], c.planes, c.explicit_vectors.All());
    on_horizon_.push_back(Dot(exact.ReceiverNormal(), d).is_zero());
  }
}

template <class W>
W FrameGeometry<W>::OntoPlane(int source, int i) const {
  const Vec3<W>& d = directions_[static_cast<std::size_t>(i)];
  const int exponent = exponents_[static_cast<std::size_t>(source)];
  const int facet =
      contour_.contour.sources[static_cast<std::size_t>(source)].facet;
  const int triangle = facet < 0 ? -1 : TriangleOf(contour_, facet);
  double factor = 0;
  if (triangle >= 0) {
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
      const Multiprecision height(kConversionBits, exact.Height(triangle));
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
Vec3<W> FrameGeometry<W>::Point(int source, int i) const {
  const auto k = static_cast<std::size_t>(i);
  const DirectionRecipe& recipe = contour_.contour.directions[k];
  Vec3<W> point =
      IsVertex(recipe)
          ? Scaled(source, contour_.view.position, Vertex(contour_, recipe.a))
          : ToFrame(OntoPlane(source, i) * directions_[k]);
  point.z = on_horizon_[k] ? FromDouble<W>(0) : NotBelowZero(point.z);
  return point;
}

template <class W>
Vec3<W> FrameGeometry<W>::Between(int source, int i, int j) const {
  const DirectionRecipe& from =
      contour_.contour.directions[static_cast<std::size_t>(i)];
  const DirectionRecipe& to =
      contour_.contour.directions[static_cast<std::size_t>(j)];
  Vec3<W> difference;
  if (IsVertex(from) && IsVertex(to)) {
    difference = Edge(source, from.a, to.a);
  } else {
    difference = Point(source, j) - Point(source, i);
  }
  if (OnHorizon(i) && OnHorizon(j)) difference.z = FromDouble<W>(0);
  return difference;
}

template <class W>
Vec3<W> FrameGeometry<W>::Scaled(int source, const Point3& a,
                                 const Point3& b) const {
  return ToFrame(TimesTwoTo(Difference<W>(a, b, precision_),
                            -exponents_[static_cast<std::size_t>(source)]));
}

template <class W>
Vec3<W> FrameGeometry<W>::Edge(int source, int a, int b) const {
  return Scaled(source, Vertex(contour_, a), Vertex(contour_, b));
}

template <class W>
Vec3<W> FrameGeometry<W>::Plane(int i) const {
  Vec3<W> normal = ToFrame(planes_[static_cast<std::size_t>(i)]);
  if (IsHorizon(i)) normal.x = normal.y = FromDouble<W>(0);
  return normal;
}

template <class W>
W FrameGeometry<W>::UnitDeterminant(int a, int b, int c) const {
  const std::array<std::size_t, 3> ends = {static_cast<std::size_t>(a),
                                           static_cast<std::size_t>(b),
                                           static_cast<std::size_t>(c)};
  if constexpr (!std::is_same_v<W, Multiprecision>) {
    const Vec3<W>& x = directions_[ends[0]];
    const Vec3<W>& y = directions_[ends[1]];
    const Vec3<W>& z = directions_[ends[2]];
    const W determinant = Determinant(x, y, z) / Sqrt(Dot(x, x)) /
                          Sqrt(Dot(y, y)) / Sqrt(Dot(z, z));
    if (determinant.error <=
        kGoodDeterminant * LowerMagnitude(determinant.value)) {
      return determinant;
    }
  }
  const RecipeEvaluator<Exact> exact(contour_.view);
  const Contour& contour = contour_.contour;
  std::array<Vec3<Exact>, 3> d;
  for (std::size_t k = 0; k < 3; ++k) {
    d[k] = exact.Direction(contour.directions[ends[k]], contour.planes,
                           contour.explicit_vectors.All());
  }
  const mpfr_prec_t precision =
      std::is_same_v<W, Multiprecision> ? precision_ : kConversionBits;
  Multiprecision result(precision, Determinant(d[0], d[1], d[2]));
  for (const Vec3<Exact>& v : d) {
    result = result / Sqrt(Multiprecision(precision, Dot(v, v)));
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
