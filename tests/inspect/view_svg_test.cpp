// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of a view: areas in it are form factors, and its curves are the
// images of arcs.

#include "inspect/view_svg.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/vector_math.h"
#include "inspect/view_json.h"
#include "inspect/view_measure.h"
#include "support/random_scene.h"
#include "support/scenes.h"
#include "support/well_formed.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

constexpr double kPi = std::numbers::pi;

/// Twice the area to the right of a path of lines and cubics, y downwards,
/// exactly but for rounding: each cubic gives a polynomial of degree 5 under
/// the integral, which three Gauss points take.
double TwiceAreaOf(const std::string& path) {
  double sum = 0;
  PicturePoint at;
  PicturePoint start;
  const char* text = path.c_str();
  const auto number = [&text] {
    char* end = nullptr;
    const double value = std::strtod(text, &end);
    text = end;
    return value;
  };
  const auto point = [&number] {
    const double x = number();
    return PicturePoint{x, number()};
  };
  while (*text != '\0') {
    const char command = *text++;
    if (command == 'M') {
      start = at = point();
    } else if (command == 'L' || command == 'Z') {
      const PicturePoint to = command == 'L' ? point() : start;
      sum += at.x * to.y - to.x * at.y;
      at = to;
    } else {
      EXPECT_EQ(command, 'C');
      const std::array p = {at, point(), point(), point()};
      const double root = std::sqrt(0.6);
      for (const auto& [t, weight] :
           {std::pair{0.5 - root / 2, 5.0 / 18}, std::pair{0.5, 8.0 / 18},
            std::pair{0.5 + root / 2, 5.0 / 18}}) {
        const double s = 1 - t;
        const std::array b = {s * s * s, 3 * s * s * t, 3 * s * t * t,
                              t * t * t};
        const std::array d = {-3 * s * s, 3 * s * s - 6 * s * t,
                              6 * s * t - 3 * t * t, 3 * t * t};
        PicturePoint q;
        PicturePoint v;
        for (std::size_t i = 0; i < 4; ++i) {
          q = {q.x + b[i] * p[i].x, q.y + b[i] * p[i].y};
          v = {v.x + d[i] * p[i].x, v.y + d[i] * p[i].y};
        }
        sum += weight * (q.x * v.y - v.x * q.y);
      }
      at = p[3];
    }
  }
  return sum;
}

/// The share of the disc that a region takes in a picture of this radius.
double DrawnShare(const InspectedView& inspected, int region) {
  constexpr double kRadius = 1000;
  const ProjectedDisc disc(ViewProjection::kNusselt, {0, 0}, kRadius);
  double sum = 0;
  for (const auto& loop : BorderOf(inspected.view, region, inspected.frame))
    sum += TwiceAreaOf(disc.LoopPath(loop));
  return sum / (2 * kPi * kRadius * kRadius);
}

InspectedView LookAt(const std::vector<TestFace>& faces,
                     const Receiver& receiver) {
  return Inspect(Oracle(MakeScene(faces)), "scene", receiver);
}

TEST(ViewSvg, DrawnAreasAreFormFactors) {
  PortableRandom random(41);
  int sources = 0;
  for (int i = 0; i < 40; ++i) {
    const bool lattice = i % 2 == 0;
    const InspectedView inspected = LookAt(RandomScene(random, lattice, 8),
                                           RandomReceiver(random, lattice));
    double all = 0;
    std::vector<double> share(inspected.scene.faces().size() + 1);
    for (std::size_t r = 0; r < inspected.view.regions.size(); ++r) {
      const ViewRegion& region = inspected.view.regions[r];
      const double own = DrawnShare(inspected, static_cast<int>(r));
      all += own;
      if (region.front) share[static_cast<std::size_t>(region.face)] += own;
    }
    // Points are rounded to a hundredth of a pixel of 1000.
    EXPECT_NEAR(all, 1, 2e-5);
    for (const SeenSource& source : inspected.sources) {
      EXPECT_NEAR(share[static_cast<std::size_t>(source.face)],
                  source.form_factor, 2e-5);
      ++sources;
    }
  }
  EXPECT_GT(sources, 40);
}

TEST(ViewSvg, RegionsTileTheGnomonicPicture) {
  constexpr double kRadius = 1000;
  const ProjectedDisc disc(ViewProjection::kGnomonic, {0, 0}, kRadius);
  PortableRandom random(44);
  for (int i = 0; i < 40; ++i) {
    const bool lattice = i % 2 == 0;
    const int faces = i < 4 ? 0 : 8;
    const InspectedView inspected = LookAt(RandomScene(random, lattice, faces),
                                           RandomReceiver(random, lattice));
    double sum = 0;
    for (std::size_t r = 0; r < inspected.view.regions.size(); ++r) {
      for (const auto& loop :
           BorderOf(inspected.view, static_cast<int>(r), inspected.frame))
        sum += TwiceAreaOf(disc.LoopPath(loop)) / 2;
    }
    // The square around the disc in which they are clipped.
    const double side = 2 * 1.02 * kRadius;
    EXPECT_NEAR(sum, side * side, 2e-4 * side * side);
  }
}

TEST(ViewSvg, SolidAnglesAreThoseOfClosedForms) {
  for (const double half : {3.0, 1.0, 1e-2, 1e-5}) {
    const InspectedView inspected =
        LookAt({{Ceiling(-half, half, -half, half, 1), kLamp}},
               {{0, 0, 0}, {1, 0, 2}, 0});
    ASSERT_EQ(inspected.sources.size(), 1U);
    if (half <= 1) {
      const double expected = 4 * std::asin(half * half / (1 + half * half));
      EXPECT_NEAR(inspected.sources[0].solid_angle, expected,
                  4e-16 * 8 * half + 4e-16 * expected);
    }
  }
}

TEST(ViewSvg, SolidAnglesOfRegionsAddUp) {
  PortableRandom random(42);
  for (int i = 0; i < 40; ++i) {
    const bool lattice = i % 2 == 0;
    const InspectedView inspected = LookAt(RandomScene(random, lattice, 8),
                                           RandomReceiver(random, lattice));
    double sum = 0;
    for (std::size_t r = 0; r < inspected.view.regions.size(); ++r) {
      const double own = SolidAngleOf(
          BorderOf(inspected.view, static_cast<int>(r), inspected.frame));
      EXPECT_GT(own, -1e-14);
      sum += own;
    }
    EXPECT_NEAR(sum, 2 * kPi, 1e-12);
  }
}

TEST(ViewSvg, ArcsAreDrawnWithinAHundredthOfAPixel) {
  constexpr double kRadius = 400;
  const ProjectedDisc disc(ViewProjection::kNusselt, {0, 0}, kRadius);
  PortableRandom random(43);
  double worst = 0;
  for (int i = 0; i < 500; ++i) {
    // A plane through the receiver and a start in it, above the horizon.
    const Vector3 n = UnitOf({random.Uniform(-1, 1), random.Uniform(-1, 1),
                              random.Uniform(-1, 1) * (i % 3 == 0 ? 1e-6 : 1)});
    const Vector3 side = UnitOf({n.y, -n.x, 0});
    const Vector3 start{side.y * n.z - side.z * n.y,
                        side.z * n.x - side.x * n.z,
                        side.x * n.y - side.y * n.x};
    const CircleArc whole{side, start, kPi};
    const double begin = random.Uniform(0, 2.5);
    const CircleArc arc{whole.At(begin), whole.At(begin + kPi / 2),
                        random.Uniform(0, 3 - begin)};
    const std::string path = disc.ArcPath(arc);
    const char* text = path.c_str() + 1;
    char* end = nullptr;
    double x = std::strtod(text, &end);
    double y = std::strtod(end, &end);
    // Every point of the curve must be on the ellipse: in the plane of the
    // arc, lifted to the sphere.
    const auto check = [&](double px, double py) {
      // The nearest of many points of the arc, refined by its neighbours.
      double nearest = 1e9;
      constexpr int kSteps = 4000;
      for (int s = 0; s < kSteps; ++s) {
        const Vector3 a = arc.At(arc.angle * s / kSteps);
        const Vector3 b = arc.At(arc.angle * (s + 1) / kSteps);
        const double ax = kRadius * a.x;
        const double ay = -kRadius * a.y;
        const double dx = kRadius * b.x - ax;
        const double dy = -kRadius * b.y - ay;
        const double length = dx * dx + dy * dy;
        const double along = std::clamp(
            length > 0 ? ((px - ax) * dx + (py - ay) * dy) / length : 0.0, 0.0,
            1.0);
        nearest = std::min(
            nearest, std::hypot(px - ax - along * dx, py - ay - along * dy));
      }
      worst = std::max(worst, nearest);
    };
    check(x, y);
    while (*end != '\0') {
      const char command = *end++;
      std::array<double, 6> c{};
      const std::size_t count = command == 'C' ? 6 : 2;
      for (std::size_t k = 0; k < count; ++k)
        c[k] = std::strtod(end, &end);
      for (const double t : {0.25, 0.5, 0.8}) {
        const double s = 1 - t;
        if (command == 'C') {
          check(s * s * s * x + 3 * s * s * t * c[0] + 3 * s * t * t * c[2] +
                    t * t * t * c[4],
                s * s * s * y + 3 * s * s * t * c[1] + 3 * s * t * t * c[3] +
                    t * t * t * c[5]);
        } else {
          check(s * x + t * c[0], s * y + t * c[1]);
        }
      }
      x = c[count - 2];
      y = c[count - 1];
    }
  }
  EXPECT_LT(worst, 0.0125);  // 0.007 of it are the two digits
  EXPECT_GT(worst, 0.004);
}

TEST(ViewSvg, IsWellFormedWithEveryKindOfMark) {
  // A sliver of everything: a wall that sets, faces that pass through each
  // other, an edge through a corner.
  const InspectedView inspected =
      LookAt({{Ceiling(-4, 4, -4, 4, 8), kLamp},
              {{{-1, -1, 4}, {4, 4, 4}, {4, -4, 4}}},
              {{{3, -4, -1}, {3, -4, 6}, {3, 4, 6}, {3, 4, -1}}},
              {{{-2, -2, 3}, {2, -2, 5}, {2, 2, 5}, {-2, 2, 3}}, {0, 0, 1}}},
             {{0, 0, 0}, {0, 0, 1}, 0});
  for (const ViewProjection projection :
       {ViewProjection::kNusselt, ViewProjection::kGnomonic}) {
    const std::string svg = ViewSvg(inspected, {projection, 900});
    EXPECT_EQ(MarkupDefect(svg), "");
    // Legends use the marks in full size, the view its own.
    EXPECT_GE(CountOf(svg, "href=\"#m3\""), 2U);
    EXPECT_EQ(CountOf(svg, "href=\"#m0\""), 1U);
    EXPECT_GE(CountOf(svg, "href=\"#s0\""), 3U);
    EXPECT_GE(CountOf(svg, "href=\"#s1\""), 4U);
    EXPECT_NE(svg.find("class=\"meeting\""), svg.npos);
    EXPECT_NE(svg.find("back of emitting face 4"), svg.npos);
    const bool cut = projection == ViewProjection::kGnomonic;
    EXPECT_EQ(CountOf(svg, "80°"), cut ? 1U : 0U);
    EXPECT_EQ(CountOf(svg, "class=\"horizon\""), cut ? 0U : 1U);
  }
}

TEST(ViewSvg, EscapesNames) {
  InspectedView inspected =
      LookAt({{Ceiling(-1, 1, -1, 1, 1), kLamp}}, {{0, 0, 0}, {0, 0, 1}, 0});
  inspected.scene_name = "a<b>&\"c\".obj\xFF";
  EXPECT_EQ(MarkupDefect(ViewSvg(inspected, {})), "");
  EXPECT_NE(ViewJson(inspected).find("a<b>&\\\"c\\\".obj"), std::string::npos);
}

}  // namespace
}  // namespace truelux
