// SPDX-License-Identifier: GPL-3.0-or-later
// Isolux of a floor in one call, and geometry of what comes out.

#ifndef TRUELUX_TESTS_ISOLUX_NAMED_FLOOR_H_
#define TRUELUX_TESTS_ISOLUX_NAMED_FLOOR_H_

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "truelux/io.h"
#include "truelux/irradiance.h"
#include "truelux/isolux.h"
#include "truelux/scene.h"

#include "support/scenes.h"

namespace truelux::testing {

/// A scene with a group "floor" in z = 0, and faces over it.
inline Scene NamedFloor(double half_side, const std::vector<TestFace>& above) {
  SceneBuilder builder("scene");
  builder.SetGroup("floor");
  builder.AddFace(Floor(-half_side, half_side, -half_side, half_side, 0));
  builder.SetGroup("rest");
  for (const TestFace& face : above)
    builder.AddFace(face.ring, face.emission);
  Result<Scene> result = builder.Build();
  if (!result.ok()) throw std::invalid_argument(result.diagnostics[0].Text());
  return *result.value;
}

/// A scene of the examples.
inline Scene ExampleScene(const std::string& name) {
  auto result = ReadScene(std::string(TRUELUX_EXAMPLES) + "/scenes/" + name);
  if (!result.ok()) throw std::invalid_argument(result.diagnostics[0].Text());
  return *result.value;
}

/// Of its surface "floor".
inline Isolux FloorIsolux(const Scene& scene, const IsoluxOptions& options) {
  return IsoluxOf(Oracle(scene), "floor", options);
}

/// Two coordinates of a point.
struct Flat {
  double x = 0;
  double y = 0;
};

/// Twice the area of a triangle.
inline double Turn(const Flat& a, const Flat& b, const Flat& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Whether two segments cross, each with the ends of the other on both sides.
inline bool Cross(const std::array<Flat, 2>& s, const std::array<Flat, 2>& t) {
  return Turn(s[0], s[1], t[0]) * Turn(s[0], s[1], t[1]) < 0 &&
         Turn(t[0], t[1], s[0]) * Turn(t[0], t[1], s[1]) < 0;
}

inline double DistanceTo(const Flat& p, const std::array<Flat, 2>& s) {
  const double dx = s[1].x - s[0].x;
  const double dy = s[1].y - s[0].y;
  const double square = dx * dx + dy * dy;
  double share =
      square > 0 ? ((p.x - s[0].x) * dx + (p.y - s[0].y) * dy) / square : 0;
  share = std::fmin(1, std::fmax(0, share));
  return std::hypot(p.x - s[0].x - share * dx, p.y - s[0].y - share * dy);
}

/// The chords of a contour by the two coordinates along a surface.
template <class FlatOf>
std::vector<std::array<Flat, 2>> ChordsOf(const IsoluxContour& contour,
                                          const FlatOf& flat) {
  std::vector<std::array<Flat, 2>> chords;
  const std::size_t count = contour.vertices.size();
  for (std::size_t i = 0; i + (contour.is_closed ? 0 : 1) < count; ++i) {
    chords.push_back({flat(contour.vertices[i].at),
                      flat(contour.vertices[(i + 1) % count].at)});
  }
  return chords;
}

inline Flat FlatXY(const Point3& p) {
  return {p.x, p.y};
}

inline Flat FlatXZ(const Point3& p) {
  return {p.x, p.z};
}

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_ISOLUX_NAMED_FLOOR_H_
