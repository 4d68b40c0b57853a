// SPDX-License-Identifier: GPL-3.0-or-later
// What the recipes of scenes.h have in common.

#ifndef TRUELUX_BENCH_SCENE_PARTS_H_
#define TRUELUX_BENCH_SCENE_PARTS_H_

#include <functional>
#include <vector>

#include "truelux/geometry.h"
#include "truelux/receiver.h"
#include "truelux/scene.h"

#include "exact/vec3.h"
#include "support/portable_random.h"
#include "support/scenes.h"

namespace truelux::bench {

using testing::PortableRandom;
using testing::Ring;
using testing::TestFace;

inline constexpr Rgb kWhite = {1, 1, 1};

/// The source of most scenes: |x|, |y| <= 1/2 at z = 1, emitting downwards.
TestFace UnitLamp();

/// Coordinates to the nearest float.
Point3 ToFloat(const Point3& p);

/// A direction, all alike probable.
Vec3<double> RandomUnit(PortableRandom& random);

/// An equilateral triangle of a circumradius, turned at random.
Ring RandomTriangle(PortableRandom& random, const Point3& centre,
                    double circumradius);

/// A point of the plane z = 0 with |x|, |y| <= half, to the nearest float,
/// looking up.
Receiver RandomReceiver(PortableRandom& random, double half);

/// The first `count` receivers from `draw` that see between 5 % and 95 % of
/// face 1, by form factors with and without the others. Throws
/// std::runtime_error if these are too rare.
std::vector<Receiver> PenumbraReceivers(const Scene& scene,
                                        const TestFace& first_face, int count,
                                        const std::function<Receiver()>& draw);

/// Appends the six sides of the box between two opposite corners, black,
/// fronts outwards.
void AppendBox(std::vector<TestFace>& faces, const Point3& a, const Point3& b);

/// Appends a slab on four legs, the corners of the slab given on the floor.
void AppendTable(std::vector<TestFace>& faces, double x0, double x1, double y0,
                 double y1, double height, double thickness);

/// Appends floor, ceiling and walls of a room 5 by 4 by 2.6, black, fronts
/// inwards.
void AppendShell(std::vector<TestFace>& faces);

}  // namespace truelux::bench

#endif  // TRUELUX_BENCH_SCENE_PARTS_H_
