// SPDX-License-Identifier: GPL-3.0-or-later
// Closed meshes of triangles, beside the spheres of support/mesh_scenes.h.

#ifndef TRUELUX_BENCH_MESH_PARTS_H_
#define TRUELUX_BENCH_MESH_PARTS_H_

#include <vector>

#include "truelux/geometry.h"

#include "scene_parts.h"

namespace truelux::bench {

/// A smooth body with a few bumps that is about `size` large in every direction
/// from its centre: 8 n^2 triangles of unequal areas. noise: by what part of
/// `size` each corner is off at most, as in scans.
std::vector<Ring> BlobMesh(PortableRandom& random, int n, const Point3& centre,
                           double size, double noise);

/// A torus that lies: its tube has `tube` as radius, and runs at `radius`
/// around the centre. 2 * around * across triangles.
std::vector<Ring> TorusMesh(int around, int across, const Point3& centre,
                            double radius, double tube);

/// The box between two opposite corners, each side cut into n * n squares of
/// two triangles.
std::vector<Ring> BoxMesh(int n, const Point3& a, const Point3& b);

/// Every corner turned around the upright line through a point.
std::vector<Ring> Turned(std::vector<Ring> mesh, const Point3& around,
                         double angle);

/// Appends a mesh in black.
void AppendMesh(std::vector<TestFace>& faces, const std::vector<Ring>& mesh);

}  // namespace truelux::bench

#endif  // TRUELUX_BENCH_MESH_PARTS_H_
