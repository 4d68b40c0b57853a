// SPDX-License-Identifier: GPL-3.0-or-later
// Crowds of triangles: the slabs, and the families that grow in one respect.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "scene_parts.h"
#include "scenes.h"

namespace truelux::bench {
namespace {

/// Circumradius at which `count` triangles hide about half of the source.
double SlabRadius(int count) {
  return std::min(0.28, std::sqrt(0.7 * 1.96 / (0.65 * count)));
}

/// Triangles of the slab recipe, each at a centre that `centre` draws.
template <class Centre>
void AppendTriangles(std::vector<TestFace>& faces, PortableRandom& random,
                     int count, double radius, Centre centre) {
  while (count > 0) {
    const Ring ring = RandomTriangle(random, centre(), radius);
    if (!std::ranges::all_of(
            ring, [](const Point3& p) { return p.z >= 0.05 && p.z <= 0.95; }))
      continue;
    faces.push_back({ring, testing::kBlack});
    --count;
  }
}

std::vector<TestFace> SlabFaces(PortableRandom& random, int count) {
  std::vector<TestFace> faces = {UnitLamp()};
  AppendTriangles(faces, random, count, SlabRadius(count), [&random] {
    const double x = random.Uniform(-0.7, 0.7);
    const double y = random.Uniform(-0.7, 0.7);
    return Point3{x, y, random.Uniform(0.2, 0.8)};
  });
  return faces;
}

std::vector<Receiver> ReceiversNearTheMiddle(PortableRandom& random, int count,
                                             double half) {
  std::vector<Receiver> receivers;
  receivers.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    receivers.push_back(RandomReceiver(random, half));
  return receivers;
}

}  // namespace

BenchScene MakeSlab(int count, int receivers, std::uint64_t seed) {
  PortableRandom random(seed);
  const std::vector<TestFace> faces = SlabFaces(random, count);
  BenchScene slab{
      "slab_" + std::to_string(count), testing::MakeScene(faces), {}};
  slab.receivers =
      PenumbraReceivers(slab.scene, faces[0], receivers,
                        [&random] { return RandomReceiver(random, 0.5); });
  return slab;
}

BenchScene MakeOutward(int count, int receivers, std::uint64_t seed) {
  // On a sunflower spiral the i-th point is sqrt(i) steps from the middle.
  constexpr double kStep = 0.069;
  const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
  PortableRandom random(seed);
  std::vector<TestFace> faces = {UnitLamp()};
  faces.reserve(static_cast<std::size_t>(count) + 1);
  int index = 0;
  AppendTriangles(faces, random, count, 0.08, [&] {
    const double radius = kStep * std::sqrt(index + 0.5);
    const double angle = golden_angle * index;
    ++index;
    return Point3{radius * std::cos(angle) + random.Uniform(-0.02, 0.02),
                  radius * std::sin(angle) + random.Uniform(-0.02, 0.02),
                  random.Uniform(0.3, 0.7)};
  });
  // The receivers are the same whatever the count is.
  PortableRandom receiver_random(seed + 1);
  return {"outward_" + std::to_string(count), testing::MakeScene(faces),
          ReceiversNearTheMiddle(receiver_random, receivers, 0.1)};
}

BenchScene MakeOverlapping(int count, int receivers, std::uint64_t seed) {
  PortableRandom random(seed);
  std::vector<TestFace> faces = {UnitLamp()};
  AppendTriangles(faces, random, count, SlabRadius(count) / 2, [&random] {
    // Seen from the origin, in the inner part of the source.
    const double z = random.Uniform(0.3, 0.7);
    const double x = z * random.Uniform(-0.45, 0.45);
    return Point3{x, z * random.Uniform(-0.45, 0.45), z};
  });
  PortableRandom receiver_random(seed + 1);
  return {"overlapping_" + std::to_string(count), testing::MakeScene(faces),
          ReceiversNearTheMiddle(receiver_random, receivers, 0.01)};
}

BenchScene MakeLamps(int count, bool shared_edges, int receivers,
                     std::uint64_t seed) {
  int columns = static_cast<int>(std::sqrt(count));
  while (count % columns != 0)
    --columns;
  const int rows = count / columns;
  const double gap = shared_edges ? 0 : 0.05;
  std::vector<TestFace> faces;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const auto x = [columns](double k) { return k / columns - 0.5; };
      const auto y = [rows](double k) { return k / rows - 0.5; };
      faces.push_back(
          {testing::Ceiling(x(i), x(i + 1 - gap), y(j), y(j + 1 - gap), 1),
           kWhite});
    }
  }
  PortableRandom random(seed);
  std::vector<TestFace> blockers = SlabFaces(random, 8);
  faces.insert(faces.end(), blockers.begin() + 1, blockers.end());
  const std::string kind = shared_edges ? "mesh_lamps_" : "separate_lamps_";
  return {kind + std::to_string(count), testing::MakeScene(faces),
          ReceiversNearTheMiddle(random, receivers, 0.5)};
}

}  // namespace truelux::bench
