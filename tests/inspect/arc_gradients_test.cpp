// SPDX-License-Identifier: GPL-3.0-or-later
// What arcs of a view carry of the gradient: against the certified gradient,
// against the derivatives by the vertices of their edges, and where nothing can
// be shared.

#include "inspect/arc_gradients.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "inspect/inspected_view.h"
#include "inspect/view_light.h"
#include "inspect/view_svg.h"
#include "inspect/view_titles.h"
#include "support/random_scene.h"
#include "support/scenes.h"
#include "support/well_formed.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

InspectedView LookAt(const std::vector<TestFace>& faces,
                     const Receiver& receiver,
                     Emission emission = Emission::kExitance) {
  return Inspect(Oracle(MakeScene(faces), {.emission = emission}), "scene",
                 receiver);
}

/// a + s b.
Vector3 PlusTimes(const Vector3& a, double s, const Vector3& b) {
  return {a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

double LengthOf(const Vector3& a) {
  return std::hypot(a.x, a.y, a.z);
}

TEST(ArcGradients, AddUpToTheCertifiedGradient) {
  PortableRandom random(51);
  std::map<GradientShares, int> count;
  int meetings = 0;
  for (int i = 0; i < 120; ++i) {
    const bool lattice = i % 2 == 0;
    const InspectedView inspected =
        LookAt(RandomScene(random, lattice, 8), RandomReceiver(random, lattice),
               i % 3 == 0 ? Emission::kRadiance : Emission::kExitance);
    const ArcGradients& gradients = inspected.arc_gradients;
    ++count[gradients.shares[0]];
    const bool is_c1 = inspected.derivatives.smoothness == Smoothness::kC1;
    ASSERT_EQ(gradients.arcs.size(), is_c1 ? inspected.view.arcs.size() : 0U);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      Vector3 sum{0, 0, 0};
      double lengths = 0;
      double shares = 0;
      for (std::size_t a = 0; a < gradients.arcs.size(); ++a) {
        sum = PlusTimes(sum, 1, gradients.arcs[a].vector[channel]);
        lengths += gradients.LengthOf(a, channel);
        shares += gradients.arcs[a].share[channel];
        if (inspected.view.arcs[a].kind == ViewArcKind::kMeeting &&
            gradients.LengthOf(a, channel) > 0)
          ++meetings;
      }
      if (!is_c1) continue;
      EXPECT_LE(LengthOf(PlusTimes(
                    sum, -1, inspected.derivatives.channels[channel].gradient)),
                1e-11 * lengths)
          << "scene " << i;
      if (gradients.shares[channel] == GradientShares::kGiven) {
        EXPECT_NEAR(shares, 1, kShareError);
      }
    }
  }
  EXPECT_GT(count[GradientShares::kGiven], 60);
  EXPECT_GT(count[GradientShares::kNoGradient], 3);
  EXPECT_GT(count[GradientShares::kKink], 0);
  EXPECT_EQ(count[GradientShares::kDoNotAddUp], 0);
  EXPECT_GT(meetings, 10);
}

/// When all vertices of a face move, its edges move, and nothing else.
TEST(ArcGradients, AreMinusTheDerivativesByTheVerticesOfTheirEdges) {
  PortableRandom random(52);
  int compared = 0;
  for (int i = 0; i < 80; ++i) {
    const std::vector<TestFace> faces = RandomScene(random, false, 6);
    const Receiver receiver = RandomReceiver(random, false);
    const Oracle oracle(MakeScene(faces));
    const InspectedView inspected = Inspect(oracle, "scene", receiver);
    if (inspected.arc_gradients.arcs.empty()) continue;
    // A line where two faces meet moves with both.
    std::set<int> meet;
    for (const WholeViewArc& arc : inspected.view.arcs) {
      if (arc.kind == ViewArcKind::kMeeting)
        meet.insert({arc.edge.face, arc.edge.other_face});
    }
    std::map<int, Vector3> by_face;
    std::map<int, double> scale;
    for (std::size_t a = 0; a < inspected.view.arcs.size(); ++a) {
      const int face = inspected.view.arcs[a].edge.face;
      Vector3& sum = by_face.try_emplace(face, Vector3{0, 0, 0}).first->second;
      sum = PlusTimes(sum, 1, inspected.arc_gradients.arcs[a].vector[0]);
      scale[face] += inspected.arc_gradients.LengthOf(a, 0);
    }
    std::map<int, Vector3> by_vertices;
    const std::span<const int> numbers = oracle.scene().corner_numbers();
    for (const VertexDerivative& v :
         oracle.VertexDerivatives(receiver).vertices) {
      const auto corner = std::ranges::find(numbers, v.number);
      // Triangles without common vertices: three corners a face.
      const int face = static_cast<int>(corner - numbers.begin()) / 3 + 1;
      Vector3& sum =
          by_vertices.try_emplace(face, Vector3{0, 0, 0}).first->second;
      const auto& s = v.slopes[0];
      sum = PlusTimes(sum, 1, {s[0].left, s[1].left, s[2].left});
    }
    for (const auto& [face, sum] : by_face) {
      if (scale[face] == 0 || meet.contains(face)) continue;
      EXPECT_LE(LengthOf(PlusTimes(sum, 1, by_vertices[face])),
                1e-11 * scale[face])
          << "scene " << i << ", face " << face;
      ++compared;
    }
  }
  EXPECT_GT(compared, 40);
}

TEST(ArcGradients, SquareLampAbove) {
  const InspectedView inspected =
      LookAt({{Ceiling(-1, 1, -1, 1, 1), kLamp}}, {{0, 0, 0}, {0, 0, 2}, 0});
  int sides = 0;
  for (std::size_t a = 0; a < inspected.view.arcs.size(); ++a) {
    const ArcGradient& arc = inspected.arc_gradients.arcs[a];
    const std::string title = TitleOfArc(inspected, a);
    if (inspected.view.arcs[a].kind == ViewArcKind::kHorizon) {
      EXPECT_EQ(arc.vector[0].z, 0);
      EXPECT_NE(title.find("carries no gradient"), title.npos);
      continue;
    }
    ++sides;
    // By symmetry; each is along the normal of its plane, 45 degrees up.
    EXPECT_NEAR(arc.share[1], 0.25, 1e-15);
    EXPECT_NEAR(inspected.arc_gradients.LengthOf(a, 1),
                std::sqrt(2) / 4 * inspected.derivatives.channels[1].gradient.z,
                1e-15);
    EXPECT_NE(title.find("25 % of dE/dr: r "), title.npos) << title;
  }
  EXPECT_EQ(sides, 4);
  const std::string svg = ViewSvg(inspected, {});
  EXPECT_EQ(MarkupDefect(svg), "");
  EXPECT_EQ(CountOf(svg, "stroke-width=\"4.00\" d="), 4U);
  // V is vertical, in all channels: one dot in the middle.
  EXPECT_EQ(CountOf(svg, "id=\"vector-irradiance\""), 1U);
  EXPECT_EQ(CountOf(svg, "r=\"4.5\""), 1U);
}

TEST(ArcGradients, ColouredLampsHaveSharesAndArrowsOfTheirOwn) {
  const InspectedView inspected =
      LookAt({{Ceiling(-3, -2, -1, 1, 1), {1, 0, 0}},
              {Ceiling(2, 4, -1, 1, 1), {0, 0, 2}}},
             {{0, 0, 0}, {0, 0, 1}, 0});
  for (std::size_t a = 0; a < inspected.view.arcs.size(); ++a) {
    const WholeViewArc& arc = inspected.view.arcs[a];
    if (arc.edge.face == 0) continue;
    const std::size_t dark = arc.edge.face == 1 ? 2 : 0;
    EXPECT_EQ(inspected.arc_gradients.arcs[a].share[dark], 0);
    EXPECT_NE(inspected.arc_gradients.arcs[a].share[2 - dark], 0);
  }
  EXPECT_EQ(inspected.arc_gradients.shares[1], GradientShares::kNoGradient);
  const std::string svg = ViewSvg(inspected, {});
  EXPECT_EQ(CountOf(svg, "fill=\"#b00020\""), 1U);
  EXPECT_EQ(CountOf(svg, "fill=\"#00701a\""), 0U);
  EXPECT_EQ(CountOf(svg, "fill=\"#0040c0\""), 1U);
}

TEST(ArcGradients, SayWhyThereIsNoShare) {
  const auto expect = [](const InspectedView& inspected, GradientShares shares,
                         const char* words) {
    EXPECT_EQ(inspected.arc_gradients.shares[0], shares);
    const std::string svg = ViewSvg(inspected, {});
    EXPECT_NE(svg.find(words), svg.npos);
    EXPECT_EQ(MarkupDefect(svg), "");
    EXPECT_EQ(svg.find("id=\"gradient\""), svg.npos);
  };
  // A wall edge-on before the lamp.
  const TestFace lamp = {Ceiling(-1, 1, -1, 1, 2), kLamp};
  expect(LookAt({lamp, {{{0, -2, 1}, {0, 2, 1}, {0, 2, 1.5}, {0, -2, 1.5}}}},
                {{0, 0, 0}, {0, 0, 1}, 0}),
         GradientShares::kKink, "E has a kink here");
  // On a face that faces elsewhere.
  expect(LookAt({lamp, {{{0, -2, -1}, {0, 2, -1}, {0, 2, 1}, {0, -2, 1}}}},
                {{0, 0, 0}, {0, 0, 1}, 0}),
         GradientShares::kDiscontinuous, "E is discontinuous here");
  // No scene of a few faces has arcs that cancel exactly.
  InspectedView inspected = LookAt({lamp}, {{0, 0, 0}, {0, 0, 1}, 0});
  inspected.arc_gradients.shares.fill(GradientShares::kNoGradient);
  expect(inspected, GradientShares::kNoGradient, "the arcs cancel");
  inspected.arc_gradients.shares.fill(GradientShares::kDoNotAddUp);
  expect(inspected, GradientShares::kDoNotAddUp, "do not add up");
}

}  // namespace
}  // namespace truelux
