// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes that look like something: a room, boxes on a floor, meshes.

#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <iterator>
#include <numbers>
#include <string>
#include <vector>

#include "scene_parts.h"
#include "scenes.h"

namespace truelux::bench {
namespace {

void AppendChair(std::vector<TestFace>& faces, double x, double y) {
  constexpr double kSeat = 0.45;
  AppendTable(faces, x, x + kSeat, y, y + kSeat, kSeat, 0.04);
  AppendBox(faces, {x, y, kSeat}, {x + 0.04, y + kSeat, 0.9});
}

void AppendShelves(std::vector<TestFace>& faces, double x, double y) {
  constexpr double kWidth = 1.2;
  constexpr double kDepth = 0.3;
  constexpr double kBoard = 0.025;
  for (const double side : {x, x + kWidth - kBoard})
    AppendBox(faces, {side, y, 0}, {side + kBoard, y + kDepth, 1.8});
  for (int i = 0; i < 5; ++i) {
    const double z = 0.1 + 0.4 * i;
    AppendBox(faces, {x + kBoard, y, z},
              {x + kWidth - kBoard, y + kDepth, z + kBoard});
  }
}

/// A lamp in a shade that is open downwards, its middle at (x, y).
void AppendLamp(std::vector<TestFace>& faces, double x, double y) {
  constexpr double kHalf = 0.2;
  constexpr double kShade = 0.25;
  faces.push_back(
      {testing::Ceiling(x - kHalf, x + kHalf, y - kHalf, y + kHalf, 2.1),
       {10, 10, 10}});
  AppendBox(faces, {x - kShade, y - kShade, 2.15},
            {x + kShade, y + kShade, 2.2});
  const double thickness = 0.01;
  AppendBox(faces, {x - kShade, y - kShade, 1.95},
            {x - kShade + thickness, y + kShade, 2.15});
  AppendBox(faces, {x + kShade - thickness, y - kShade, 1.95},
            {x + kShade, y + kShade, 2.15});
}

/// A face of a mesh in black.
TestFace Black(const Point3& a, const Point3& b, const Point3& c) {
  return {{a, b, c}, testing::kBlack};
}

TestFace GridLampFace() {
  return {testing::Ceiling(-0.4, 0.4, -0.4, 0.4, 4), kWhite};
}

}  // namespace

BenchScene MakeRoom(int receivers, std::uint64_t seed) {
  std::vector<TestFace> faces;
  AppendLamp(faces, 2.5, 2);
  AppendShell(faces);
  AppendTable(faces, 1.8, 3.2, 1.6, 2.4, 0.75, 0.04);
  AppendChair(faces, 1.3, 1.775);
  AppendChair(faces, 2.1, 2.6);
  AppendShelves(faces, 3.5, 3.65);
  AppendBox(faces, {2.2, 1.9, 0.75}, {2.3, 2, 1});      // a carton
  AppendBox(faces, {2.75, 1.75, 0.75}, {3, 2.1, 0.8});  // a book

  PortableRandom random(seed);
  BenchScene room{"room", testing::MakeScene(faces), {}};
  for (int i = 0; i < receivers; ++i) {
    const bool on_table = i % 4 == 0;
    const double x = on_table ? random.Uniform(1.8, 3.2) : random.Uniform(0, 5);
    const double y = on_table ? random.Uniform(1.6, 2.4) : random.Uniform(0, 4);
    room.receivers.push_back({{x, y, on_table ? 0.75 : 0}, {0, 0, 1}, 0});
  }
  return room;
}

BenchScene MakeSphere(int n, int receivers, std::uint64_t seed) {
  PortableRandom random(seed);
  std::vector<Point3> ring_points;
  for (int i = 1; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double u = 2 * std::numbers::pi * j / n;
      const double v = std::numbers::pi * i / n;
      const double r =
          1 + 0.1 * std::sin(7 * u) * std::sin(5 * v) + 0.01 * random.Unit();
      ring_points.push_back({r * std::sin(v) * std::cos(u),
                             r * std::sin(v) * std::sin(u), r * std::cos(v)});
    }
  }
  const auto at = [&](int i, int j) -> Point3 {
    if (i == 0) return {0, 0, 1};
    if (i == n) return {0, 0, -1};
    const std::ptrdiff_t ring = i - 1;
    return ring_points[static_cast<std::size_t>(ring * n + j % n)];
  };
  std::vector<TestFace> faces = {
      {testing::Ceiling(-1.5, 1.5, -1.5, 1.5, 2.5), {17, 12, 4}}};
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      if (i < n - 1)
        faces.push_back(Black(at(i, j), at(i + 1, j), at(i + 1, j + 1)));
      if (i > 0)
        faces.push_back(Black(at(i, j), at(i + 1, j + 1), at(i, j + 1)));
    }
  }
  BenchScene sphere{
      fmt::format("sphere_{}", 2 * n * (n - 1)), testing::MakeScene(faces), {}};
  for (int i = 0; i < receivers; ++i) {
    const double x = random.Uniform(-2, 2);
    sphere.receivers.push_back(
        {{x, random.Uniform(-2, 2), -1.2}, {0, 0, 1}, 0});
  }
  return sphere;
}

Scene GridLamp() {
  return testing::MakeScene({GridLampFace()});
}

BenchScene MakeGrid(int boxes, int side, std::uint64_t seed) {
  constexpr double kHalf = 3;
  PortableRandom random(seed);
  std::vector<TestFace> faces = {
      GridLampFace(),
      {testing::Floor(-kHalf, kHalf, -kHalf, kHalf, 0), testing::kBlack}};
  for (int i = 0; i < boxes; ++i) {
    const double x = random.Uniform(-2.5, 1.8);
    const double y = random.Uniform(-2.5, 1.8);
    const double z = random.Uniform(0.1, 0.8);
    const double width = random.Uniform(0.2, 0.8);
    const double depth = random.Uniform(0.2, 0.8);
    AppendBox(faces, {x, y, z},
              {x + width, y + depth, z + random.Uniform(0.1, 0.8)});
  }
  BenchScene grid{
      fmt::format("grid_{0}x{0}", side), testing::MakeScene(faces), {}};
  const auto at = [side](int i) { return kHalf * (2 * (i + 0.5) / side - 1); };
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column)
      grid.receivers.push_back({{at(column), at(row), 0}, {0, 0, 1}, 0});
  }
  return grid;
}

std::string TerrainObj(int triangles) {
  const int cells = triangles / 2;
  int columns = static_cast<int>(std::sqrt(cells));
  while (cells % columns != 0)
    --columns;
  const int rows = cells / columns;
  std::string text;
  const auto out = std::back_inserter(text);
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      fmt::format_to(out, "v {} {} {}\n", 0.01 * i, 0.01 * j,
                     0.1 * std::sin(0.03 * i) * std::cos(0.02 * j));
    }
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int a = j * (columns + 1) + i + 1;
      const int b = a + columns + 1;
      fmt::format_to(out, "f {} {} {}\nf {} {} {}\n", a, a + 1, b, b, a + 1,
                     b + 1);
    }
  }
  return text;
}

}  // namespace truelux::bench
