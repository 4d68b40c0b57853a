// SPDX-License-Identifier: GPL-3.0-or-later
#include "baselines/regime_shadows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "baselines/regimes.h"
#include "baselines/seen_from.h"
#include "support/scenes.h"

namespace truelux::testing {
namespace {

constexpr std::uint64_t kCases = 40;
constexpr std::array<int, 7> kToRounding = {2, 4, 6, 8, 10, 12, 14};

using Corners = std::array<RealVec, 3>;

/// The corners of face `number` in the order in which it was built.
Corners CornersOf(const RegimeCase& made, int number) {
  const Scene& scene = made.scene;
  const Face& face = scene.faces()[static_cast<std::size_t>(number - 1)];
  const Facet& facet =
      scene.facets()[static_cast<std::size_t>(face.first_facet)];
  const Triangle& triangle =
      scene.triangles()[static_cast<std::size_t>(facet.first_triangle)];
  Corners corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto vertex = static_cast<std::size_t>(triangle.vertices[k]);
    corners[k] = SeenFrom(made.receiver, scene.vertices()[vertex]);
  }
  return corners;
}

RealVec FirstEdgeOf(const RegimeCase& made, int number) {
  const Corners corners = CornersOf(made, number);
  return Cross(corners[0], corners[1]);
}

double Visible(const RegimeCase& made) {
  return Evaluate(made.scene, made.receiver)[0];
}

double Unhidden(const RegimeCase& made) {
  const Corners corners = CornersOf(made, 1);
  return SignedFormFactor({corners.begin(), corners.end()},
                          made.receiver.normal)
      .ToDouble();
}

/// The cases of a family at a size.
std::vector<RegimeCase> CasesOf(RegimeCase (*family)(CaseRandom&, double),
                                double size) {
  std::vector<RegimeCase> cases;
  for (std::uint64_t i = 0; i < kCases; ++i) {
    CaseRandom random(1, i);
    cases.push_back(family(random, size));
  }
  return cases;
}

/// The angle is what was asked for, but for the shrinking from the chart to
/// the sphere and the rounding of the corners.
void ExpectAngle(double angle, double asked) {
  EXPECT_GT(std::abs(angle), 0.5 * asked - 1e-15);
  EXPECT_LT(std::abs(angle), 1.2 * asked + 1e-15);
}

TEST(RegimeShadows, OneSourceBehindTrianglesThatHideSomeOfIt) {
  for (const Regime& regime : Regimes()) {
    if (!regime.occluded) continue;
    for (std::uint64_t i = 0; i < kCases; ++i) {
      SCOPED_TRACE(regime.name + ", case " + std::to_string(i));
      const RegimeCase made = regime.Make(1, i);
      EXPECT_TRUE(made.loop.empty());
      EXPECT_EQ(made.receiver.position, Point3{});
      const auto faces = made.scene.faces();
      ASSERT_GE(faces.size(), 2U);
      ASSERT_EQ(made.scene.facets().size(), faces.size());
      ASSERT_EQ(made.scene.triangles().size(), faces.size());
      EXPECT_EQ(faces[0].emission, (Rgb{1, 1, 1}));
      for (const Face& face : faces.subspan(1))
        EXPECT_EQ(face.emission, kBlack);
      const double visible = Visible(made);
      EXPECT_GT(visible, 0);
      EXPECT_LT(visible, Unhidden(made));
    }
  }
}

TEST(RegimeShadows, ThreeEdgesMissACommonPoint) {
  for (const int k : kToRounding) {
    const double miss = std::pow(10, -k);
    for (const RegimeCase& made : CasesOf(NearConjunction, miss)) {
      const RealVec a = FirstEdgeOf(made, 2);
      const RealVec b = FirstEdgeOf(made, 3);
      const RealVec c = FirstEdgeOf(made, 4);
      ExpectAngle(AngleToPlane(Cross(a, b), c), miss);
      // Well-conditioned crossings: the edges meet at 0.5 rad and more.
      for (const double angle :
           {AngleBetween(a, b), AngleBetween(b, c), AngleBetween(c, a)})
        EXPECT_GT(std::sin(angle), 0.4);
      // The point is inside the source.
      const Corners source = CornersOf(made, 1);
      RealVec p = Cross(a, b);
      if (p.z < ShortReal(0)) p = -p;
      for (std::size_t i = 0; i < 3; ++i) {
        const RealVec side = Cross(source[i], source[(i + 1) % 3]);
        EXPECT_LT(AngleToPlane(p, side), -0.02);
      }
    }
  }
}

TEST(RegimeShadows, AVertexMissesAnEdge) {
  for (const int k : kToRounding) {
    const double miss = std::pow(10, -k);
    int of_source = 0;
    for (const RegimeCase& made : CasesOf(VertexNearEdge, miss)) {
      const RealVec vertex = CornersOf(made, 2)[0];
      const double to_source =
          std::abs(AngleToPlane(vertex, FirstEdgeOf(made, 1)));
      const double to_blocker =
          std::abs(AngleToPlane(vertex, FirstEdgeOf(made, 3)));
      // The other edge may be close, too, but by chance.
      const bool is_source =
          std::abs(to_source - miss) < std::abs(to_blocker - miss);
      ExpectAngle(is_source ? to_source : to_blocker, miss);
      if (is_source) ++of_source;
    }
    EXPECT_GT(of_source, static_cast<int>(kCases) / 5);
    EXPECT_LT(of_source, static_cast<int>(kCases) * 4 / 5);
  }
}

TEST(RegimeShadows, TwoEdgesAreNearlyEqual) {
  for (const int k : kToRounding) {
    const double miss = std::pow(10, -k);
    for (const RegimeCase& made : CasesOf(NearlyEqualEdges, miss)) {
      const RealVec source = FirstEdgeOf(made, 1);
      const Corners blocker = CornersOf(made, 2);
      ExpectAngle(AngleToPlane(blocker[0], source), miss);
      ExpectAngle(AngleToPlane(blocker[1], source), miss);
      EXPECT_GT(Visible(made), 0.2 * Unhidden(made));
    }
  }
}

TEST(RegimeShadows, OnlyAStripIsVisible) {
  for (const int k : kToRounding) {
    const double width = std::pow(10, -k);
    for (const RegimeCase& made : CasesOf(Slit, width)) {
      // Its length is at most 0.87 + rounding, and its width on the sphere up
      // to a third smaller.
      const double visible = Visible(made);
      EXPECT_GT(visible, 0.02 * width);
      EXPECT_LT(visible, 0.35 * width);
    }
  }
}

TEST(RegimeShadows, ThinBlockersHideLittle) {
  for (const int k : {3, 6, 9}) {
    const double width = std::pow(10, -k);
    for (const RegimeCase& made : CasesOf(ThinBlockers, width)) {
      const double hidden = Unhidden(made) - Visible(made);
      EXPECT_GT(hidden, 0.02 * width);
      EXPECT_LT(hidden, width);
    }
  }
}

TEST(RegimeShadows, OnlyATinyHoleIsVisible) {
  for (const int k : {3, 6}) {
    const double size = std::pow(10, -k);
    for (const RegimeCase& made : CasesOf(Pinhole, size)) {
      const double visible = Visible(made) / (size * size);
      EXPECT_GT(visible, 0.05);
      EXPECT_LT(visible, 1);
    }
  }
}

}  // namespace
}  // namespace truelux::testing
