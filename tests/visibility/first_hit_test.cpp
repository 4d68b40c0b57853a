// SPDX-License-Identifier: GPL-3.0-or-later
// The first face along a ray against a search in exact rationals over all
// triangles, where rays pass through edges, corners, coplanar overlaps and
// planes seen from the side.

#include "visibility/first_hit.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <vector>

#include <gmpxx.h>

#include <gtest/gtest.h>

#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scenes.h"

namespace truelux {
namespace {

using testing::MakeScene;
using testing::PortableRandom;
using testing::RandomPoint;
using testing::RandomScene;

struct Vec {
  mpq_class x, y, z;
};

Vec Of(const Point3& p) {
  return {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)};
}

Vec Minus(const Vec& a, const Vec& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

mpq_class Dot(const Vec& a, const Vec& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

Vec Cross(const Vec& a, const Vec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// How the twin's answers came about.
struct Kinds {
  int hits = 0;
  int misses = 0;
  int ties = 0;          ///< several triangles in the first point
  int coplanar = 0;      ///< of these, some in one plane but of other faces
  int on_edge = 0;       ///< the first point is on an edge or a corner
  int eye_in_plane = 0;  ///< triangles whose plane holds the origin
  int parallel = 0;
};

/// The intersection with the plane first, then barycentric coordinates: no
/// step is shared with the search that is tested.
std::optional<FirstHit> SlowHit(const Scene& scene, const Ray& ray,
                                Kinds& kinds) {
  const Vec d = Of({ray.direction.x, ray.direction.y, ray.direction.z});
  const Vec o = Of(ray.origin);
  std::optional<FirstHit> first;
  mpq_class least;
  bool tie = false;
  bool coplanar = false;
  bool on_edge = false;
  Vec first_normal;
  for (std::size_t i = 0; i < scene.triangles().size(); ++i) {
    std::vector<Vec> p;
    for (const int v : scene.triangles()[i].vertices)
      p.push_back(Of(scene.vertices()[static_cast<std::size_t>(v)]));
    const Vec u = Minus(p[1], p[0]);
    const Vec v = Minus(p[2], p[0]);
    const Vec n = Cross(u, v);
    const mpq_class speed = Dot(n, d);
    const mpq_class height = Dot(n, Minus(p[0], o));
    if (height == 0) ++kinds.eye_in_plane;
    if (speed == 0) ++kinds.parallel;
    if (height == 0 || speed == 0) continue;
    const mpq_class t = height / speed;
    if (t <= 0) continue;
    const Vec w = Minus({o.x + t * d.x, o.y + t * d.y, o.z + t * d.z}, p[0]);
    const mpq_class nn = Dot(n, n);
    const mpq_class beta = Dot(Cross(w, v), n) / nn;
    const mpq_class gamma = Dot(Cross(u, w), n) / nn;
    if (beta < 0 || gamma < 0 || beta + gamma > 1) continue;
    if (first && t > least) continue;
    if (first && t == least) {
      tie = true;
      const Vec across = Cross(n, first_normal);
      if (Dot(across, across) == 0) coplanar = true;
      const auto kind = [&](std::size_t k, bool front) {
        const Facet& facet =
            scene
                .facets()[static_cast<std::size_t>(scene.triangles()[k].facet)];
        const Face& face = scene.faces()[static_cast<std::size_t>(facet.face)];
        return !front ? 2 : face.is_emitter ? 0 : 1;
      };
      // An emitter's front, another front, a back; then the earlier one stays.
      if (kind(static_cast<std::size_t>(first->triangle), first->from_front) <=
          kind(i, speed < 0)) {
        continue;
      }
      first = FirstHit{static_cast<int>(i), speed < 0};
      on_edge = beta == 0 || gamma == 0 || beta + gamma == 1;
      continue;
    }
    first = FirstHit{static_cast<int>(i), speed < 0};
    least = t;
    first_normal = n;
    tie = false;
    coplanar = false;
    on_edge = beta == 0 || gamma == 0 || beta + gamma == 1;
  }
  ++(first ? kinds.hits : kinds.misses);
  if (tie) ++kinds.ties;
  if (coplanar) ++kinds.coplanar;
  if (first && on_edge) ++kinds.on_edge;
  return first;
}

void ExpectSame(const Scene& scene, const FirstHitFinder& finder,
                const Ray& ray, Kinds& kinds, FirstHitCounts& counts) {
  const std::optional<FirstHit> expected = SlowHit(scene, ray, kinds);
  const std::optional<FirstHit> found = finder.Find(ray, &counts);
  ASSERT_EQ(found.has_value(), expected.has_value());
  if (!found) return;
  EXPECT_EQ(found->triangle, expected->triangle);
  EXPECT_EQ(found->from_front, expected->from_front);
}

Ray RandomRay(PortableRandom& random, bool lattice) {
  Ray ray{RandomPoint(random, lattice, 5), {}};
  do {
    const Point3 d = RandomPoint(random, lattice, 4);
    ray.direction = {d.x, d.y, d.z};
  } while (ray.direction.x == 0 && ray.direction.y == 0 &&
           ray.direction.z == 0);
  return ray;
}

TEST(FirstHit, AgreesWithASlowTwinOnALattice) {
  PortableRandom random(11);
  Kinds kinds;
  FirstHitCounts counts;
  for (int i = 0; i < 150; ++i) {
    const Scene scene =
        MakeScene(RandomScene(random, true, random.Integer(1, 25), 3));
    const FirstHitFinder finder(scene);
    for (int k = 0; k < 80; ++k)
      ExpectSame(scene, finder, RandomRay(random, true), kinds, counts);
  }
  EXPECT_GT(kinds.hits, 2000);
  EXPECT_GT(kinds.misses, 500);
  EXPECT_GT(kinds.ties, 100);
  EXPECT_GT(kinds.coplanar, 50);
  EXPECT_GT(kinds.on_edge, 300);
  EXPECT_GT(kinds.eye_in_plane, 500);
  EXPECT_GT(kinds.parallel, 500);
  EXPECT_GT(counts.side_exact, 1000U);
  EXPECT_GT(counts.order_exact, 200U);
  EXPECT_GT(counts.order_filter, 300U);
}

TEST(FirstHit, AgreesInGeneralPositionAndAtFacesNudgedApart) {
  PortableRandom random(12);
  Kinds kinds;
  FirstHitCounts counts;
  for (int i = 0; i < 60; ++i) {
    std::vector<testing::TestFace> faces =
        RandomScene(random, false, random.Integer(2, 12));
    // The same again, each coordinate by an ulp off or not.
    const std::size_t count = faces.size();
    for (std::size_t k = 0; k < count; ++k) {
      testing::TestFace twin = faces[k];
      for (Point3& p : twin.ring)
        p = {random.Nudge(p.x), random.Nudge(p.y), random.Nudge(p.z)};
      faces.insert(faces.begin(), twin);
    }
    const Scene scene = MakeScene(faces);
    const FirstHitFinder finder(scene);
    for (int k = 0; k < 30; ++k) {
      Ray ray = RandomRay(random, false);
      if (random.OneIn(2)) {  // nearly, or exactly, to a corner
        const Point3& p = scene.vertices()[static_cast<std::size_t>(
            random.Integer(0, static_cast<int>(scene.vertices().size()) - 1))];
        const Point3& o = ray.origin;
        ray.direction = {p.x - o.x, p.y - o.y, p.z - o.z};
      }
      ExpectSame(scene, finder, ray, kinds, counts);
    }
  }
  EXPECT_GT(kinds.hits, 500);
  EXPECT_GT(kinds.misses, 200);
  EXPECT_GT(counts.order_exact, 100U);
  EXPECT_GT(counts.side_exact, 10U);
}

/// From the inside of a closed mesh no ray gets out, whatever it aims at.
TEST(FirstHit, NoRaySlipsBetweenFaces) {
  PortableRandom random(13);
  std::vector<testing::TestFace> faces;
  for (const testing::Ring& ring : testing::BoxAround(1.0 / 3)) {
    faces.push_back({{ring[0], ring[1], ring[2]}});
    faces.push_back({{ring[0], ring[2], ring[3]}});
  }
  const Scene scene = MakeScene(faces);
  const FirstHitFinder finder(scene);
  for (int i = 0; i < 4000; ++i) {
    const Point3 o{random.Uniform(-0.3, 0.3), random.Uniform(-0.3, 0.3),
                   random.Uniform(-0.3, 0.3)};
    const auto corner = [&] {
      return scene.vertices()[static_cast<std::size_t>(random.Integer(0, 7))];
    };
    const Point3 a = corner();
    const Point3 b = corner();
    const double s = random.OneIn(3) ? 0 : random.Unit();
    const Ray ray{o,
                  {a.x + s * (b.x - a.x) - o.x, a.y + s * (b.y - a.y) - o.y,
                   a.z + s * (b.z - a.z) - o.z}};
    ASSERT_TRUE(finder.Find(ray));
  }
}

TEST(FirstHit, ThePointIsRoundedOnceAndNeverBehindTheFace) {
  PortableRandom random(14);
  int lifted = 0;
  for (int i = 0; i < 3000; ++i) {
    const Scene scene = MakeScene(RandomScene(random, false, 1));
    const FirstHitFinder finder(scene);
    const Ray ray = RandomRay(random, false);
    const std::optional<FirstHit> hit = finder.Find(ray);
    if (!hit) continue;
    const auto corner = [&](std::size_t k) {
      return Of(scene.vertices()[static_cast<std::size_t>(
          scene.triangles()[0].vertices[k])]);
    };
    const Vec n =
        Cross(Minus(corner(1), corner(0)), Minus(corner(2), corner(0)));
    const Vec o = Of(ray.origin);
    const Vec d = Of({ray.direction.x, ray.direction.y, ray.direction.z});
    const mpq_class t = Dot(n, Minus(corner(0), o)) / Dot(n, d);
    const Point3 p = finder.PointOn(ray, *hit);
    const mpq_class height = Dot(n, Minus(Of(p), corner(0)));
    EXPECT_TRUE(hit->from_front ? height >= 0 : height <= 0);
    int moved = 0;
    const auto expect_near = [&](double found, const mpq_class& exact) {
      const mpq_class error = abs(mpq_class(found) - exact);
      const double unit =
          std::nextafter(std::fabs(found), HUGE_VAL) - std::fabs(found);
      if (error > 0.54 * unit) ++moved;
      EXPECT_LT(error.get_d(), 2.51 * unit);
    };
    expect_near(p.x, o.x + t * d.x);
    expect_near(p.y, o.y + t * d.y);
    expect_near(p.z, o.z + t * d.z);
    EXPECT_LE(moved, 1);
    lifted += moved;
  }
  EXPECT_GT(lifted, 20);
}

TEST(FirstHit, PointsOfFewDigitsAreExact) {
  const Scene scene = MakeScene(
      {{{{0, 0, 0}, {8, 0, 2}, {8, 8, 6}, {0, 8, 4}}}});  // z = x/4 + y/2
  const FirstHitFinder finder(scene);
  const Ray ray{{1, 1, 16}, {9, 7.5, -39.75}};  // to (4, 3.5, 2.75), t = 1/3
  const auto hit = finder.Find(ray);
  ASSERT_TRUE(hit);
  EXPECT_EQ(finder.PointOn(ray, *hit), (Point3{4, 3.5, 2.75}));
}

TEST(FirstHit, PointsOnAPlaneAcrossAnAxisAreOnIt) {
  PortableRandom random(15);
  int hits = 0;
  for (const double z : {0.0, 0.1, -5.3}) {
    const Scene scene = MakeScene({{testing::Floor(-9, 9, -9, 9, z)}});
    const FirstHitFinder finder(scene);
    for (int i = 0; i < 200; ++i) {
      const Ray ray = RandomRay(random, false);
      const auto hit = finder.Find(ray);
      if (!hit) continue;
      ++hits;
      EXPECT_EQ(finder.PointOn(ray, *hit).z, z);
    }
  }
  EXPECT_GT(hits, 100);
}

TEST(FirstHit, HugeAndTinyScenesAndNoScene) {
  for (const double scale : {0x1p-300, 0x1p-150, 0x1p150, 0x1p300}) {
    const Scene scene = MakeScene(
        {{testing::Scaled(testing::Ceiling(-1, 1, -1, 1, 1), scale)}});
    const FirstHitFinder finder(scene);
    const auto hit = finder.Find({{0.25 * scale, 0, 0}, {1, 0.5, 4}});
    ASSERT_TRUE(hit) << scale;
    EXPECT_EQ(finder.PointOn({{0.25 * scale, 0, 0}, {1, 0.5, 4}}, *hit),
              (Point3{0.5 * scale, 0.125 * scale, scale}));
    EXPECT_FALSE(finder.Find({{0, 0, 0}, {1, 0, 0.5}}));
  }
  EXPECT_FALSE(FirstHitFinder(Scene()).Find({{0, 0, 0}, {0, 0, 1}}));
  EXPECT_THROW((void)FirstHitFinder(Scene()).Find({{0, 0, 0}, {0, 0, 0}}),
               std::invalid_argument);
  EXPECT_THROW((void)FirstHitFinder(Scene()).Find({{0, NAN, 0}, {0, 0, 1}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace truelux
