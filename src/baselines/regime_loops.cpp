// SPDX-License-Identifier: GPL-3.0-or-later
#include "baselines/regime_loops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

#include "baselines/case_chart.h"

namespace truelux {
namespace {

constexpr double kPi = std::numbers::pi;

/// 3 to 6 points around the origin at distances up to 1, clockwise: 60 % near
/// the unit circle, 40 % star-shaped.
std::vector<ChartPoint> Outline(CaseRandom& random) {
  constexpr std::array<int, 5> kCounts = {3, 3, 4, 5, 6};
  const int count = kCounts[static_cast<std::size_t>(random.Below(5))];
  const double least = random.Uniform(0, 1) < 0.4 ? 0.3 : 0.8;
  std::vector<ChartPoint> outline;
  for (int k = count; k-- > 0;) {
    const double angle = 2 * kPi * (k + random.Uniform(-0.35, 0.35)) / count;
    const double radius = random.Uniform(least, 1);
    outline.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return outline;
}

double AnyAzimuth(CaseRandom& random) {
  return random.Uniform(-kPi, kPi);
}

/// A tilted outline of that width and height at an elevation [rad].
Loop Place(CaseRandom& random, double elevation, double width, double height,
           double most_tilt) {
  const CaseChart chart = CaseChart::Looking(AnyAzimuth(random), elevation);
  const double distance = random.Uniform(0.5, 5);
  const double a = random.Uniform(-most_tilt, most_tilt);
  const double b = random.Uniform(-most_tilt, most_tilt);
  const double turn = random.Uniform(0, 2 * kPi);
  const double c = std::cos(turn);
  const double s = std::sin(turn);
  Loop loop;
  for (const ChartPoint& q : Outline(random)) {
    const double x = width * q.x;
    const double y = height * q.y;
    const ChartPoint turned{x * c - y * s, x * s + y * c};
    const double tilt = a * turned.x + b * turned.y;
    loop.push_back(chart.At(
        turned, std::abs(tilt) < 0.7 ? distance / (1 - tilt) : distance));
  }
  return loop;
}

bool AllAbove(const Loop& loop, double z) {
  return std::ranges::all_of(loop, [z](const Point3& p) { return p.z > z; });
}

/// In the plane z = height, turned about the axis and scaled.
Loop Parallel(const std::vector<ChartPoint>& outline, double turn, double scale,
              double height) {
  const double c = std::cos(turn);
  const double s = std::sin(turn);
  Loop loop;
  for (const ChartPoint& q : outline) {
    loop.push_back(
        {scale * (c * q.x - s * q.y), scale * (s * q.x + c * q.y), height});
  }
  return loop;
}

/// Whether the outline winds around the origin in steps of less than 2.7 rad.
bool WindsAroundOrigin(const std::vector<ChartPoint>& outline) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const ChartPoint& p = outline[i];
    const ChartPoint& q = outline[(i + 1) % outline.size()];
    const double step = std::atan2(p.y, p.x) - std::atan2(q.y, q.x);
    if (step - 2 * kPi * std::floor(step / (2 * kPi)) >= 2.7) return false;
  }
  return true;
}

Vector3 Cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double LengthOf(const Vector3& v) {
  return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

Vector3 Unit(const Vector3& v) {
  const double length = LengthOf(v);
  return {v.x / length, v.y / length, v.z / length};
}

Vector3 AnyDirection(CaseRandom& random) {
  while (true) {
    const double x = random.Uniform(-1, 1);
    const double y = random.Uniform(-1, 1);
    const double z = random.Uniform(-1, 1);
    const double length = LengthOf({x, y, z});
    if (length > 0.1 && length < 1) return Unit({x, y, z});
  }
}

/// Any chart with that axis.
CaseChart Around(const Vector3& axis) {
  const Vector3 other =
      std::abs(axis.x) < 0.6 ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
  const Vector3 right = Unit(Cross(other, axis));
  return {axis, right, Cross(axis, right)};
}

double Determinant(const Point3& a, const Point3& b, const Point3& c) {
  return a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
         a.z * (b.x * c.y - b.y * c.x);
}

/// Whether a b and c d cross as seen from the origin; all above z = 0.
bool SidesCross(const Point3& a, const Point3& b, const Point3& c,
                const Point3& d) {
  return Determinant(a, b, c) * Determinant(a, b, d) < 0 &&
         Determinant(c, d, a) * Determinant(c, d, b) < 0;
}

/// Whether a loop above z = 0 is simple and counter-clockwise as seen from the
/// origin. Multiplying all z by a positive number changes neither, and rounding
/// does not matter where z is not small.
bool IsGoodContour(const Loop& loop) {
  double form_factor = 0;  // by Lambert's formula, times a constant
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point3& p = loop[i];
    const Point3& q = loop[(i + 1) % loop.size()];
    // Sides without a common corner.
    const std::size_t end = loop.size() - (i == 0 ? 1 : 0);
    for (std::size_t j = i + 2; j < end; ++j) {
      if (SidesCross(p, q, loop[j], loop[(j + 1) % loop.size()])) return false;
    }
    const Vector3 across = Cross({p.x, p.y, p.z}, {q.x, q.y, q.z});
    const double length = LengthOf(across);
    const double along = p.x * q.x + p.y * q.y + p.z * q.z;
    form_factor -= std::atan2(length, along) * across.z / length;
  }
  return form_factor > 0;
}

/// An outline bent around the axis, at elevations of 1 and more.
Loop Bent(CaseRandom& random) {
  const double azimuth = AnyAzimuth(random);
  const double width = random.Uniform(0.3, 0.6);
  const double distance = random.Uniform(0.5, 5);
  Loop loop;
  for (const ChartPoint& q : Outline(random)) {
    const double at = azimuth + width * q.x;
    const double radius = distance * (1 + 0.3 * q.x);
    loop.push_back({radius * std::cos(at), radius * std::sin(at),
                    distance * (1.5 + 0.5 * q.y)});
  }
  return loop;
}

/// An outline whose `count` lowest points are moved down to the horizon.
Loop Lowered(CaseRandom& random, int count) {
  const double azimuth = AnyAzimuth(random);
  const double distance = random.Uniform(0.5, 5);
  std::vector<ChartPoint> outline;
  do {
    outline = Outline(random);
  } while (!std::ranges::all_of(outline, [](const ChartPoint& q) {
    return std::hypot(q.x, q.y) > 0.75;
  }));
  std::vector<std::size_t> by_height(outline.size());
  std::iota(by_height.begin(), by_height.end(), std::size_t{0});
  std::ranges::sort(by_height, {}, [&](std::size_t i) { return outline[i].y; });
  std::vector<double> elevations(outline.size());
  for (std::size_t i = 0; i < outline.size(); ++i)
    elevations[i] = 0.55 + 0.4 * outline[i].y;
  for (int i = 0; i < count; ++i) {
    elevations[by_height[static_cast<std::size_t>(i)]] =
        1e-12 * random.Uniform(1, 3);
  }
  Loop loop;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const double at = azimuth + 0.5 * outline[i].x;
    const double horizontal = distance * std::cos(elevations[i]);
    loop.push_back({horizontal * std::cos(at), horizontal * std::sin(at),
                    distance * std::sin(elevations[i])});
  }
  return loop;
}

}  // namespace

Loop LoopOfSize(CaseRandom& random, double size) {
  while (true) {
    Loop loop =
        Place(random, random.Uniform(0.2, 1.55), size / 2, size / 2, 1.5);
    if (AllAbove(loop, 0.02)) return loop;
  }
}

Loop LowLoop(CaseRandom& random, double elevation) {
  return Place(random, elevation, 0.3 * elevation, 0.3 * elevation, 1.5);
}

// Bending an outline around the horizon, or moving points down to it, now and
// then turns a triangle over: then another one is drawn.

Loop WideLowLoop(CaseRandom& random, double elevation) {
  while (true) {
    Loop loop = Bent(random);
    if (!IsGoodContour(loop)) continue;
    for (Point3& p : loop)
      p.z *= elevation;
    return loop;
  }
}

Loop LoopDownToTheHorizon(CaseRandom& random, int count) {
  while (true) {
    Loop loop = Lowered(random, count);
    if (IsGoodContour(loop)) return loop;
  }
}

Loop SliverLoop(CaseRandom& random, double length, double width) {
  return Place(random, random.Uniform(0.4, 1.2), length / 2, width / 2, 0.5);
}

Loop LoopSeenFlat(CaseRandom& random, double distance) {
  while (true) {
    const double elevation = random.Uniform(0.5, 1.2);
    const CaseChart chart = CaseChart::Looking(AnyAzimuth(random), elevation);
    const double turn = random.Uniform(-1.2, 1.2);
    const double c = std::cos(turn);
    const double s = std::sin(turn);
    const Vector3 along{c * chart.right.x + s * chart.up.x,
                        c * chart.right.y + s * chart.up.y,
                        c * chart.right.z + s * chart.up.z};
    const Vector3& out = chart.axis;
    const Vector3 normal = Cross(out, along);
    const double away = random.Uniform(1.5, 3);
    Loop loop;
    for (const ChartPoint& q : Outline(random)) {
      const double x = away + 0.6 * q.x;
      const double y = 0.6 * q.y;
      loop.push_back({x * out.x + y * along.x + distance * normal.x,
                      x * out.y + y * along.y + distance * normal.y,
                      x * out.z + y * along.z + distance * normal.z});
    }
    if (AllAbove(loop, 0.05)) return loop;
  }
}

Loop LoopInFloor(CaseRandom& random, double height, bool around_zenith) {
  const double size = random.Uniform(0.5, 3);
  const double turn = AnyAzimuth(random);
  std::vector<ChartPoint> outline;
  if (around_zenith) {
    do {
      outline = Outline(random);
    } while (!WindsAroundOrigin(outline));
  } else {
    const double beside = random.Uniform(1.5, 3);
    outline = Outline(random);
    for (ChartPoint& q : outline)
      q.x += beside;
  }
  return Parallel(outline, turn, size, size * height);
}

Loop LoopWithVerticalEdges(CaseRandom& random, double slope) {
  const double x0 = random.Uniform(-2, 2);
  const double x1 = x0 + random.Uniform(0.5, 1.5);
  const double y0 = random.Uniform(-2, 0);
  const double y1 = random.Uniform(0.3, 2);
  const double scale = random.Uniform(0.5, 3);
  const std::vector<ChartPoint> outline = {
      {x0, y0},
      {x0 + slope * random.Uniform(-1, 1), y0 + y1},
      {x1, y0 + 1.2 * y1},
      {x1 + slope * random.Uniform(-1, 1), y0 - 0.1}};
  return Parallel(outline, 0, scale, scale);
}

Loop LoopBesideTheAxis(CaseRandom& random, double distance) {
  const double turn = random.Uniform(0, 2 * kPi);
  const double scale = random.Uniform(0.5, 3);
  const std::vector<ChartPoint> outline = {
      {-random.Uniform(0.2, 1), distance},
      {random.Uniform(-0.1, 0.1), random.Uniform(0.5, 1)},
      {random.Uniform(0.2, 1), distance}};
  return Parallel(outline, turn, scale, scale);
}

RegimeCase FarCase(CaseRandom& random, double offset, double size) {
  const CaseChart level = Around(AnyDirection(random));
  const double azimuth = AnyAzimuth(random);
  const double elevation = random.Uniform(0.95, 1.4);
  const Point3 axis = level.At({std::cos(azimuth) / std::tan(elevation),
                                std::sin(azimuth) / std::tan(elevation)},
                               std::sin(elevation));
  const CaseChart chart = Around(Unit({axis.x, axis.y, axis.z}));
  const auto coordinate = [&] {
    const double far = offset * random.Uniform(-1, 1);
    return far + random.Uniform(-1, 1);
  };
  const double x = coordinate();
  const double y = coordinate();
  const double z = coordinate();
  RegimeCase result{{}, {{x, y, z}, level.axis, 0}, {}};
  const int count = 3 + random.Below(3);
  const double a = random.Uniform(-0.6, 0.6);
  const double b = random.Uniform(-0.6, 0.6);
  for (int k = count; k-- > 0;) {
    const double angle = 2 * kPi * (k + random.Uniform(-0.3, 0.3)) / count;
    const ChartPoint q{size / 2 * std::cos(angle), size / 2 * std::sin(angle)};
    const double tilt = 1 + a * q.x + b * q.y;
    const Point3 p = chart.At({q.x / tilt, q.y / tilt}, 1.5 * tilt);
    result.loop.push_back({x + p.x, y + p.y, z + p.z});
  }
  return result;
}

}  // namespace truelux
