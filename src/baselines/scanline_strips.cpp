// SPDX-License-Identifier: GPL-3.0-or-later
#include "baselines/scanline_strips.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace truelux {
namespace {

constexpr double kCoplanar = 1 - 1e-12;

/// A triangle cut by two planes has up to five corners.
struct CutTriangle {
  std::array<ShadowPoint, 5> points;
  std::size_t size = 0;

  void Add(const ShadowPoint& p) { points[size++] = p; }
};

/// The part with sign * (s - level) >= 0.
CutTriangle Cut(const CutTriangle& polygon, double sign, double level) {
  CutTriangle kept;
  for (std::size_t k = 0; k < polygon.size; ++k) {
    const ShadowPoint& a = polygon.points[k];
    const ShadowPoint& b = polygon.points[(k + 1) % polygon.size];
    const double a_side = sign * (a.s - level);
    const double b_side = sign * (b.s - level);
    if (a_side >= 0) kept.Add(a);
    if ((a_side > 0 && b_side < 0) || (a_side < 0 && b_side > 0)) {
      const double t = a_side / (a_side - b_side);
      kept.Add({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), level});
    }
  }
  return kept;
}

/// Whether all corners are on one outer side of the window. y - c s is linear
/// over the triangle, so that its sign at the corners holds for all points.
bool Misses(const std::array<ShadowPoint, 3>& triangle, const Window& window) {
  const auto all = [&triangle](auto outside) {
    return outside(triangle[0]) && outside(triangle[1]) && outside(triangle[2]);
  };
  using P = const ShadowPoint&;
  return all([&](P p) { return p.s > kCoplanar; }) ||
         all([&](P p) { return p.s < kNearest; }) ||
         all([&](P p) { return p.y >= window.y_high * p.s; }) ||
         all([&](P p) { return p.y <= window.y_low * p.s; }) ||
         all([&](P p) { return p.x >= window.x_high * p.s; }) ||
         all([&](P p) { return p.x <= window.x_low * p.s; });
}

struct Point2 {
  double x = 0;
  double y = 0;
};

Line LineThrough(const Point2& a, const Point2& b) {
  return {a.x, a.y, (b.x - a.x) / (b.y - a.y)};
}

}  // namespace

int Rows::FirstFrom(double y) const {
  const double row = std::ceil((y - first) / step - 0.5);
  return static_cast<int>(std::clamp(row, 0.0, static_cast<double>(count)));
}

void AppendShadow(const std::array<ShadowPoint, 3>& triangle,
                  const Window& window, const Rows& rows,
                  std::vector<Strip>& strips) {
  if (Misses(triangle, window)) return;
  CutTriangle polygon;
  for (const ShadowPoint& p : triangle)
    polygon.Add(p);
  polygon = Cut(Cut(polygon, 1, kNearest), -1, 1);

  std::array<Point2, 5> shadow;
  std::array<double, 5> levels{};
  for (std::size_t k = 0; k < polygon.size; ++k) {
    const ShadowPoint& p = polygon.points[k];
    shadow[k] = {p.x / p.s, p.y / p.s};
    levels[k] = shadow[k].y;
  }
  const auto used = static_cast<std::ptrdiff_t>(polygon.size);
  std::sort(levels.begin(), levels.begin() + used);
  for (std::size_t i = 0; i + 1 < polygon.size; ++i) {
    Strip strip{
        rows.FirstFrom(levels[i]), rows.FirstFrom(levels[i + 1]), {}, {}};
    if (strip.first >= strip.end) continue;
    // Between two levels a convex polygon has one edge on either side.
    const double middle = levels[i] + (levels[i + 1] - levels[i]) / 2;
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (std::size_t k = 0; k < polygon.size; ++k) {
      const Point2& a = shadow[k];
      const Point2& b = shadow[(k + 1) % polygon.size];
      if ((a.y <= middle) == (b.y <= middle)) continue;
      const Line line = LineThrough(a, b);
      const double x = line.At(middle);
      if (x < least) {
        least = x;
        strip.left = line;
      }
      if (x > most) {
        most = x;
        strip.right = line;
      }
    }
    if (least < most) strips.push_back(strip);
  }
}

}  // namespace truelux
