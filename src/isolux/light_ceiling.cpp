// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/light_ceiling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace truelux {
namespace {

using Corners = std::array<Vec3<double>, 3>;

constexpr int kMostHalvings = 24;
constexpr double kFine = 0.5;

double LengthOf(const Vec3<double>& v) {
  return std::sqrt(Dot(v, v));
}

/// The part of a triangle at heights >= 0.
std::vector<Vec3<double>> AboveSurface(const Corners& corners) {
  std::vector<Vec3<double>> above;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3<double>& a = corners[k];
    const Vec3<double>& b = corners[(k + 1) % 3];
    if (a.z >= 0) above.push_back(a);
    if ((a.z < 0 && b.z > 0) || (a.z > 0 && b.z < 0))
      above.push_back(a + (a.z / (a.z - b.z)) * (b - a));
  }
  return above;
}

/// Lambert's sum over the sides: the form factor of a polygon above the surface.
double FormFactorOf(std::span<const Vec3<double>> ring, const Vec3<double>& r) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec3<double> a = ring[i] - r;
    const Vec3<double> b = ring[(i + 1) % ring.size()] - r;
    const Vec3<double> across = Cross(a, b);
    const double sine = LengthOf(across);
    if (sine > 0) sum += std::atan2(sine, Dot(a, b)) * across.z / sine;
  }
  return std::fabs(sum) / (2 * std::numbers::pi);
}

/// The integral of |grad (z l / rho^4)| over a triangle, at most.
class SlopeFinder {
 public:
  SlopeFinder(const Vec3<double>& middle, double radius, double tilt,
              double height)
      : middle_(middle), radius_(radius), tilt_(tilt), height_(height) {}

  [[nodiscard]] double Over(const Corners& corners, int depth) const {
    const auto& [a, b, c] = corners;
    const double high = std::max({a.z, b.z, c.z});
    if (high <= 0) return 0;
    const Vec3<double> centre = (1.0 / 3) * (a + b + c);
    const double spread = std::max(
        {LengthOf(a - centre), LengthOf(b - centre), LengthOf(c - centre)});
    const double to_centre = LengthOf(centre - middle_) - radius_;
    if (to_centre <= 0) return HUGE_VAL;
    const double distance = to_centre - spread;
    if (spread > kFine * distance) {
      if (depth >= kMostHalvings) return HUGE_VAL;
      const Vec3<double> ab = 0.5 * (a + b);
      const Vec3<double> bc = 0.5 * (b + c);
      const Vec3<double> ca = 0.5 * (c + a);
      return Over({a, ab, ca}, depth + 1) + Over({ab, b, bc}, depth + 1) +
             Over({ca, bc, c}, depth + 1) + Over({ab, bc, ca}, depth + 1);
    }
    const double square = distance * distance;
    return LengthOf(Cross(b - a, c - a)) / 2 * high / (square * square) *
           (tilt_ + 4 * height_ / distance);
  }

 private:
  Vec3<double> middle_;
  double radius_;
  double tilt_;
  double height_;
};

}  // namespace

double UnblockedLight(const LightFeatures& features, const Sight& sight,
                      const PlanPoint& p) {
  const Vec3<double> r = {p.s, p.t, 0};
  double light = 0;
  for (const LampSight& seen : sight) {
    const Lamp& lamp = features.lamps()[static_cast<std::size_t>(seen.lamp)];
    if (lamp.plane.HeightOf(p) <= 0) continue;
    for (const Corners& corners : lamp.triangles)
      light += lamp.exitance * FormFactorOf(AboveSurface(corners), r);
  }
  return light;
}

double LightCeiling(const LightFeatures& features, const Sight& sight,
                    std::span<const PlanPoint> points) {
  PlanPoint middle;
  for (const PlanPoint& p : points)
    middle = middle + (1 / static_cast<double>(points.size())) * p;
  double radius = 0x1p-40 * features.size();
  for (const PlanPoint& p : points)
    radius = std::max(radius, truelux::LengthOf(p - middle));
  double slope = 0;
  for (const LampSight& seen : sight) {
    const Lamp& lamp = features.lamps()[static_cast<std::size_t>(seen.lamp)];
    double height = 0;
    for (const PlanPoint& p : points)
      height = std::max(height, lamp.plane.HeightOf(p));
    const SlopeFinder finder(
        {middle.s, middle.t, 0}, radius,
        std::hypot(lamp.plane.normal.x, lamp.plane.normal.y), height);
    for (const Corners& corners : lamp.triangles) {
      slope += lamp.exitance / std::numbers::pi * finder.Over(corners, 0);
    }
  }
  // Rounding: Lambert's terms are at most 1/2 each.
  return (1 + 0x1p-20) *
             (UnblockedLight(features, sight, middle) + slope * radius) +
         0x1p-40;
}

}  // namespace truelux
