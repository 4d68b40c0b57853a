// SPDX-License-Identifier: GPL-3.0-or-later
// Degenerate scenes: everything on small integers, and the same moved by one
// unit in the last place.

#include <string>
#include <vector>

#include "scene_parts.h"
#include "scenes.h"
#include "support/random_scene.h"

namespace truelux::bench {
namespace {

constexpr int kBlockers = 60;

/// All coordinates are moved away from 0, where a unit in the last place is no
/// longer small against the others'.
constexpr double kMiddle = 24;
constexpr double kFloor = 1;

Point3 Lift(int x, int y, int z) {
  return {kMiddle + x, kMiddle + y, kFloor + z};
}

/// Heights that divide the lamp's, so that edges at different heights fall on
/// each other seen from an integer receiver.
Point3 LatticePoint(PortableRandom& random) {
  const int z = 4 * random.Integer(1, 3);
  const int x = random.Integer(-6, 6);
  return Lift(x, random.Integer(-6, 6), z);
}

Point3 Nudged(PortableRandom& random, const Point3& p) {
  const double x = random.Nudge(p.x);
  const double y = random.Nudge(p.y);
  return {x, y, random.Nudge(p.z)};
}

}  // namespace

BenchScene MakeLattice(bool one_ulp, int receivers, std::uint64_t seed) {
  PortableRandom random(seed);
  std::vector<TestFace> faces = {
      {{Lift(-8, -8, 16), Lift(-8, 8, 16), Lift(8, 8, 16), Lift(8, -8, 16)},
       kWhite}};
  while (static_cast<int>(faces.size()) <= kBlockers) {
    // Short sides: many triangles, and light between them.
    const Point3 a = LatticePoint(random);
    const auto near = [&random](double x) { return x + random.Integer(-2, 2); };
    const Point3 b{near(a.x), near(a.y), a.z};
    const double z = a.z + 4 * random.Integer(0, 1);
    const Point3 c{near(a.x), near(a.y), z < kFloor + 16 ? z : a.z};
    if (!testing::OnOneLine(a, b, c))
      faces.push_back({{a, b, c}, testing::kBlack});
  }
  if (one_ulp) {
    // The lamp's plane stays: a lamp in two triangles is another scene.
    for (std::size_t i = 1; i < faces.size(); ++i) {
      for (Point3& p : faces[i].ring)
        p = Nudged(random, p);
    }
  }
  BenchScene lattice{
      one_ulp ? "one_ulp" : "lattice", testing::MakeScene(faces), {}};
  lattice.receivers =
      PenumbraReceivers(lattice.scene, faces[0], receivers, [&] {
        const int x = random.Integer(-6, 6);
        const Point3 p = Lift(x, random.Integer(-6, 6), 0);
        return Receiver{one_ulp ? Nudged(random, p) : p, {0, 0, 1}, 0};
      });
  return lattice;
}

}  // namespace truelux::bench
