// SPDX-License-Identifier: GPL-3.0-or-later
// Rings that meet themselves, against winding numbers found slab by slab.

#include "scene/ring_inside.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "scene/integer_ring.h"
#include "scene/integer_winding.h"
#include "scene/polygon.h"
#include "scene/ring_spikes.h"

namespace truelux {
namespace {

bool SamePoint(const IntegerPoint& a, const IntegerPoint& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

bool IsZero(const IntegerPoint& n) {
  return n.x == 0 && n.y == 0 && n.z == 0;
}

/// A normal of the plane of three points that are not on one line.
IntegerPoint AnyNormal(const IntegerRing& ring) {
  for (std::size_t i = 2; i < ring.size(); ++i) {
    const IntegerPoint n =
        Cross(ring.At(1) - ring.At(0), ring.At(i) - ring.At(0));
    if (!IsZero(n)) return n;
  }
  return {0, 0, 0};
}

bool IsIn(const IntegerRing& ring, const IntegerPoint& normal) {
  return std::ranges::all_of(ring.points, [&](const IntegerPoint& p) {
    return Dot(normal, p - ring.At(0)) == 0;
  });
}

/// What a ring is by the rule, and why: a name for each case of it.
struct Expected {
  PolygonKind kind = PolygonKind::kNoArea;
  std::string why;
};

Expected ByTheRule(const IntegerRing& ring, std::vector<Witness>& witnesses) {
  if (ring.OnOneLine()) return {PolygonKind::kNoArea, "line"};
  const bool no_normal = IsZero(ring.Normal());
  const IntegerPoint normal = no_normal ? AnyNormal(ring) : ring.Normal();
  const bool planar = IsIn(ring, normal);
  if (no_normal && !planar) return {PolygonKind::kNotPlanar, "no normal"};
  witnesses = WitnessesOf(ImageOf(ring, normal));
  const bool none = std::ranges::all_of(
      witnesses, [](const Witness& w) { return w.winding == 0; });
  const bool once = std::ranges::all_of(witnesses, [](const Witness& w) {
    return w.winding == 0 || w.winding == 1;
  });
  if (no_normal) {
    return none ? Expected{PolygonKind::kNoArea, "nothing enclosed"}
                : Expected{PolygonKind::kNoPolygon, "balanced"};
  }
  const std::string simple = ring.IsSimple() ? "simple" : "meets itself";
  if (!planar) {
    return {PolygonKind::kNotPlanar,
            (once ? "once, not planar, " : "other, not planar, ") + simple};
  }
  return once ? Expected{PolygonKind::kPlanar, "once, planar, " + simple}
              : Expected{PolygonKind::kNoPolygon, "other, planar, " + simple};
}

/// Whether some point lies on three edges, but on no end of one.
bool ThreeCross(const std::vector<RationalPoint>& image) {
  const std::size_t n = image.size();
  const auto at = [&](std::size_t i) { return image[i % n]; };
  const auto is_on = [&](const RationalPoint& p, std::size_t i) {
    const RationalPoint& a = at(i);
    const RationalPoint& b = at(i + 1);
    const mpq_class along =
        (p.x - a.x) * (b.x - p.x) + (p.y - a.y) * (b.y - p.y);
    return TurnOf(a, b, p) == 0 && along > 0;
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = i + 1; k < n; ++k) {
      const mpq_class from = TurnOf(at(i), at(i + 1), at(k));
      const mpq_class to = TurnOf(at(i), at(i + 1), at(k + 1));
      if (from == to) continue;
      const mpq_class t = from / (from - to);
      const RationalPoint p{at(k).x + t * (at(k + 1).x - at(k).x),
                            at(k).y + t * (at(k + 1).y - at(k).y)};
      int count = 0;
      for (std::size_t e = 0; e < n; ++e)
        count += is_on(p, e) ? 1 : 0;
      if (count >= 3) return true;
    }
  }
  return false;
}

using Triangles = std::vector<RingTriangle>;

Triangles FanOf(std::size_t n) {
  Triangles fan;
  for (int i = 1; i + 1 < static_cast<int>(n); ++i)
    fan.push_back({0, i, i + 1});
  return fan;
}

TEST(RingInside, AgreesWithSlabsOnRandomRings) {
  std::mt19937_64 random(23);
  std::map<std::string, int> seen;
  int looked_at = 0;
  PolygonReader reader;
  for (int i = 0; i < 40000; ++i) {
    IntegerRing ring = RandomIntegerRing(
        random, 4 + random() % 7, random() % 2 == 0 ? 3 : 4, random() % 3 != 0);
    RemoveSpikes(ring.points, SamePoint);
    if (ring.size() < 4) continue;
    std::vector<Witness> witnesses;
    const Expected expected = ByTheRule(ring, witnesses);
    ++seen[expected.why];
    const PolygonKind kind = reader.Read(ring.Points());
    if (kind == PolygonKind::kNoPolygon && expected.why.starts_with("once") &&
        ThreeCross(ImageOf(ring, ring.Normal()))) {
      ++seen["three edges through one point"];
      continue;
    }
    ASSERT_EQ(kind, expected.kind) << expected.why;
    const Triangles triangles(reader.triangles().begin(),
                              reader.triangles().end());
    if (expected.kind == PolygonKind::kNotPlanar &&
        expected.why.starts_with("other")) {
      // The fan as it is, but for triangles without area.
      Triangles fan = FanOf(ring.size());
      std::erase_if(fan, [&](const RingTriangle& t) {
        const auto at = [&](int k) {
          return ring.At(static_cast<std::size_t>(k));
        };
        return IsZero(Cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0])));
      });
      ASSERT_EQ(triangles, fan);
      continue;
    }
    // What is not planar and meets itself is what the rule of ears makes of it.
    if (expected.why == "once, not planar, meets itself") {
      ASSERT_FALSE(triangles.empty());
      continue;
    }
    if (!expected.why.starts_with("once")) continue;
    const auto image = ImageOf(ring, ring.Normal());
    for (const Witness& witness : witnesses) {
      const auto count = CoverCount(image, triangles, witness.point);
      if (!count) continue;
      ASSERT_EQ(*count, witness.winding) << expected.why;
      ++looked_at;
    }
  }
  EXPECT_GT(looked_at, 10000);
  for (const char* why :
       {"nothing enclosed", "balanced", "no normal", "once, planar, simple",
        "once, planar, meets itself", "other, planar, meets itself",
        "once, not planar, simple", "once, not planar, meets itself",
        "other, not planar, meets itself", "three edges through one point"}) {
    EXPECT_GT(seen[why], 5) << why;
  }
}

TEST(RingInside, DoesNotDependOnTheFirstVertex) {
  std::mt19937_64 random(29);
  int meeting = 0;
  PolygonReader reader;
  for (int i = 0; i < 3000; ++i) {
    IntegerRing ring = RandomIntegerRing(random, 6 + random() % 5, 3, true);
    RemoveSpikes(ring.points, SamePoint);
    if (ring.size() < 4) continue;
    const PolygonKind kind = reader.Read(ring.Points());
    if (kind == PolygonKind::kPlanar && !ring.IsSimple()) ++meeting;
    for (std::size_t k = 1; k < ring.size(); ++k) {
      std::ranges::rotate(ring.points, ring.points.begin() + 1);
      ASSERT_EQ(reader.Read(ring.Points()), kind);
    }
  }
  EXPECT_GT(meeting, 50);
}

/// A square with a grid of square holes, each joined to the one before it, the
/// first to the border: a keyhole with n^2 holes.
std::vector<Point3> Sieve(int n) {
  std::vector<Point3> ring{{0, 0, 0}};
  std::vector<Point3> back;
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      const double x = 3.0 * column + 1;
      const double y = 3.0 * row + 1;
      ring.push_back({x, y, 0});
      ring.push_back({x, y + 1, 0});
      ring.push_back({x + 1, y + 1, 0});
      ring.push_back({x + 1, y, 0});
      ring.push_back({x, y, 0});
      back.insert(back.begin(), Point3{x, y, 0});
    }
  }
  ring.insert(ring.end(), back.begin() + 1, back.end());
  const double side = 3.0 * n;
  ring.push_back({0, 0, 0});
  ring.push_back({side, 0, 0});
  ring.push_back({side, side, 0});
  ring.push_back({0, side, 0});
  return ring;
}

TEST(RingInside, AKeyholeMayHaveManyHoles) {
  for (const int n : {1, 2, 5}) {
    const std::vector<Point3> ring = Sieve(n);
    PolygonReader reader;
    ASSERT_EQ(reader.Read(ring), PolygonKind::kPlanar);
    double twice_area = 0;
    for (const RingTriangle& t : reader.triangles()) {
      const Point3& a = ring[static_cast<std::size_t>(t[0])];
      const Point3& b = ring[static_cast<std::size_t>(t[1])];
      const Point3& c = ring[static_cast<std::size_t>(t[2])];
      const double turn = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
      EXPECT_GT(turn, 0);
      twice_area += turn;
    }
    EXPECT_EQ(twice_area, 2.0 * (9 * n * n - n * n));
  }
}

TEST(RingSpikes, AreReducedLikeWords) {
  const auto reduced = [](std::string word) {
    std::vector<char> ring(word.begin(), word.end());
    RemoveSpikes(ring, [](char a, char b) { return a == b; });
    return std::string(ring.begin(), ring.end());
  };
  EXPECT_EQ(reduced("abcd"), "abcd");
  EXPECT_EQ(reduced("abcdc"), "abc");
  EXPECT_EQ(reduced("abcdedc"), "abc");
  EXPECT_EQ(reduced("abxbc"), "abc");
  EXPECT_EQ(reduced("xabca"), "abc");      // across the ends
  EXPECT_EQ(reduced("yxabcax"), "abc");    // twice
  EXPECT_LT(reduced("abcb").size(), 3U);   // nothing is left
  EXPECT_EQ(reduced("abcabc"), "abcabc");  // twice around is no spike
}

}  // namespace
}  // namespace truelux
