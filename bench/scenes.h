// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes to measure on. Each is made by a fixed recipe from a seed and is the
// same on every machine, up to what libm's sine and cosine differ by.
//
// Unless a recipe says otherwise the source is the square |x|, |y| <= 1/2 at
// z = 1 that emits downwards with M = 1 in all channels, and the receivers lie
// on z = 0 and look up.

#ifndef TRUELUX_BENCH_SCENES_H_
#define TRUELUX_BENCH_SCENES_H_

#include <cstdint>
#include <string>
#include <vector>

#include "truelux/receiver.h"
#include "truelux/scene.h"

namespace truelux::bench {

/// A scene with the receivers at which it is measured.
struct BenchScene {
  std::string name;
  Scene scene;
  std::vector<Receiver> receivers;
};

/// `count` equilateral triangles of circumradius
/// min(0.28, sqrt(0.7 * 1.96 / (0.65 count))), turned at random, centres
/// uniform in |x|, |y| <= 0.7, 0.2 <= z <= 0.8, kept if all vertices lie in
/// 0.05 <= z <= 0.95; coordinates rounded to float. Receivers uniform in
/// |x|, |y| <= 0.5, kept if between 5 % and 95 % of the source is visible.
BenchScene MakeSlab(int count, int receivers, std::uint64_t seed);

/// A room 5 by 4 by 2.6 with a table, chairs, shelves and a shaded lamp.
/// Receivers on the floor and on the table.
BenchScene MakeRoom(int receivers, std::uint64_t seed);

/// The bumpy sphere of tools/make_sphere.py with 2 n (n - 1) triangles under a
/// lamp. Receivers below it.
BenchScene MakeSphere(int n, int receivers, std::uint64_t seed);

/// `boxes` boxes between a lamp and a floor, side * side receivers in rows on
/// the floor, as in an image.
BenchScene MakeGrid(int boxes, int side, std::uint64_t seed);

/// The lamp of a grid scene alone.
Scene GridLamp();

/// Triangles with corners at small integers, so that seen from the receivers,
/// at integers too, many edges and vertices coincide exactly. one_ulp: every
/// coordinate moved by -1, 0 or +1 unit in the last place. Receivers kept as
/// for a slab.
BenchScene MakeLattice(bool one_ulp, int receivers, std::uint64_t seed);

/// `count` triangles spread from the middle outwards at constant density; some
/// 24 of the first hundred overlap the source seen from a receiver.
BenchScene MakeOutward(int count, int receivers, std::uint64_t seed);

/// `count` triangles that all overlap the source, in general position.
BenchScene MakeOverlapping(int count, int receivers, std::uint64_t seed);

/// The source cut into `count` rectangles, with eight blockers. shared_edges:
/// the rectangles are a mesh; otherwise there are gaps between them.
BenchScene MakeLamps(int count, bool shared_edges, int receivers,
                     std::uint64_t seed);

/// A smooth sphere of radius 1 with 2 n (n - 1) triangles around the origin,
/// under a lamp larger than its shadow. Receivers at z = -4, |x|, |y| <= 0.5.
BenchScene MakeSmoothSphere(int n, int receivers, std::uint64_t seed);

/// The same with a closed body of 8 n^2 triangles of unequal areas, with bumps
/// and the noise of a scan, a part of its size.
BenchScene MakeScan(int n, double noise, int receivers, std::uint64_t seed);

/// The same with side * side receivers in rows, one tile of 4 x 4 after the
/// other as in an image, the tiles in random order. side: a multiple of 4.
BenchScene MakeScanGrid(int n, double noise, int side, std::uint64_t seed);

/// Hills of 64 x 64 columns of unit cubes, of which only the outer faces are
/// there. The lamp lies above the middle. Receivers just above the columns, kept
/// as for a slab.
BenchScene MakeVoxels(int receivers, std::uint64_t seed);

/// `leaves` small rhombi that share no corners, in clusters of 500. Receivers
/// kept as for a slab.
BenchScene MakeFoliage(int leaves, int receivers, std::uint64_t seed);

/// The source cut into columns * rows rectangles that share their corners, with
/// a sphere of 220 triangles below it.
BenchScene MakeMeshLamp(int columns, int rows, int receivers,
                        std::uint64_t seed);

/// The room with two lamps at its ceiling, and `objects` meshes of 480 to 2704
/// triangles each on its floor and on two tables. Receivers between them.
BenchScene MakeFurnishedRoom(int objects, int receivers, std::uint64_t seed);

/// The triangles of FOLDER/NAME.obj, scaled into a unit box, under a lamp.
/// Receivers around and below it. Throws UserError if it cannot be read.
BenchScene MakeFileMesh(const std::string& folder, const std::string& name,
                        int receivers);

/// A wavy surface of `triangles` triangles (an even number) with shared
/// vertices, as the text of an OBJ file.
std::string TerrainObj(int triangles);

}  // namespace truelux::bench

#endif  // TRUELUX_BENCH_SCENES_H_
