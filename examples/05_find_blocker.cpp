// SPDX-License-Identifier: GPL-3.0-or-later
// Where is the blocker? From 20 measured irradiances below a lamp, by
// Gauss-Newton with exact derivatives by the blocker's vertices.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <vector>

#include "truelux/truelux.h"

namespace {

using truelux::Point3;
using truelux::Vector3;

/// A lamp of 4 m^2 two metres up, and a triangle at some place below it.
truelux::Scene SceneWith(const Vector3& place) {
  truelux::SceneBuilder builder;
  builder.AddFace({{-1, -1, 2}, {-1, 1, 2}, {1, 1, 2}, {1, -1, 2}}, {1, 1, 1});
  std::vector<Point3> blocker = {
      {-0.5, -0.25, 1}, {0.625, -0.375, 1.125}, {0.125, 0.5, 0.875}};
  for (Point3& p : blocker)
    p = {p.x + place.x, p.y + place.y, p.z + place.z};
  builder.AddFace(blocker);
  return *builder.Build().value;
}

std::vector<truelux::Receiver> Receivers() {
  std::vector<truelux::Receiver> receivers;
  for (int i = 0; i < 20; ++i) {
    receivers.push_back(
        {{-0.8 + 0.4 * (i % 5), -0.6 + 0.4 * (i / 5), 0.05 * (i % 3)},
         {0, 0, 1}});
  }
  return receivers;
}

/// Solves the 3 x 3 system a x = b, a symmetric and positive, by elimination.
std::array<double, 3> Solved(std::array<std::array<double, 3>, 3> a,
                             std::array<double, 3> b) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = i + 1; k < 3; ++k) {
      const double factor = a[k][i] / a[i][i];
      for (std::size_t j = i; j < 3; ++j)
        a[k][j] -= factor * a[i][j];
      b[k] -= factor * b[i];
    }
  }
  for (std::size_t i = 3; i-- > 0;) {
    for (std::size_t j = i + 1; j < 3; ++j)
      b[i] -= a[i][j] * b[j];
    b[i] /= a[i][i];
  }
  return b;
}

}  // namespace

int main() {
  const Vector3 truth = {0.13, -0.21, 0.17};
  const std::vector<truelux::Receiver> receivers = Receivers();
  std::vector<double> measured;
  for (const truelux::Irradiance& e :
       truelux::Oracle(SceneWith(truth)).Evaluate(receivers)) {
    measured.push_back(e.value[0]);
  }

  Vector3 place = {0, 0, 0};
  for (int step = 0; step < 10; ++step) {
    const truelux::Oracle oracle(SceneWith(place));
    std::array<std::array<double, 3>, 3> normal{};
    std::array<double, 3> right{};
    for (std::size_t i = 0; i < receivers.size(); ++i) {
      const auto found = oracle.VertexDerivatives(receivers[i]);
      const double residual = measured[i] - found.irradiance.value[0];
      // The triangle moves as one: its vertices 5, 6 and 7 together.
      std::array<double, 3> slope{};
      for (const truelux::VertexDerivative& vertex : found.vertices) {
        for (std::size_t k = 0; k < 3 && vertex.number >= 5; ++k)
          slope[k] += vertex.slopes[0][k].left;
      }
      for (std::size_t k = 0; k < 3; ++k) {
        right[k] += slope[k] * residual;
        for (std::size_t j = 0; j < 3; ++j)
          normal[k][j] += slope[k] * slope[j];
      }
    }
    const std::array<double, 3> change = Solved(normal, right);
    place = {place.x + change[0], place.y + change[1], place.z + change[2]};
    const double error =
        std::hypot(place.x - truth.x, place.y - truth.y, place.z - truth.z);
    std::printf("step %d: (%.12f, %.12f, %.12f), off by %.1e\n", step + 1,
                place.x, place.y, place.z, error);
    if (error < 1e-12) {
      std::printf("found in %d steps\n", step + 1);
      return 0;
    }
  }
  return 1;
}
