// SPDX-License-Identifier: GPL-3.0-or-later
// One mesh under a lamp: spheres, scans, voxels, leaves, and lamps that are
// meshes themselves.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <string>
#include <utility>
#include <vector>

#include "mesh_parts.h"
#include "scene_parts.h"
#include "scenes.h"
#include "support/mesh_scenes.h"

namespace truelux::bench {
namespace {

/// Receivers of round bodies lie so far below them that all of the outline is
/// seen before the lamp.
constexpr double kFarBelow = -4;

/// Holds the shadow of a body in the unit sphere seen from kFarBelow.
TestFace WideLamp() {
  return {testing::Ceiling(-2.5, 2.5, -2.5, 2.5, 2.5), kWhite};
}

std::vector<Receiver> ScatteredBelow(PortableRandom& random, int count,
                                     double half, double z) {
  std::vector<Receiver> receivers;
  for (int i = 0; i < count; ++i) {
    Receiver receiver = RandomReceiver(random, half);
    receiver.position.z = z;
    receivers.push_back(receiver);
  }
  return receivers;
}

/// side * side receivers, |x|, |y| <= half, in tiles of 4 x 4 one after the
/// other. The order of the tiles is random, so that the first receivers stand
/// for all.
std::vector<Receiver> TiledBelow(PortableRandom& random, int side, double half,
                                 double z) {
  constexpr int kTile = 4;

  struct Corner {
    int row = 0;
    int column = 0;
  };

  std::vector<Corner> tiles;
  for (int row = 0; row < side; row += kTile) {
    for (int column = 0; column < side; column += kTile)
      tiles.push_back({row, column});
  }
  for (std::size_t left = tiles.size(); left > 1; --left) {
    const int drawn = random.Integer(0, static_cast<int>(left) - 1);
    std::swap(tiles[left - 1], tiles[static_cast<std::size_t>(drawn)]);
  }
  const auto at = [&](int i) { return half * (2 * (i + 0.5) / side - 1); };
  std::vector<Receiver> receivers;
  for (const Corner& tile : tiles) {
    for (int i = 0; i < kTile * kTile; ++i) {
      const double x = at(tile.column + i % kTile);
      const double y = at(tile.row + i / kTile);
      receivers.push_back({{x, y, z}, {0, 0, 1}, 0});
    }
  }
  return receivers;
}

/// The tops of columns of cubes.
class Heights {
 public:
  static constexpr int kSide = 64;

  explicit Heights(PortableRandom& random) {
    for (Wave& wave : waves_) {
      wave.along_x = random.Uniform(-0.35, 0.35);
      wave.along_y = random.Uniform(-0.35, 0.35);
      wave.phase = random.Uniform(0, 6);
    }
  }

  /// From 1 to 19; 0 outside.
  [[nodiscard]] int At(int x, int y) const {
    if (x < 0 || y < 0 || x >= kSide || y >= kSide) return 0;
    double height = 10;
    for (const Wave& wave : waves_)
      height += 3 * std::sin(wave.along_x * x + wave.along_y * y + wave.phase);
    return std::max(1, static_cast<int>(std::lround(height)));
  }

 private:
  struct Wave {
    double along_x = 0;
    double along_y = 0;
    double phase = 0;
  };

  std::array<Wave, 3> waves_;
};

/// Top, bottom and the visible side faces of a column, squares of side 1.
void AppendColumn(std::vector<TestFace>& faces, const Heights& heights, int x,
                  int y) {
  const int top = heights.At(x, y);
  const auto at = [&](int dx, int dy, int z) -> Point3 {
    return {1.0 * x + dx, 1.0 * y + dy, 1.0 * z};
  };
  const auto add = [&](const Ring& ring) {
    faces.push_back({ring, testing::kBlack});
  };
  add({at(0, 0, top), at(1, 0, top), at(1, 1, top), at(0, 1, top)});
  add({at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0)});
  for (int z = 0; z < top; ++z) {
    const int up = z + 1;
    if (heights.At(x - 1, y) <= z)
      add({at(0, 0, z), at(0, 0, up), at(0, 1, up), at(0, 1, z)});
    if (heights.At(x + 1, y) <= z)
      add({at(1, 0, z), at(1, 1, z), at(1, 1, up), at(1, 0, up)});
    if (heights.At(x, y - 1) <= z)
      add({at(0, 0, z), at(1, 0, z), at(1, 0, up), at(0, 0, up)});
    if (heights.At(x, y + 1) <= z)
      add({at(0, 1, z), at(0, 1, up), at(1, 1, up), at(1, 1, z)});
  }
}

using Vec = Vec3<double>;

/// Few bits, so that sums are exact and parallelograms planar.
Vec Coarse(const Vec& v) {
  const auto round = [](double x) { return std::round(x * 0x1p20) * 0x1p-20; };
  return {round(v.x), round(v.y), round(v.z)};
}

/// A rhombus with sides of a length, turned at random.
Ring Leaf(PortableRandom& random, const Vec& corner, double side) {
  const Vec p = Coarse(corner);
  const Vec u = Coarse(side * RandomUnit(random));
  const Vec v = Coarse(side * RandomUnit(random));
  const auto at = [&](const Vec& q) { return Point3{q.x, q.y, q.z}; };
  return {at(p), at(p + u), at(p + u + v), at(p + v)};
}

}  // namespace

BenchScene MakeSmoothSphere(int n, int receivers, std::uint64_t seed) {
  PortableRandom random(seed);
  std::vector<TestFace> faces = {WideLamp()};
  AppendMesh(faces, testing::SphereMesh(random, n, {0, 0, 0}, 1, 0));
  return {fmt::format("meshes_sphere_{}", faces.size() - 1),
          testing::MakeScene(faces),
          ScatteredBelow(random, receivers, 0.5, kFarBelow)};
}

BenchScene MakeScan(int n, double noise, int receivers, std::uint64_t seed) {
  PortableRandom random(seed);
  std::vector<TestFace> faces = {WideLamp()};
  AppendMesh(faces, BlobMesh(random, n, {0, 0, 0}, 1, noise));
  return {fmt::format("meshes_{}scan_{}", noise > 5e-4 ? "rough_" : "",
                      faces.size() - 1),
          testing::MakeScene(faces),
          ScatteredBelow(random, receivers, 0.5, kFarBelow)};
}

BenchScene MakeScanGrid(int n, double noise, int side, std::uint64_t seed) {
  BenchScene scan = MakeScan(n, noise, 0, seed);
  scan.name += "_grid";
  PortableRandom random(seed + 1);
  scan.receivers = TiledBelow(random, side, 0.5, kFarBelow);
  return scan;
}

BenchScene MakeVoxels(int receivers, std::uint64_t seed) {
  constexpr int kSide = Heights::kSide;
  PortableRandom random(seed);
  const Heights heights(random);
  std::vector<TestFace> faces = {
      {testing::Ceiling(0.25 * kSide, 0.75 * kSide, 0.25 * kSide, 0.75 * kSide,
                        24),
       kWhite}};
  for (int x = 0; x < kSide; ++x) {
    for (int y = 0; y < kSide; ++y)
      AppendColumn(faces, heights, x, y);
  }
  BenchScene voxels{"meshes_voxels", testing::MakeScene(faces), {}};
  voxels.receivers = PenumbraReceivers(voxels.scene, faces[0], receivers, [&] {
    const int x = random.Integer(0, kSide - 1);
    const int y = random.Integer(0, kSide - 1);
    const double in_cell = random.Uniform(0.1, 0.9);
    return Receiver{
        {x + in_cell, y + random.Uniform(0.1, 0.9), heights.At(x, y) + 0.1},
        {0, 0, 1},
        0};
  });
  return voxels;
}

BenchScene MakeFoliage(int leaves, int receivers, std::uint64_t seed) {
  constexpr int kInCluster = 500;
  constexpr double kSpread = 0.12;
  PortableRandom random(seed);
  std::vector<TestFace> faces = {UnitLamp()};
  Vec centre{0, 0, 0};
  for (int i = 0; i < leaves; ++i) {
    if (i % kInCluster == 0) {
      centre.x = random.Uniform(-0.7, 0.7);
      centre.y = random.Uniform(-0.7, 0.7);
      centre.z = random.Uniform(0.3, 0.7);
    }
    const double distance = kSpread * std::cbrt(random.Unit());
    faces.push_back({Leaf(random, centre + distance * RandomUnit(random), 0.01),
                     testing::kBlack});
  }
  BenchScene foliage{
      fmt::format("meshes_leaves_{}", leaves), testing::MakeScene(faces), {}};
  foliage.receivers =
      PenumbraReceivers(foliage.scene, faces[0], receivers,
                        [&random] { return RandomReceiver(random, 0.5); });
  return foliage;
}

BenchScene MakeMeshLamp(int columns, int rows, int receivers,
                        std::uint64_t seed) {
  const auto x = [columns](int i) { return 1.0 * i / columns - 0.5; };
  const auto y = [rows](int j) { return 1.0 * j / rows - 0.5; };
  std::vector<TestFace> faces;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      faces.push_back(
          {testing::Ceiling(x(i), x(i + 1), y(j), y(j + 1), 1), kWhite});
    }
  }
  PortableRandom random(seed);
  AppendMesh(faces, testing::SphereMesh(random, 11, {0, 0, 0.5}, 0.2, 0));
  return {fmt::format("meshes_lamp_{}", columns * rows),
          testing::MakeScene(faces), ScatteredBelow(random, receivers, 0.5, 0)};
}

}  // namespace truelux::bench
