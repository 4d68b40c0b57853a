// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes and answers in one line, for tests.

#ifndef TRUELUX_TESTS_SUPPORT_SCENES_H_
#define TRUELUX_TESTS_SUPPORT_SCENES_H_

#include <stdexcept>
#include <string>
#include <vector>

#include "truelux/irradiance.h"
#include "truelux/scene.h"

namespace truelux::testing {

using Ring = std::vector<Point3>;

/// A polygon and its emission; black by default.
struct TestFace {
  Ring ring;
  Rgb emission{};
};

inline constexpr Rgb kLamp = {1, 2.5, 0.1};
inline constexpr Rgb kBlack = {0, 0, 0};

inline Scene MakeScene(const std::vector<TestFace>& faces) {
  SceneBuilder builder("scene");
  for (const TestFace& face : faces)
    builder.AddFace(face.ring, face.emission);
  Result<Scene> result = builder.Build();
  if (!result.ok()) throw std::invalid_argument(result.diagnostics[0].Text());
  return *result.value;
}

/// A scene of so many faces.
inline Scene SceneOf(int face_count) {
  std::vector<TestFace> faces;
  for (int i = 0; i < face_count; ++i)
    faces.push_back({{{0, 0, 1.0 * i}, {1, 0, 1.0 * i}, {0, 1, 1.0 * i}}, {}});
  return MakeScene(faces);
}

inline Rgb Evaluate(const Scene& scene, const Receiver& receiver,
                    const OracleOptions& options = {}) {
  return Oracle(scene, options).Evaluate(receiver).value;
}

/// The certified irradiance from below: receiver at p, normal up.
inline Rgb FromBelow(const std::vector<TestFace>& faces,
                     const Point3& p = {0, 0, 0}) {
  return Evaluate(MakeScene(faces), {p, {0, 0, 1}, 0});
}

/// The axis-parallel rectangle at height z that emits downwards.
inline Ring Ceiling(double x0, double x1, double y0, double y1, double z) {
  return {{x0, y0, z}, {x0, y1, z}, {x1, y1, z}, {x1, y0, z}};
}

/// The same that emits upwards.
inline Ring Floor(double x0, double x1, double y0, double y1, double z) {
  return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

inline Ring Reversed(const Ring& ring) {
  return {ring.rbegin(), ring.rend()};
}

/// Every point moved away from the origin by a factor.
inline Ring Scaled(const Ring& ring, double factor) {
  Ring scaled;
  for (const Point3& p : ring) {
    scaled.push_back({p.x * factor, p.y * factor, p.z * factor});
  }
  return scaled;
}

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_SUPPORT_SCENES_H_
