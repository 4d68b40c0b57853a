// SPDX-License-Identifier: GPL-3.0-or-later
// Random scenes that are hard for sums in double, by kinds.

#ifndef TRUELUX_TESTS_RADIOMETRY_DERIVATIVES_HARD_SCENES_H_
#define TRUELUX_TESTS_RADIOMETRY_DERIVATIVES_HARD_SCENES_H_

#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "truelux/geometry.h"
#include "truelux/receiver.h"

#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scenes.h"

namespace truelux::testing {

/// What is hard about a scene.
enum class Hardness {
  kGeneral,      ///< a soup in general position
  kLattice,      ///< on a lattice, the receivers beside its points
  kOnLattice,    ///< on a lattice, the receivers as well: kinks
  kNoise,        ///< a lattice with one ulp of noise
  kOffset1e6,    ///< a soup 1e6 m from the origin
  kOffset1e9,    ///< a soup 1e9 m from the origin
  kTiny,         ///< everything within 1e-6 rad as seen
  kSlivers,      ///< triangles 1e-4 to 1e-9 as wide as long
  kConjunction,  ///< three edges through one point as seen, or 1e-12 beside
  kHorizon,      ///< light 1e-6 above the receiver plane
  kEdgeOn,       ///< receivers 1e-9 beside the plane of a face
};

inline constexpr std::pair<Hardness, std::string_view> kHardnesses[] = {
    {Hardness::kGeneral, "general soups"},
    {Hardness::kLattice, "lattices"},
    {Hardness::kOnLattice, "on lattices"},
    {Hardness::kNoise, "lattices with noise"},
    {Hardness::kOffset1e6, "1e6 m away"},
    {Hardness::kOffset1e9, "1e9 m away"},
    {Hardness::kTiny, "1e-6 rad"},
    {Hardness::kSlivers, "slivers"},
    {Hardness::kConjunction, "near conjunctions"},
    {Hardness::kHorizon, "near the horizon"},
    {Hardness::kEdgeOn, "nearly edge-on"},
};

/// A scene with receivers.
struct HardScene {
  std::vector<TestFace> faces;
  std::vector<Receiver> receivers;
};

/// Makes one.
class HardSceneMaker {
 public:
  HardSceneMaker(Hardness hardness, std::uint64_t seed)
      : hardness_(hardness), random_(seed) {}

  HardScene Make(int receiver_count) {
    HardScene made;
    made.faces = MakeFaces();
    for (int i = 0; i < receiver_count; ++i)
      made.receivers.push_back(MakeReceiver(made.faces));
    const double offset = hardness_ == Hardness::kOffset1e6   ? 1e6
                          : hardness_ == Hardness::kOffset1e9 ? 1e9
                                                              : 0;
    for (TestFace& face : made.faces) {
      for (Point3& p : face.ring)
        p = Plus(p, {offset, -0.5 * offset, 0.75 * offset});
    }
    for (Receiver& r : made.receivers) {
      r.position = Plus(r.position, {offset, -0.5 * offset, 0.75 * offset});
    }
    return made;
  }

 private:
  static Point3 Plus(const Point3& p, const Vector3& v) {
    return {p.x + v.x, p.y + v.y, p.z + v.z};
  }

  [[nodiscard]] bool IsOnLattice() const {
    return hardness_ == Hardness::kLattice ||
           hardness_ == Hardness::kOnLattice || hardness_ == Hardness::kNoise;
  }

  Vector3 RandomVector(double size) {
    return {random_.Uniform(-size, size), random_.Uniform(-size, size),
            random_.Uniform(-size, size)};
  }

  Rgb RandomEmission() {
    const double m = random_.OneIn(2) ? random_.Integer(1, 5) : 0;
    return {m, m * 0.5, m * m};
  }

  std::vector<TestFace> MakeFaces() {
    if (hardness_ == Hardness::kTiny) return TinyFaces();
    if (hardness_ == Hardness::kConjunction) return CrossingFaces();
    if (hardness_ == Hardness::kSlivers) return Slivers();
    if (hardness_ == Hardness::kHorizon) return LowFaces();
    std::vector<TestFace> faces = RandomScene(random_, IsOnLattice(), 12);
    if (hardness_ == Hardness::kNoise) {
      for (TestFace& face : faces) {
        face.ring.resize(3);  // noise would bend a quad
        for (Point3& p : face.ring)
          p = {random_.Nudge(p.x), random_.Nudge(p.y), random_.Nudge(p.z)};
      }
    }
    return faces;
  }

  /// Triangles of a size around a point, the first one emits.
  std::vector<TestFace> TinyFaces() {
    std::vector<TestFace> faces;
    const double size = std::pow(10, -random_.Uniform(5.5, 6.5));
    for (int i = 0; i < 5; ++i) {
      // Blockers between the source and the origin.
      const Point3 middle = {0, 0, i == 0 ? 1 : random_.Uniform(0.3, 0.9)};
      Ring ring;
      for (int k = 0; k < 3; ++k)
        ring.push_back(Plus(middle, RandomVector(size)));
      faces.push_back({ring, i == 0 ? Rgb{3, 1, 9} : RandomEmission()});
      if (i == 0) faces.push_back({Reversed(ring), {3, 1, 9}});
    }
    return faces;
  }

  std::vector<TestFace> Slivers() {
    std::vector<TestFace> faces = RandomScene(random_, false, 3);
    for (int i = 0; i < 10; ++i) {
      const Point3 a = RandomPoint(random_, false, 4);
      const Point3 b = RandomPoint(random_, false, 4);
      const double t = random_.Unit();
      const Point3 c = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y),
                        a.z + t * (b.z - a.z)};
      const double width = std::pow(10, -random_.Uniform(4, 9));
      faces.push_back({{a, b, Plus(c, RandomVector(width))}, RandomEmission()});
    }
    return faces;
  }

  /// Edges of three blockers at 1, 2 and 3 times a point, before a lamp.
  std::vector<TestFace> CrossingFaces() {
    const Point3 p = {random_.Uniform(-0.3, 0.3), random_.Uniform(-0.3, 0.3),
                      1};
    std::vector<TestFace> faces = {{Ceiling(-4, 4, -4, 4, 4), {2, 1, 4}}};
    const double miss = random_.OneIn(4) ? 0 : 1e-12;
    for (int i = 1; i <= 3; ++i) {
      const Vector3 d = RandomVector(1);
      const Point3 middle =
          Plus({i * p.x, i * p.y, i * p.z}, RandomVector(miss));
      const Point3 third = Plus(middle, RandomVector(0.8));
      faces.push_back(
          {{Plus(middle, {0.4 * d.x, 0.4 * d.y, 0.4 * d.z}),
            Plus(middle, {-0.4 * d.x, -0.4 * d.y, -0.4 * d.z}), third},
           RandomEmission()});
    }
    return faces;
  }

  /// Sources from just below to just above the plane z = 0.
  std::vector<TestFace> LowFaces() {
    std::vector<TestFace> faces;
    for (int i = 0; i < 10; ++i) {
      Ring ring;
      for (int k = 0; k < 3; ++k) {
        Point3 p = RandomPoint(random_, false, 4);
        p.z *= random_.OneIn(3) ? 1 : 1e-6;
        ring.push_back(p);
      }
      faces.push_back({ring, RandomEmission()});
    }
    return faces;
  }

  Receiver MakeReceiver(const std::vector<TestFace>& faces) {
    Receiver r = RandomReceiver(random_, IsOnLattice());
    switch (hardness_) {
      case Hardness::kLattice:
        r.position = Plus(r.position, RandomVector(0.4));
        break;
      case Hardness::kTiny:
        r = {{0, 0, 0}, {random_.Uniform(-1, 1), random_.Uniform(-1, 1), 1}, 0};
        r.position = Plus(r.position, RandomVector(1e-7));
        break;
      case Hardness::kConjunction:
        r.position =
            random_.OneIn(2) ? Point3{} : Plus(Point3{}, RandomVector(1e-13));
        r.normal = {r.normal.x, r.normal.y, 4};
        break;
      case Hardness::kHorizon:
        r.position.z = random_.Uniform(-1e-6, 1e-6);
        r.normal = {0, 0, random_.OneIn(2) ? 1.0 : -1.0};
        break;
      case Hardness::kEdgeOn: {
        const Ring& ring = faces[static_cast<std::size_t>(random_.Integer(
                                     0, static_cast<int>(faces.size()) - 1))]
                               .ring;
        const double s = random_.Uniform(-3, 3);
        const double t = random_.Uniform(-3, 3);
        const auto at = [&](double a, double b, double c) {
          return a + s * (b - a) + t * (c - a);
        };
        r.position = Plus({at(ring[0].x, ring[1].x, ring[2].x),
                           at(ring[0].y, ring[1].y, ring[2].y),
                           at(ring[0].z, ring[1].z, ring[2].z)},
                          RandomVector(1e-9));
        break;
      }
      default:
        break;
    }
    return r;
  }

  Hardness hardness_;
  PortableRandom random_;
};

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_RADIOMETRY_DERIVATIVES_HARD_SCENES_H_
