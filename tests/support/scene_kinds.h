// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of all kinds that visibility can be asked of: soups, meshes that are
// closed, broken or folded, lamps that are whole or cut.

#ifndef TRUELUX_TESTS_SUPPORT_SCENE_KINDS_H_
#define TRUELUX_TESTS_SUPPORT_SCENE_KINDS_H_

#include <vector>

#include "support/mesh_scenes.h"
#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scenes.h"

namespace truelux::testing {

inline void Add(const std::vector<Ring>& rings, const Rgb& emission,
                std::vector<TestFace>& faces) {
  for (const Ring& ring : rings)
    faces.push_back({ring, emission});
}

/// One or two lamps, tilted by integers or not, somewhere among the rest.
inline std::vector<TestFace> Lamps(PortableRandom& random) {
  std::vector<TestFace> faces;
  const int count = random.Integer(1, 2);
  for (int i = 0; i < count; ++i) {
    const double x = random.Integer(-3, 1);
    const double y = random.Integer(-3, 1);
    const double z = random.Integer(-1, 4);
    const double w = random.Integer(1, 4);
    const double h = random.Integer(1, 4);
    const double slope = random.OneIn(2) ? 0 : random.Integer(-1, 1);
    Ring ring{{x, y, z},
              {x, y + h, z},
              {x + w, y + h, z + slope * w},
              {x + w, y, z + slope * w}};
    if (random.OneIn(3)) {  // an L: two convex pieces
      ring = {{x, y, z},
              {x, y + h, z},
              {x + w, y + h, z + slope * w},
              {x + w, y, z + slope * w},
              {x + 2 * w, y, z + slope * 2 * w},
              {x + 2 * w, y - h, z + slope * 2 * w},
              {x, y - h, z}};
    }
    if (random.OneIn(4)) ring = Reversed(ring);
    faces.push_back({ring, {random.Integer(1, 3) * 1.0, 2, 0.5}});
  }
  return faces;
}

inline std::vector<TestFace> LatticeSoup(PortableRandom& random) {
  return RandomScene(random, true, random.Integer(2, 24), random.Integer(1, 4));
}

inline std::vector<TestFace> GeneralSoup(PortableRandom& random) {
  return RandomScene(random, false, random.Integer(2, 30));
}

inline std::vector<TestFace> NoisyLattice(PortableRandom& random) {
  std::vector<TestFace> faces =
      RandomScene(random, true, random.Integer(2, 16), random.Integer(1, 3));
  for (TestFace& face : faces) {
    face.ring.resize(3);  // noise would bend a quad
    for (Point3& p : face.ring)
      p = {random.Nudge(p.x), random.Nudge(p.y), random.Nudge(p.z)};
  }
  return faces;
}

inline std::vector<TestFace> Spheres(PortableRandom& random) {
  std::vector<TestFace> faces = Lamps(random);
  const int count = random.Integer(1, 3);
  for (int i = 0; i < count; ++i) {
    const Point3 centre{random.Uniform(-2, 2), random.Uniform(-2, 2),
                        random.Uniform(-1, 3)};
    const double noise = random.OneIn(2) ? 0 : 0.3;
    Add(SphereMesh(random, random.Integer(3, 8), centre,
                   random.Uniform(0.3, 1.5), noise),
        kBlack, faces);
  }
  return faces;
}

/// Spheres large enough that subtrees of edges are skipped, which must not miss
/// the borders of a face that is taken away.
inline std::vector<TestFace> LargeSpheres(PortableRandom& random) {
  std::vector<TestFace> faces = Lamps(random);
  const Point3 centre{random.Uniform(-1, 1), random.Uniform(-1, 1),
                      random.Uniform(0, 3)};
  Add(SphereMesh(random, random.Integer(12, 20), centre, 2,
                 random.OneIn(4) ? 0.02 : 0),
      kBlack, faces);
  return faces;
}

inline std::vector<TestFace> BrokenSpheres(PortableRandom& random) {
  std::vector<TestFace> faces = Lamps(random);
  const Point3 centre{random.Uniform(-1, 1), random.Uniform(-1, 1),
                      random.Uniform(0, 3)};
  Add(Damaged(random,
              SphereMesh(random, random.Integer(3, 8), centre,
                         random.Uniform(0.5, 2), random.OneIn(2) ? 0 : 0.2),
              4),
      kBlack, faces);
  return faces;
}

inline std::vector<TestFace> Voxels(PortableRandom& random) {
  std::vector<TestFace> faces = Lamps(random);
  Add(VoxelMesh(random, random.Integer(2, 4), random.Integer(2, 4),
                {-2, -2, random.Integer(-2, 2) * 1.0}, random.OneIn(3)),
      kBlack, faces);
  return faces;
}

inline std::vector<TestFace> BrokenVoxels(PortableRandom& random) {
  std::vector<TestFace> faces = Lamps(random);
  const std::vector<Ring> mesh = VoxelMesh(
      random, random.Integer(2, 4), 2, {-2, -2, random.Integer(-2, 2) * 1.0});
  Add(Damaged(random, mesh, 5), kBlack, faces);
  return faces;
}

/// A lamp cut in quads and triangles that share their corners, of one or two
/// emissions, some left out, some there twice or turned over; behind cubes or a
/// sphere.
inline std::vector<TestFace> CutLamps(PortableRandom& random) {
  std::vector<TestFace> faces;
  const int columns = random.Integer(1, 5);
  const int rows = random.Integer(1, 4);
  const double slope = random.OneIn(2) ? 0 : random.Integer(-1, 1);
  const bool two_kinds = random.OneIn(2);
  for (int i = 0; i < columns; ++i) {
    for (int k = 0; k < rows; ++k) {
      const auto at = [&](int dx, int dy) -> Point3 {
        const double x = i + dx - 2;
        return {x, k + dy - 2.0, 3 + slope * x};
      };
      const Ring quad{at(0, 0), at(0, 1), at(1, 1), at(1, 0)};
      const Rgb emission =
          two_kinds && random.OneIn(3) ? Rgb{3, 1, 0.5} : kLamp;
      if (random.OneIn(10)) continue;
      if (random.OneIn(3)) {
        faces.push_back({{quad[0], quad[1], quad[2]}, emission});
        faces.push_back({{quad[0], quad[2], quad[3]}, emission});
      } else {
        faces.push_back({random.OneIn(12) ? Reversed(quad) : quad, emission});
      }
      if (random.OneIn(15)) faces.push_back({quad, kLamp});
    }
  }
  if (faces.empty()) faces.push_back({Ceiling(-1, 1, -1, 1, 3), kLamp});
  if (random.OneIn(2)) {
    Add(SphereMesh(random, random.Integer(3, 5),
                   {random.Uniform(-1, 1), random.Uniform(-1, 1), 1.5}, 0.8, 0),
        kBlack, faces);
  } else {
    Add(VoxelMesh(random, 3, 3, {-2, -2, random.Integer(0, 2) * 1.0}), kBlack,
        faces);
  }
  return faces;
}

inline std::vector<TestFace> FarAway(PortableRandom& random) {
  std::vector<TestFace> faces =
      random.OneIn(2) ? Voxels(random) : BrokenVoxels(random);
  for (TestFace& face : faces) {
    for (Point3& p : face.ring)
      p = {p.x + 0x1p40, p.y - 0x1p41, p.z + 0x1p39};
  }
  return faces;
}

/// Voxels of which some faces emit, so that sources are parts of meshes.
inline std::vector<TestFace> GlowingVoxels(PortableRandom& random) {
  std::vector<TestFace> faces;
  for (const Ring& ring : VoxelMesh(random, 3, 2, {-2, -2, 0}))
    faces.push_back({ring, random.OneIn(6) ? kLamp : kBlack});
  return faces;
}

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_SUPPORT_SCENE_KINDS_H_
