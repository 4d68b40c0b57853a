// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene_parts.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>

#include "truelux/irradiance.h"

#include "exact/vec3.h"

namespace truelux::bench {
namespace {

using Vec = Vec3<double>;

constexpr double kLeg = 0.05;

}  // namespace

Vec RandomUnit(PortableRandom& random) {
  const double z = random.Uniform(-1, 1);
  const double angle = random.Uniform(0, 2 * std::numbers::pi);
  const double radius = std::sqrt(1 - z * z);
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

TestFace UnitLamp() {
  return {testing::Ceiling(-0.5, 0.5, -0.5, 0.5, 1), kWhite};
}

Point3 ToFloat(const Point3& p) {
  const auto round = [](double x) {
    return static_cast<double>(static_cast<float>(x));
  };
  return {round(p.x), round(p.y), round(p.z)};
}

Ring RandomTriangle(PortableRandom& random, const Point3& centre,
                    double circumradius) {
  const Vec normal = RandomUnit(random);
  Vec side = Cross(normal, RandomUnit(random));
  side = 1 / std::sqrt(Dot(side, side)) * side;
  const Vec up = Cross(normal, side);
  const double turn = random.Uniform(0, 2 * std::numbers::pi);
  Ring ring;
  for (int k = 0; k < 3; ++k) {
    const double angle = turn + k * 2 * std::numbers::pi / 3;
    const double a = circumradius * std::cos(angle);
    const double b = circumradius * std::sin(angle);
    ring.push_back(ToFloat({centre.x + a * side.x + b * up.x,
                            centre.y + a * side.y + b * up.y,
                            centre.z + a * side.z + b * up.z}));
  }
  return ring;
}

Receiver RandomReceiver(PortableRandom& random, double half) {
  const double x = random.Uniform(-half, half);
  const double y = random.Uniform(-half, half);
  return {ToFloat({x, y, 0}), {0, 0, 1}, 0};
}

std::vector<Receiver> PenumbraReceivers(const Scene& scene,
                                        const TestFace& first_face, int count,
                                        const std::function<Receiver()>& draw) {
  const Oracle oracle(scene, {.method = Method::kDouble});
  const Oracle alone(testing::MakeScene({first_face}),
                     {.method = Method::kDouble});
  std::vector<Receiver> kept;
  for (int tries = 1000 + 100 * count; tries > 0; --tries) {
    if (static_cast<int>(kept.size()) == count) return kept;
    const Receiver receiver = draw();
    const double whole = alone.FormFactor(receiver, 1).value[0];
    const double visible = oracle.FormFactor(receiver, 1).value[0];
    if (visible >= 0.05 * whole && visible <= 0.95 * whole)
      kept.push_back(receiver);
  }
  throw std::runtime_error("too few receivers in the penumbra");
}

void AppendBox(std::vector<TestFace>& faces, const Point3& a, const Point3& b) {
  for (const Ring& ring : {
           Ring{{a.x, a.y, a.z},
                {a.x, b.y, a.z},
                {b.x, b.y, a.z},
                {b.x, a.y, a.z}},
           Ring{{a.x, a.y, b.z},
                {b.x, a.y, b.z},
                {b.x, b.y, b.z},
                {a.x, b.y, b.z}},
           Ring{{a.x, a.y, a.z},
                {b.x, a.y, a.z},
                {b.x, a.y, b.z},
                {a.x, a.y, b.z}},
           Ring{{a.x, b.y, a.z},
                {a.x, b.y, b.z},
                {b.x, b.y, b.z},
                {b.x, b.y, a.z}},
           Ring{{a.x, a.y, a.z},
                {a.x, a.y, b.z},
                {a.x, b.y, b.z},
                {a.x, b.y, a.z}},
           Ring{{b.x, a.y, a.z},
                {b.x, b.y, a.z},
                {b.x, b.y, b.z},
                {b.x, a.y, b.z}},
       }) {
    faces.push_back({ring, testing::kBlack});
  }
}

void AppendTable(std::vector<TestFace>& faces, double x0, double x1, double y0,
                 double y1, double height, double thickness) {
  const double under = height - thickness;
  AppendBox(faces, {x0, y0, under}, {x1, y1, height});
  for (const double x : {x0, x1 - kLeg}) {
    for (const double y : {y0, y1 - kLeg})
      AppendBox(faces, {x, y, 0}, {x + kLeg, y + kLeg, under});
  }
}

void AppendShell(std::vector<TestFace>& faces) {
  faces.push_back({testing::Floor(0, 5, 0, 4, 0), testing::kBlack});
  faces.push_back({testing::Ceiling(0, 5, 0, 4, 2.6), testing::kBlack});
  for (const Ring& wall : {
           Ring{{0, 0, 0}, {0, 0, 2.6}, {5, 0, 2.6}, {5, 0, 0}},
           Ring{{0, 4, 0}, {5, 4, 0}, {5, 4, 2.6}, {0, 4, 2.6}},
           Ring{{0, 0, 0}, {0, 4, 0}, {0, 4, 2.6}, {0, 0, 2.6}},
           Ring{{5, 0, 0}, {5, 0, 2.6}, {5, 4, 2.6}, {5, 4, 0}},
       }) {
    faces.push_back({wall, testing::kBlack});
  }
}

}  // namespace truelux::bench
