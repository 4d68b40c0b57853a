// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/light_ceiling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "isolux/lamp_pieces.h"

namespace truelux {
namespace {

/// The part of a triangle at heights >= 0.
std::vector<Vec3<double>> AboveSurface(const LampTriangle& corners) {
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

}  // namespace

double UnblockedLight(const LightFeatures& features, const Sight& sight,
                      const PlanPoint& p) {
  const Vec3<double> r = {p.s, p.t, 0};
  double light = 0;
  for (const LampSight& seen : sight) {
    const Lamp& lamp = features.lamps()[static_cast<std::size_t>(seen.lamp)];
    if (lamp.plane.HeightOf(p) <= 0) continue;
    for (const LampTriangle& corners : lamp.triangles)
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
    const double tilt = std::hypot(lamp.plane.normal.x, lamp.plane.normal.y);
    // The integral of |grad (z l / rho^4)|, at most.
    const auto term = [&](const LampPiece& piece) {
      const double square = piece.distance * piece.distance;
      return piece.area * piece.high / (square * square) *
             (tilt + 4 * height / piece.distance);
    };
    for (const LampTriangle& corners : lamp.triangles) {
      slope += lamp.exitance / std::numbers::pi *
               SumOverPieces(corners, {{middle.s, middle.t, 0}, radius}, term);
    }
  }
  // Rounding: Lambert's terms are at most 1/2 each.
  return (1 + 0x1p-20) *
             (UnblockedLight(features, sight, middle) + slope * radius) +
         0x1p-40;
}

}  // namespace truelux
