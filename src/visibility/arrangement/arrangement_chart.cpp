// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/arrangement/arrangement_chart.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "exact/exact_conversion.h"

namespace truelux {
namespace {

Vec3<Exact> Sum(const Vec3<Exact>& a, const Vec3<Exact>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

/// Where the segment from a to b crosses the plane f = 0; f_a > 0 > f_b or
/// the other way round. f is linear in the offset, so its value at a point is
/// f(offset) / scale and both scales cancel from the position.
WorldPoint Crossing(const WorldPoint& a, const Exact& f_a, const WorldPoint& b,
                    const Exact& f_b) {
  if (SignOf(f_a) == Sign::kNegative) return Crossing(b, f_b, a, f_a);
  return {f_a * b.offset - f_b * a.offset, f_a * b.scale - f_b * a.scale};
}

/// The part of a convex polygon with wall . p >= 0. A polygon with area that
/// has a point inside keeps area; one that only touches the wall is dropped.
std::vector<WorldPoint> ClipToHalfSpace(const std::vector<WorldPoint>& polygon,
                                        const Vec3<Exact>& wall) {
  const std::size_t size = polygon.size();
  std::vector<Exact> value;
  std::vector<Sign> side;
  for (const WorldPoint& p : polygon) {
    value.push_back(Dot(wall, p.offset));
    side.push_back(SignOf(value.back()));
  }
  std::vector<WorldPoint> kept;
  if (std::find(side.begin(), side.end(), Sign::kPositive) == side.end()) {
    return kept;
  }
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t next = (i + 1) % size;
    if (side[i] != Sign::kNegative) kept.push_back(polygon[i]);
    if (side[i] * side[next] == Sign::kNegative) {
      kept.push_back(
          Crossing(polygon[i], value[i], polygon[next], value[next]));
    }
  }
  return kept;
}

/// The normal times a power of two, its largest component in [1/2, 1): so
/// that directions computed from it stay far from the ends of binary64.
Vec3<Exact> Scaled(const Vector3& normal) {
  const double largest =
      std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
  if (!(largest > 0)) throw std::invalid_argument("the normal is zero");
  int exponent = 0;
  std::frexp(largest, &exponent);
  return {TimesPowerOfTwo(Exact(normal.x), -exponent),
          TimesPowerOfTwo(Exact(normal.y), -exponent),
          TimesPowerOfTwo(Exact(normal.z), -exponent)};
}

}  // namespace

ViewChart::ViewChart(const Vec3<Exact>& receiver_normal,
                     const Vec3<Exact>& cut_a, const Vec3<Exact>& cut_b)
    : row_x_(cut_a), row_y_(cut_b), row_n_(receiver_normal) {
  if (SignOf(Determinant(row_x_, row_y_, row_n_)) == Sign::kNegative) {
    std::swap(row_x_, row_y_);
  }
  row_w_ = Sum(row_n_, Sum(row_x_, row_y_));
  column_x_ = Cross(row_y_, row_w_);
  column_y_ = Cross(row_w_, row_x_);
  column_w_ = Cross(row_x_, row_y_);
}

std::vector<WorldPoint> ViewChart::Clip(
    const std::array<Vec3<Exact>, 3>& triangle) const {
  assert(SignOf(Determinant(triangle[0], triangle[1], triangle[2])) !=
         Sign::kZero);
  std::vector<WorldPoint> polygon;
  polygon.reserve(triangle.size());
  for (const Vec3<Exact>& corner : triangle) {
    polygon.push_back({corner, Exact(1)});
  }
  for (const Vec3<Exact>* wall : {&row_n_, &row_x_, &row_y_}) {
    if (!polygon.empty()) polygon = ClipToHalfSpace(polygon, *wall);
  }
  return polygon;
}

ImagePoint ViewChart::ImageFromWorld(const WorldPoint& point) const {
  ImagePoint image{Dot(row_x_, point.offset), Dot(row_y_, point.offset),
                   -point.scale, Dot(row_w_, point.offset)};
  if (SignOf(image.w) != Sign::kPositive) {
    throw std::logic_error("a point outside its chart");
  }
  return image;
}

Vec3<Exact> ViewChart::WorldFromImage(const ImageDirection& direction) const {
  return Sum(Sum(direction.x * column_x_, direction.y * column_y_),
             direction.z * column_w_);
}

bool ViewChart::OnHorizon(const ImageDirection& direction) {
  return direction.x + direction.y == direction.z;
}

bool ViewChart::OnCutA(const ImageDirection& direction) {
  return direction.x.is_zero();
}

bool ViewChart::OnCutB(const ImageDirection& direction) {
  return direction.y.is_zero();
}

std::array<ViewChart, 4> ViewChartsOf(const Vector3& normal) {
  const Vec3<Exact> n = Scaled(normal);
  // n x e for the two axes e in which n is not largest: orthogonal to n, of
  // degree 1, and independent because n is not in the span of the two axes.
  const Exact zero(0);
  const Vec3<Exact> cross_x{zero, n.z, -n.y};
  const Vec3<Exact> cross_y{-n.z, zero, n.x};
  const Vec3<Exact> cross_z{n.y, -n.x, zero};
  const double x = std::abs(normal.x);
  const double y = std::abs(normal.y);
  const double z = std::abs(normal.z);
  const bool x_largest = x >= y && x >= z;
  const bool y_largest = !x_largest && y >= z;
  const Vec3<Exact>& a = x_largest ? cross_y : cross_x;
  const Vec3<Exact>& b = x_largest || y_largest ? cross_z : cross_y;
  return {ViewChart(n, a, b), ViewChart(n, a, -b), ViewChart(n, -a, b),
          ViewChart(n, -a, -b)};
}

}  // namespace truelux
