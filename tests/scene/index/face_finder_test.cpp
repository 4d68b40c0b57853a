// SPDX-License-Identifier: GPL-3.0-or-later
// The face that a receiver lies on: against a search through all triangles
// with quotients of whole numbers, and where rounding puts receivers.

#include "scene/index/face_finder.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/scene.h"

#include "scene/near_twin.h"
#include "scene/scene_access.h"
#include "support/portable_random.h"
#include "support/scene_text.h"
#include "support/scenes.h"
#include "support/sweep.h"

namespace truelux {
namespace {

using testing::MakeScene;
using testing::NearTwin;
using testing::NearTwinOf;
using testing::PortableRandom;
using testing::TestFace;

std::vector<int> AllFaces(const Scene& scene) {
  std::vector<int> faces(scene.faces().size());
  std::iota(faces.begin(), faces.end(), 0);
  return faces;
}

std::array<Point3, 3> CornersOf(const Scene& scene, const Triangle& triangle) {
  std::array<Point3, 3> corners;
  for (std::size_t k = 0; k < 3; ++k)
    corners[k] =
        scene.vertices()[static_cast<std::size_t>(triangle.vertices[k])];
  return corners;
}

/// t for one face, by the text of the rule.
mpq_class LimitOf(const Scene& scene, const Face& face,
                  const Receiver& receiver, std::optional<double> limit) {
  if (limit) return *limit;
  const Point3& p = receiver.position;
  mpq_class t = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  t /= 1 << 22;
  mpq_class longest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    mpq_class low;
    mpq_class high;
    for (int i = 0; i < face.corner_count; ++i) {
      const int v =
          scene.corners()[static_cast<std::size_t>(face.first_corner) +
                          static_cast<std::size_t>(i)];
      const Point3& q = scene.vertices()[static_cast<std::size_t>(v)];
      const mpq_class x = axis == 0 ? q.x : axis == 1 ? q.y : q.z;
      if (i == 0 || x < low) low = x;
      if (i == 0 || x > high) high = x;
    }
    if (high - low > longest) longest = high - low;
  }
  return t + longest / (1 << 20);
}

struct TwinAnswer {
  int number = 0;
  bool has_second = false;
  bool is_behind = false;
};

/// All triangles, one by one. by_distance: no limit, and distances to faces.
TwinAnswer AskTwin(const Scene& scene, const Receiver& receiver,
                   std::optional<double> limit, bool by_distance) {
  TwinAnswer answer;
  std::optional<std::tuple<int, mpq_class, int>> best;
  int any = 0;
  for (const Triangle& triangle : scene.triangles()) {
    const Facet& facet =
        scene.facets()[static_cast<std::size_t>(triangle.facet)];
    const Face& face = scene.faces()[static_cast<std::size_t>(facet.face)];
    const NearTwin twin = NearTwinOf(CornersOf(scene, triangle), receiver);
    if (!by_distance) {
      const mpq_class t = LimitOf(scene, face, receiver, limit);
      if (twin.plane > t * t || twin.foot > t * t) continue;
      answer.is_behind = answer.is_behind || twin.is_behind;
      const int number = facet.face + 1;
      answer.has_second = answer.has_second || (any != 0 && any != number);
      any = number;
    }
    if (twin.turn == 3) continue;
    const std::tuple<int, mpq_class, int> place(
        twin.turn, by_distance ? twin.distance : twin.plane, facet.face);
    if (!best || place < *best) best = place;
  }
  if (best) answer.number = std::get<2>(*best) + 1;
  return answer;
}

/// Triangles and quads with whole coordinates up to 4; some quads are not flat.
Scene SceneOnGrid(PortableRandom& random) {
  SceneBuilder builder("scene");
  for (;;) {
    const int faces = random.Integer(1, 9);
    for (int i = 0; i < faces; ++i) {
      std::vector<Point3> ring;
      const int corners = random.Integer(3, 4);
      for (int k = 0; k < corners; ++k) {
        ring.push_back({static_cast<double>(random.Integer(-4, 4)),
                        static_cast<double>(random.Integer(-4, 4)),
                        static_cast<double>(random.Integer(-1, 1))});
      }
      builder.AddFace(ring);
    }
    builder.SetLenient(true);
    Result<Scene> scene = builder.Build();
    if (scene.ok()) return *scene.value;
  }
}

Receiver ReceiverNear(PortableRandom& random, double scale) {
  const auto coordinate = [&] {
    return random.Integer(-4, 4) + random.Integer(-4, 4) * scale;
  };
  Receiver receiver;
  const double x = coordinate();
  const double y = coordinate();
  receiver.position = {x, y,
                       random.Integer(-1, 1) + random.Integer(-9, 9) * scale};
  const std::array<Vector3, 6> normals = {
      {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {1, 1, 1}, {3, 0, 1}, {0, -3, -1}}};
  receiver.normal = normals[static_cast<std::size_t>(random.Integer(0, 5))];
  return receiver;
}

void ExpectLikeTwin(const std::optional<NearFace>& found,
                    const TwinAnswer& twin) {
  ASSERT_EQ(found ? found->number : 0, twin.number);
  if (found) {
    ASSERT_EQ(found->has_second, twin.has_second);
  }
}

// Steps of 2^-20 and 2^-22 of the coordinates put receivers on both sides of
// the default limit, and on it.
TEST(FaceFinder, FindsWhatASearchThroughAllFinds) {
  PortableRandom random(5);
  std::array<int, 2> found{};
  int behind = 0;
  int seconds = 0;
  const int count = testing::SweepSize(300, 3000);
  for (int i = 0; i < count; ++i) {
    const Scene scene = SceneOnGrid(random);
    const FaceFinder finder(scene, AllFaces(scene));
    for (int k = 0; k < 10; ++k) {
      const bool has_limit = k % 2 == 0;
      const Receiver receiver =
          ReceiverNear(random, has_limit ? 0.25 : 0x1p-20);
      const std::optional<double> limit =
          has_limit ? std::optional<double>(random.Integer(0, 4) * 0.25)
                    : std::nullopt;
      const TwinAnswer twin = AskTwin(scene, receiver, limit, false);
      ExpectLikeTwin(scene.FaceNear(receiver, limit), twin);
      if (!has_limit) {
        ASSERT_EQ(scene.IsBehindFace(receiver), twin.is_behind);
        behind += twin.is_behind ? 1 : 0;
      }
      if (twin.number > 0) ++found[has_limit ? 1 : 0];
      seconds += twin.has_second ? 1 : 0;
      const TwinAnswer nearest = AskTwin(scene, receiver, {}, true);
      ExpectLikeTwin(finder.Nearest(scene, receiver), nearest);
    }
  }
  EXPECT_GT(found[0], count / 4);
  EXPECT_GT(found[1], count / 2);
  EXPECT_GT(behind, count / 10);
  EXPECT_GT(seconds, count / 4);
}

// A cube of side 1 below a far and large ground, from very near to far away.
TEST(FaceFinder, TheNearestIsFoundFromAnyDistance) {
  const std::vector<TestFace> faces = {
      {testing::Floor(0, 1, 0, 1, 1)},
      {testing::Floor(-1e6, 1e6, -1e6, 1e6, -3)},
      {testing::Ceiling(0, 1, 0, 1, 0)}};
  const Scene scene = MakeScene(faces);
  const FaceFinder finder(scene, AllFaces(scene));
  for (int exponent = -900; exponent < 900; exponent += 3) {
    const double z = std::ldexp(1.0, exponent);
    const auto found = finder.Nearest(scene, {{0.5, 0.5, 1 + z}, {0, 0, 1}});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->number, 1) << z;
    EXPECT_EQ(finder.Nearest(scene, {{0.5, 0.5, 1 + z}, {0, 0, -1}})->number, 3)
        << z;
    EXPECT_EQ(finder.Nearest(scene, {{9, 9, -3 - z}, {0, 0, 1}})->number, 2)
        << z;
  }
}

TEST(FaceFinder, NothingIsFoundAcross) {
  const Scene scene = MakeScene({{testing::Floor(0, 1, 0, 1, 0)}});
  const Receiver across{{0.5, 0.5, 0}, {1, 0, 0}};
  EXPECT_FALSE(scene.FaceNear(across));
  EXPECT_FALSE(FaceFinder(scene, AllFaces(scene)).Nearest(scene, across));
  EXPECT_FALSE(scene.IsBehindFace(across));
  EXPECT_FALSE(Scene().FaceNear(across));
  EXPECT_FALSE(Scene().FaceNear(across, "no name"));
}

TEST(FaceFinder, ReceiversThatAreNoneHaveNoFace) {
  const Scene scene = MakeScene({{testing::Floor(0, 1, 0, 1, 0)}});
  EXPECT_TRUE(scene.FaceNear({{0.5, 0.5, 0}, {0, 0, 1}}));
  EXPECT_FALSE(scene.FaceNear({{0.5, 0.5, 0}, {0, 0, 0}}));
  EXPECT_FALSE(scene.FaceNear({{0.5, 0.5, NAN}, {0, 0, 1}}));
  EXPECT_FALSE(scene.FaceNear({{0.5, 0.5, 0}, {0, 0, HUGE_VAL}}));
}

// Names as --surface knows them; far away is near enough.
TEST(FaceFinder, NamesChooseAmongTheirFaces) {
  const Scene scene = SceneFromText(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 5\nv 1 0 5\nv 1 1 5\n"
      "o Floor\nf 1 2 3\ng strip\nf 1 3 4\no Roof\nf 5 6 7\n");
  const Receiver receiver{{0.25, 0.75, 0.5}, {0, 0, 1}};
  EXPECT_FALSE(scene.FaceNear(receiver));
  EXPECT_EQ(scene.FaceNear(receiver, "Floor")->number, 2);
  EXPECT_EQ(scene.FaceNear(receiver, "Floor")->distance, 0.5);
  EXPECT_EQ(scene.FaceNear(receiver, "Roof")->number, 3);
  EXPECT_EQ(scene.FaceNear({{0.75, 0.25, 9}, {0, 0, 1}}, "Floor")->number, 1);
  EXPECT_FALSE(scene.FaceNear(receiver, "Cellar"));
}

// A tilted floor in binary32, its texels in binary32, too: all find it, and
// about half of them lie behind it.
TEST(FaceFinder, ATiltedFloorInBinary32IsFoundEverywhere) {
  const auto single = [](double x) {
    return static_cast<double>(static_cast<float>(x));
  };
  const double c = std::cos(0.4);
  const double s = std::sin(0.4);
  const auto on_floor = [&](double u, double v) {
    return Point3{single(10 * u * c - 3), single(7 * v + 100),
                  single(10 * u * s + 2)};
  };
  const Scene scene = MakeScene(
      {{{on_floor(0, 0), on_floor(1, 0), on_floor(1, 1), on_floor(0, 1)}}});
  ASSERT_GE(scene.facets().size(), 1U);
  int behind = 0;
  for (int i = 0; i < 64; ++i) {
    for (int k = 0; k < 64; ++k) {
      const Receiver texel{on_floor((i + 0.5) / 64, (k + 0.5) / 64),
                           {single(-s), 0, single(c)}};
      const auto found = scene.FaceNear(texel);
      ASSERT_TRUE(found) << i << ' ' << k;
      EXPECT_EQ(found->number, 1);
      EXPECT_LT(found->distance, 2e-5);
      behind += scene.IsBehindFace(texel) ? 1 : 0;
    }
  }
  EXPECT_GT(behind, 1000);
  EXPECT_LT(behind, 3600);
}

/// A sheet of a few thicknesses: its upper side is face 1, its lower face 2.
Scene SheetOf(double thickness, const Point3& at, double size) {
  const auto ring = [&](double z) {
    return testing::Floor(at.x, at.x + size, at.y, at.y + size, z);
  };
  return MakeScene({{ring(at.z + thickness)}, {testing::Reversed(ring(at.z))}});
}

// The normal tells the sides of a sheet apart, however thin.
TEST(FaceFinder, TheSidesOfASheetAreToldByTheNormal) {
  for (const double thickness : {0.0, 0x1p-40, 0x1p-21, 0x1p-10}) {
    const Scene sheet = SheetOf(thickness, {0, 0, 0}, 4);
    for (const double off : {-0x1p-22, 0.0, 0x1p-22}) {
      const Receiver up{{1, 2, thickness + off}, {0, 0, 1}};
      const Receiver down{{1, 2, off}, {0, 0, -1}};
      ASSERT_TRUE(sheet.FaceNear(up) && sheet.FaceNear(down));
      EXPECT_EQ(sheet.FaceNear(up)->number, 1) << thickness << ' ' << off;
      EXPECT_EQ(sheet.FaceNear(down)->number, 2) << thickness << ' ' << off;
      EXPECT_EQ(sheet.FaceNear(up)->has_second, thickness < 0x1p-18);
    }
  }
}

// What the default limit can do far from the origin: at UTM coordinates
// (500000, 5000000) it is 1.2 m, so that a step between two floors of less than
// that is not told apart by position, only by which plane is nearer.
TEST(FaceFinder, TheLimitGrowsWithTheCoordinates) {
  const Scene flat = SheetOf(1.5, {5e5, 5e6, 0}, 10);
  const Receiver between{{500005, 5000005, 1.0}, {0, 0, 1}};
  const auto found = flat.FaceNear(between);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->number, 1);
  EXPECT_EQ(found->distance, 0.5);
  EXPECT_FALSE(flat.FaceNear(between, 0.1));
  // Millimetres: a room of 5000, receivers rounded to binary32.
  const Scene room = SheetOf(0.5, {0, 0, 0}, 5000);
  EXPECT_EQ(room.FaceNear({{4999, 4999, 0.5001}, {0, 0, 1}})->number, 1);
  EXPECT_FALSE(room.FaceNear({{4999, 4999, 0.6}, {0, 0, 1}}));
}

// At the ends of binary64's range nothing overflows into an exact number.
TEST(FaceFinder, LimitsMayBeHuge) {
  std::vector<TestFace> faces;
  for (int i = 0; i < 30; ++i)
    faces.push_back({testing::Floor(0, 1, 0, 1, i)});
  const Scene scene = MakeScene(faces);
  for (const double limit : {1e300, 1e308, 1.7976931348623157e308}) {
    for (const Point3& at :
         {Point3{0.5, 0.5, -1e-8}, Point3{0, 0, 0},
          Point3{1e308, -1e308, 1e308}, Point3{5e-324, 1.7e308, 3}}) {
      ASSERT_TRUE(scene.FaceNear({at, {0, 0, 1}}, 1.7976931348623157e308));
      (void)scene.FaceNear({at, {0, 0, 1}}, limit);
      (void)scene.FaceNear({at, {0, 0, 1}});
      (void)scene.IsBehindFace({at, {0, 0, 1}});
    }
  }
  const double huge = 1.7e308;
  const Scene large =
      MakeScene({{testing::Floor(-huge, huge, -huge, huge, 1)}});
  EXPECT_TRUE(large.FaceNear({{huge, 0, 1}, {0, 0, 1}}));
  EXPECT_TRUE(large.FaceNear({{huge, 0, -huge}, {0, 0, 1}}, 1e308) ||
              !large.FaceNear({{huge, 0, -huge}, {0, 0, 1}}, 1e300));
}

// The back of a face that emits to both sides is no face of its own.
TEST(FaceFinder, TwoSidedFacesCountOnce) {
  SceneBuilder builder("scene");
  builder.SetTwoSided(true);
  builder.AddFace(testing::Floor(0, 1, 0, 1, 0), {1, 1, 1});
  const Scene scene = *builder.Build().value;
  ASSERT_EQ(scene.facets().size(), 2U);
  for (const double z : {-1.0, 1.0}) {
    const auto found = scene.FaceNear({{0.5, 0.5, 0}, {0, 0, z}});
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->has_second);
  }
}

}  // namespace
}  // namespace truelux
