// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes as objects: a furnished room, and meshes from files.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fmt/format.h>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "truelux/io.h"

#include "mesh_parts.h"
#include "run/user_error.h"
#include "scene_parts.h"
#include "scenes.h"
#include "support/mesh_scenes.h"

namespace truelux::bench {
namespace {

constexpr double kTableHeight = 0.75;

/// Where objects may stand.
struct Place {
  double x0 = 0;
  double x1 = 0;
  double y0 = 0;
  double y1 = 0;
  double z = 0;

  [[nodiscard]] Point3 Draw(PortableRandom& random) const {
    const double x = random.Uniform(x0, x1);
    return {x, random.Uniform(y0, y1), z};
  }
};

constexpr Place kFloor = {0.3, 4.7, 0.3, 3.7, 0};
constexpr Place kFirstTable = {1, 2.2, 0.8, 1.6, kTableHeight};
constexpr Place kSecondTable = {2.8, 4, 2.2, 3, kTableHeight};

/// What an object takes of its place.
struct Footprint {
  Point3 middle;
  double radius = 0;
};

bool IsFree(const Footprint& wanted, const std::vector<Footprint>& taken) {
  return std::ranges::none_of(taken, [&](const Footprint& other) {
    return wanted.middle.z == other.middle.z &&
           std::hypot(wanted.middle.x - other.middle.x,
                      wanted.middle.y - other.middle.y) <
               wanted.radius + other.radius;
  });
}

/// A free place, or the last one that was tried.
Footprint FreePlace(PortableRandom& random, const Place& place, double radius,
                    const std::vector<Footprint>& taken) {
  Footprint wanted;
  for (int tries = 0; tries < 100; ++tries) {
    wanted = {place.Draw(random), radius};
    if (IsFree(wanted, taken)) break;
  }
  return wanted;
}

/// A sphere, a torus, a box or a blob of 480 to 2704 triangles that stands on a
/// place; every other box is turned.
std::vector<Ring> Object(PortableRandom& random, int index,
                         const Footprint& on) {
  const double r = on.radius;
  const Point3 centre{on.middle.x, on.middle.y, on.middle.z + r};
  if (index % 4 == 0)
    return testing::SphereMesh(random, random.Integer(16, 36), centre, r, 0);
  if (index % 4 == 1) {
    const int across = random.Integer(12, 26);
    return TorusMesh(2 * across, across,
                     {centre.x, centre.y, on.middle.z + 0.3 * r}, 0.7 * r,
                     0.3 * r);
  }
  if (index % 4 == 2) {
    const int cut = random.Integer(7, 15);
    const double half = 0.7 * r;
    std::vector<Ring> box =
        BoxMesh(cut, {centre.x - half, centre.y - half, on.middle.z},
                {centre.x + half, centre.y + half,
                 on.middle.z + r * random.Uniform(0.5, 3)});
    const double angle = random.Uniform(0, std::numbers::pi);
    return index % 8 == 2 ? box : Turned(std::move(box), centre, angle);
  }
  return BlobMesh(random, random.Integer(8, 18), centre, r, 0);
}

/// Moved and scaled so that the longest side of the box around it is from -1/2
/// to 1/2, and the lowest point at 0. Files have y upwards.
class IntoUnitBox {
 public:
  explicit IntoUnitBox(const Scene& scene) {
    Point3 high = Upright(scene.vertices().front());
    low_ = high;
    for (const Point3& vertex : scene.vertices()) {
      const Point3 p = Upright(vertex);
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y),
              std::min(low_.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y),
              std::max(high.z, p.z)};
    }
    middle_x_ = (low_.x + high.x) / 2;
    middle_y_ = (low_.y + high.y) / 2;
    scale_ = 1 / std::max({high.x - low_.x, high.y - low_.y, high.z - low_.z});
  }

  [[nodiscard]] Point3 Of(const Point3& vertex) const {
    const Point3 p = Upright(vertex);
    return {scale_ * (p.x - middle_x_), scale_ * (p.y - middle_y_),
            scale_ * (p.z - low_.z)};
  }

 private:
  static Point3 Upright(const Point3& p) { return {p.x, -p.z, p.y}; }

  Point3 low_;
  double middle_x_ = 0;
  double middle_y_ = 0;
  double scale_ = 1;
};

Scene SceneOfFile(const std::filesystem::path& file) {
  Result<Scene> result = ReadScene(file, {.lenient = true});
  if (!result.ok()) throw UserError(result.diagnostics);
  if (result.value->triangles().empty())
    throw UserError(file.string() + ": no triangles");
  return *result.value;
}

}  // namespace

BenchScene MakeFurnishedRoom(int objects, int receivers, std::uint64_t seed) {
  PortableRandom random(seed);
  std::vector<TestFace> faces = {
      {testing::Ceiling(1, 2.2, 1, 1.3, 2.55), kWhite},
      {testing::Ceiling(2.8, 4, 2.6, 2.9, 2.55), kWhite}};
  AppendShell(faces);
  for (const Place& table : {kFirstTable, kSecondTable}) {
    AppendTable(faces, table.x0, table.x1, table.y0, table.y1, kTableHeight,
                0.04);
  }
  std::vector<Footprint> taken;
  for (int i = 0; i < objects; ++i) {
    const bool on_table = i % 3 == 0;
    const Place& place = !on_table    ? kFloor
                         : i % 6 == 0 ? kFirstTable
                                      : kSecondTable;
    const double radius =
        on_table ? random.Uniform(0.06, 0.12) : random.Uniform(0.1, 0.3);
    taken.push_back(FreePlace(random, place, radius, taken));
    AppendMesh(faces, Object(random, i, taken.back()));
  }
  BenchScene room{"meshes_room", testing::MakeScene(faces), {}};
  for (int i = 0; i < receivers; ++i) {
    const Place& place = i % 8 == 0   ? kFirstTable
                         : i % 8 == 4 ? kSecondTable
                                      : kFloor;
    // A place that is free, so that few receivers lie inside an object.
    room.receivers.push_back(
        {FreePlace(random, place, 0.02, taken).middle, {0, 0, 1}, 0});
  }
  return room;
}

BenchScene MakeFileMesh(const std::string& folder, const std::string& name,
                        int receivers) {
  const Scene scene =
      SceneOfFile(std::filesystem::path(folder) / (name + ".obj"));
  const IntoUnitBox unit_box(scene);
  std::vector<TestFace> faces = {{testing::Ceiling(-1, 1, -1, 1, 1.6), kWhite}};
  for (const Triangle& triangle : scene.triangles()) {
    Ring ring;
    for (const int vertex : triangle.vertices) {
      ring.push_back(
          unit_box.Of(scene.vertices()[static_cast<std::size_t>(vertex)]));
    }
    faces.push_back({ring, testing::kBlack});
  }
  BenchScene mesh{"meshes_" + name, testing::MakeScene(faces), {}};
  for (int i = 0; i < receivers; ++i) {
    const double angle = 2 * std::numbers::pi * i / receivers;
    const double radius = 0.4 + 0.25 * (i % 3);
    mesh.receivers.push_back(
        {{radius * std::cos(angle), radius * std::sin(angle), -0.1},
         {0, 0, 1},
         0});
  }
  return mesh;
}

}  // namespace truelux::bench
