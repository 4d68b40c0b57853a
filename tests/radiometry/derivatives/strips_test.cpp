// SPDX-License-Identifier: GPL-3.0-or-later
// Kinks by strips at the receiver itself (strips_twin.h): planes, sizes and
// zeros have the same bits as by steps to both sides.

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/derivatives.h"

#include "radiometry/derivatives/rectangle_slopes.h"
#include "radiometry/derivatives/strips_twin.h"
#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scenes.h"
#include "support/sweep.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

constexpr Receiver kOriginUp = {{0, 0, 0}, {0, 0, 1}, 0};
constexpr Rgb kUnit = {1, 1, 1};

/// What has been compared.
struct Counts {
  int receivers = 0;
  int planes = 0;   ///< that hold a face or two lines
  int zeros = 0;    ///< of these without a kink
  int touched = 0;  ///< receivers on a face
  int level = 0;    ///< of these those on its lit side only
  int dark = 0;     ///< receivers with a kink and E = 0
  int several = 0;  ///< receivers with more than one kink
  int partial = 0;  ///< kinks of some channels only
  // Kinks by what lies in their planes.
  int sources = 0;   ///< an emitting face
  int blockers = 0;  ///< black faces only
  int cuts = 0;      ///< a line where faces pierce each other
  int corners = 0;   ///< two edges that meet in a vertex
  int parallel = 0;  ///< two parallel edges
  int other = 0;     ///< two edges that lie in a plane by chance
};

bool AreParallel(const Vector3& a, const Vector3& b) {
  return a.x * b.y == a.y * b.x && a.y * b.z == a.z * b.y &&
         a.z * b.x == a.x * b.z;
}

void CountKink(const Scene& scene, const std::vector<TestFace>& faces,
               const Kink& kink, Counts& counts) {
  if (std::ranges::count(kink.size, 0) > 0) ++counts.partial;
  if (!kink.faces.empty()) {
    const bool emits = std::ranges::any_of(kink.faces, [&faces](int number) {
      return faces[static_cast<std::size_t>(number) - 1].emission != Rgb{};
    });
    ++(emits ? counts.sources : counts.blockers);
    return;
  }
  if (kink.edges[0][0] < 0 || kink.edges[1][0] < 0) {
    ++counts.cuts;
    return;
  }
  std::array<std::array<Point3, 2>, 2> ends;
  std::array<Vector3, 2> along;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      ends[i][k] = scene.vertices()[static_cast<std::size_t>(kink.edges[i][k])];
    }
    along[i] = {ends[i][1].x - ends[i][0].x, ends[i][1].y - ends[i][0].y,
                ends[i][1].z - ends[i][0].z};
  }
  if (AreParallel(along[0], along[1])) {
    ++counts.parallel;
  } else if (std::ranges::find_first_of(ends[0], ends[1]) != ends[0].end()) {
    ++counts.corners;
  } else {
    ++counts.other;
  }
}

/// Compares kinks that are known with those of the twin.
void CompareKinks(const StripsTwin& twin, const std::vector<Kink>& kinks,
                  Counts& counts) {
  std::size_t found = 0;
  for (const TwinPlane& plane : twin.Planes()) {
    const auto kink = std::ranges::find(kinks, plane.normal, &Kink::normal);
    const Rgb expected = kink == kinks.end() ? Rgb{} : kink->size;
    EXPECT_EQ(plane.size, expected)
        << plane.normal.x << ' ' << plane.normal.y << ' ' << plane.normal.z;
    ++counts.planes;
    if (kink == kinks.end()) {
      ++counts.zeros;
    } else {
      ++found;
    }
  }
  EXPECT_EQ(found, kinks.size());
}

/// The kinks at a receiver, once they have been compared.
std::vector<Kink> Compare(const std::vector<TestFace>& faces, Receiver receiver,
                          Counts& counts) {
  const Scene scene = MakeScene(faces);
  const Derivatives derivatives =
      Oracle(scene).Derivatives(receiver, {.sphere = false, .jacobian = false});
  StripsTwin twin(faces, receiver);
  ++counts.receivers;
  if (const std::vector<int> touched = twin.Touched(); !touched.empty()) {
    ++counts.touched;
    if (!std::ranges::all_of(
            touched, [&twin](int number) { return twin.IsLevel(number); })) {
      EXPECT_EQ(derivatives.smoothness,
                twin.MayBeLit() ? Smoothness::kDiscontinuous : Smoothness::kC1);
      return {};
    }
    ++counts.level;
    receiver.on_face = touched.front();
    twin = StripsTwin(faces, receiver);
  }
  EXPECT_EQ(derivatives.smoothness,
            derivatives.kinks.empty() ? Smoothness::kC1 : Smoothness::kKink);
  CompareKinks(twin, derivatives.kinks, counts);
  for (const Kink& kink : derivatives.kinks)
    CountKink(scene, faces, kink, counts);
  if (derivatives.kinks.size() > 1) ++counts.several;
  if (!derivatives.kinks.empty() && derivatives.irradiance.value == Rgb{})
    ++counts.dark;
  return derivatives.kinks;
}

/// b of the plane x = 0, the only kink of a scene seen from the origin; 0 if
/// there is none.
double SizeAcrossX(const std::vector<TestFace>& faces) {
  Counts counts;
  const std::vector<Kink> kinks = Compare(faces, kOriginUp, counts);
  EXPECT_GT(counts.planes, 0);
  if (kinks.empty()) return 0;
  EXPECT_EQ(kinks.size(), 1U);
  EXPECT_EQ(kinks[0].normal, (Vector3{1, 0, 0}));
  return kinks[0].size[0];
}

/// The slope of E, for the lamp z = 2 from y = -1 to 1, if its edge x = 0 moves
/// as one at the height h does.
double SlopeAt(double h) {
  return 2 / h * LineSlope(2, 0, -1, 1);
}

TEST(Strips, ANearEdgeOverAFarOne) {
  const double expected = 0.5 * (SlopeAt(2) - SlopeAt(1));
  EXPECT_NEAR(SizeAcrossX({{Ceiling(0, 2, -1, 1, 2), kUnit},
                           {Ceiling(-3, 0, -4, 4, 1)}}),
              expected, 1e-16);
}

TEST(Strips, AFarEdgeHiddenUpToTheNearOne) {
  const double expected = 0.5 * (SlopeAt(1) - SlopeAt(2));
  EXPECT_NEAR(SizeAcrossX({{Ceiling(0, 2, -1, 1, 2), kUnit},
                           {Ceiling(0, 3, -4, 4, 1)}}),
              expected, 1e-16);
}

TEST(Strips, ASlitThatJustCloses) {
  const double expected = 0.5 * (SlopeAt(1) - SlopeAt(1.5));
  EXPECT_NEAR(SizeAcrossX({{Ceiling(-2, 2, -1, 1, 2), kUnit},
                           {Ceiling(0, 3, -4, 4, 1)},
                           {Ceiling(-3, 0, -4, 4, 1.5)}}),
              expected, 1e-16);
}

/// The lamp behind an edge-on wall from z = 1 to 1.5 that hides all of a line.
std::vector<TestFace> EdgeOnWall(const Rgb& front) {
  return {{Ceiling(-2, 2, -1, 1, 2), kUnit},
          {{{0, -4, 1}, {0, 4, 1}, {0, 4, 1.5}, {0, -4, 1.5}}, front}};
}

TEST(Strips, AnEdgeOnWallBeforeALamp) {
  EXPECT_NEAR(SizeAcrossX(EdgeOnWall({})), SlopeAt(1.5) - SlopeAt(1), 1e-16);
}

/// A shorter wall, beyond which the lamp is seen on all sides.
std::vector<TestFace> WallBeforeLamp(const Rgb& front) {
  return {{Ceiling(-2, 2, -1, 1, 2), kUnit},
          {{{0, -0.5, 1}, {0, 0.5, 1}, {0, 0.5, 1.5}, {0, -0.5, 1.5}}, front}};
}

TEST(Strips, AWallThatEmitsTwiceTheLampMakesNoKink) {
  EXPECT_EQ(SizeAcrossX(WallBeforeLamp({2, 2, 2})), 0);
  const double black = SizeAcrossX(WallBeforeLamp({}));
  EXPECT_LT(black, -0.01);
  EXPECT_NEAR(SizeAcrossX(WallBeforeLamp({3, 3, 3})), -0.5 * black, 1e-16);
  EXPECT_NEAR(SizeAcrossX(WallBeforeLamp({1, 1, 1})), 0.5 * black, 1e-16);
}

TEST(Strips, AnEdgeOnLampInTheDark) {
  const std::vector<TestFace> faces = {
      {{{0, -1, 1}, {0, 1, 1}, {0, 1, 2}, {0, -1, 2}}, kUnit}};
  Counts counts;
  EXPECT_EQ(Compare(faces, kOriginUp, counts).size(), 1U);
  EXPECT_EQ(counts.dark, 1);
  EXPECT_EQ(counts.sources, 1);
}

TEST(Strips, TwoEdgesThatMeet) {
  const Ring lamp = {{0, 0, 2}, {0, 1, 2}, {1, 0, 2}};
  const Ring blocker = {{0, 0, 2}, {0, 1, 1.5}, {-1, 0, 1.5}};
  Counts counts;
  for (const Ring& ring : {blocker, Reversed(blocker)}) {
    const auto kinks = Compare({{lamp, kUnit}, {ring}}, kOriginUp, counts);
    EXPECT_EQ(kinks.size(), 1U);
  }
  EXPECT_EQ(counts.corners, 2);
}

// A wall that leans towards the receiver pierces the lamp along x = 0, and is
// cut there; an edge at the height 1 covers the line.
TEST(Strips, AnEdgeOverACut) {
  const TestFace lamp = {Ceiling(-1.5, 2, -1, 1, 2), kUnit};
  const TestFace wall = {{{-1, -4, 1}, {-1, 4, 1}, {1, 4, 3}, {1, -4, 3}}};
  const TestFace edge = {Ceiling(-0.25, 0, -4, 4, 1)};
  Counts counts;
  EXPECT_TRUE(Compare({lamp, wall}, kOriginUp, counts).empty());
  EXPECT_EQ(Compare({lamp, wall, edge}, kOriginUp, counts).size(), 1U);
  EXPECT_EQ(counts.cuts, 1);
}

// A kink behind a third face, and two edges that are one in space.
TEST(Strips, NoKinks) {
  EXPECT_EQ(SizeAcrossX({{Ceiling(0, 2, -1, 1, 2), kUnit},
                         {Ceiling(-3, 0, -4, 4, 1)},
                         {Ceiling(-1, 1, -2, 2, 0.5)}}),
            0);
  Counts counts;
  EXPECT_TRUE(Compare({{Ceiling(0, 2, -1, 1, 2), kUnit},
                       {Ceiling(-2, 0, -1, 1, 2), {2, 2, 2}}},
                      kOriginUp, counts)
                  .empty());
  EXPECT_EQ(counts.planes, 0);
}

/// Some are twice others, and some lack a channel.
Rgb RandomEmission(PortableRandom& random) {
  const double m = random.OneIn(2) ? random.Integer(1, 4) : 0;
  return {m, random.OneIn(2) ? 0.5 * m : 0, m > 0 ? 2.0 : 0};
}

/// Rectangles across the axes: kinks nearly everywhere.
std::vector<TestFace> Shelves(PortableRandom& random, int count) {
  std::vector<TestFace> faces;
  while (static_cast<int>(faces.size()) < count) {
    const int axis = random.Integer(0, 2);
    const Point3 a = RandomPoint(random, true, 2);
    const Point3 b = RandomPoint(random, true, 2);
    Ring ring = {a, a, b, b};
    if (axis == 0) {
      for (Point3& p : ring)
        p.x = a.x;
      ring[1].z = b.z;
      ring[3].z = a.z;
    } else if (axis == 1) {
      for (Point3& p : ring)
        p.y = a.y;
      ring[1].x = b.x;
      ring[3].x = a.x;
    } else {
      for (Point3& p : ring)
        p.z = a.z;
      ring[1].y = b.y;
      ring[3].y = a.y;
    }
    if (OnOneLine(ring[0], ring[1], ring[2])) continue;
    faces.push_back({ring, RandomEmission(random)});
  }
  return faces;
}

/// A lamp at z = 4 that a slanted wall pierces at x = 2k, and a shelf at z = 2
/// with an edge at x = k: seen from the origin, the edge covers the cut.
std::vector<TestFace> PiercedLamp(PortableRandom& random) {
  const double k = random.Integer(-2, 2);
  const double up = random.Integer(-2, 2);
  const double y0 = random.Integer(-3, 0);
  const double y1 = random.Integer(1, 3);
  Ring wall = {{2 * k - 1, y0, 4 - up},
               {2 * k - 1, y1, 4 - up},
               {2 * k + 1, y1, 4 + up},
               {2 * k + 1, y0, 4 + up}};
  if (random.OneIn(2)) wall = Reversed(wall);
  const double width = random.OneIn(2) ? 1 : -1;
  Ring shelf = Ceiling(k, k + width, y0, random.Integer(1, 3), 2);
  if (random.OneIn(2)) shelf = Reversed(shelf);
  std::vector<TestFace> faces = {{Ceiling(-6, 6, -2, 3, 4), {2, 1, 1}},
                                 {wall, RandomEmission(random)},
                                 {shelf, RandomEmission(random)}};
  for (const TestFace& face :
       RandomScene(random, true, random.Integer(0, 2), 3)) {
    faces.push_back(face);
  }
  return faces;
}

enum class Kind { kSoup, kShelves, kMixed, kPierced };

std::vector<TestFace> FacesOfKind(Kind kind, PortableRandom& random) {
  const int count = random.Integer(3, 10);
  if (kind == Kind::kSoup) return RandomScene(random, true, count, 3);
  if (kind == Kind::kPierced) return PiercedLamp(random);
  std::vector<TestFace> faces = Shelves(random, count);
  if (kind == Kind::kMixed) {
    for (const TestFace& face : RandomScene(random, true, count, 3))
      faces.push_back(face);
  }
  return faces;
}

/// At a lattice point, often with a normal along an axis.
Receiver ReceiverOfKind(Kind kind, PortableRandom& random) {
  if (kind == Kind::kPierced) {
    const Point3 n = RandomPoint(random, true, 2);
    return {{0, 0, 0}, {n.x, n.y, 3}, 0};
  }
  Receiver receiver = RandomReceiver(random, true, kind == Kind::kSoup ? 3 : 2);
  if (kind == Kind::kShelves && random.OneIn(2)) {
    const double sign = random.OneIn(2) ? 1 : -1;
    receiver.normal = {0, 0, 0};
    (random.OneIn(2) ? receiver.normal.x : receiver.normal.z) = sign;
  }
  return receiver;
}

TEST(Strips, HaveTheBitsOfLimitsOnLattices) {
  Counts counts;
  for (const Kind kind :
       {Kind::kSoup, Kind::kShelves, Kind::kMixed, Kind::kPierced}) {
    for (int seed = 0; seed < SweepSize(60, 600); ++seed) {
      PortableRandom random(static_cast<std::uint64_t>(seed) * 4 + 61000 +
                            static_cast<std::uint64_t>(kind));
      const std::vector<TestFace> faces = FacesOfKind(kind, random);
      for (int i = 0; i < 3; ++i) {
        Compare(faces, ReceiverOfKind(kind, random), counts);
        if (HasFailure()) FAIL() << "seed " << seed << ", receiver " << i;
      }
    }
  }
  for (const auto& [name, count] :
       std::vector<std::pair<std::string, int>>{{"receivers", counts.receivers},
                                                {"planes", counts.planes},
                                                {"zeros", counts.zeros},
                                                {"touched", counts.touched},
                                                {"level", counts.level},
                                                {"dark", counts.dark},
                                                {"several", counts.several},
                                                {"partial", counts.partial},
                                                {"sources", counts.sources},
                                                {"blockers", counts.blockers},
                                                {"cuts", counts.cuts},
                                                {"corners", counts.corners},
                                                {"parallel", counts.parallel},
                                                {"other", counts.other}}) {
    EXPECT_GT(count, 2) << name;
    RecordProperty(name, count);
  }
}

}  // namespace
}  // namespace truelux
