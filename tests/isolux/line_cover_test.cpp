// SPDX-License-Identifier: GPL-3.0-or-later
// Facets that meet along a part of an edge are seen to meet there.

#include "isolux/line_cover.h"

#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "isolux/lit_floor.h"
#include "isolux/sight.h"
#include "support/scenes.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

TEST(LineCover, CutsEdgesWhereOthersEnd) {
  // Points 0 .. 3 on a line, as vertices of triangles.
  const Scene scene = MakeScene({{{{0, 0, 0}, {1, 1, 1}, {9, 5, 0}}, {}},
                                 {{{2, 2, 2}, {3, 3, 3}, {9, 5, 0}}, {}}});
  const auto vertex = [&scene](double x) {
    for (std::size_t i = 0; i < scene.vertices().size(); ++i) {
      if (scene.vertices()[i] == Point3{x, x, x}) return static_cast<int>(i);
    }
    return -1;
  };
  LineCover cover(scene);
  const std::array<FacetSide, 1> one = {{{1, true}}};
  const std::array<FacetSide, 1> other = {{{2, false}}};
  // From 0 to 3, and from 2 to 1.
  cover.Add({vertex(0), vertex(3)}, one);
  cover.Add({vertex(2), vertex(1)}, other);
  const std::vector<LinePiece> pieces = cover.Pieces();
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_EQ(pieces[0].ends, (std::array<int, 2>{vertex(0), vertex(1)}));
  EXPECT_EQ(pieces[0].facets.size(), 1U);
  EXPECT_EQ(pieces[1].ends, (std::array<int, 2>{vertex(1), vertex(2)}));
  ASSERT_EQ(pieces[1].facets.size(), 2U);
  EXPECT_TRUE(pieces[1].facets[0].is_forward);
  EXPECT_TRUE(pieces[1].facets[1].is_forward);
  EXPECT_EQ(pieces[2].facets.size(), 1U);
}

TEST(LineCover, SeamsOfAPlateBoundNoShadow) {
  // A plate of three parts with T-junctions: inside, nothing is seen to end.
  const LitFloor floor(4, {{Ceiling(-1, 1, -1, 1, 4), kUnitLamp},
                           {Ceiling(-2, 2, 0, 2, 2), {}},
                           {Ceiling(-2, 0, -2, 0, 2), {}},
                           {Ceiling(0, 2, -2, 0, 2), {}}});
  const std::array<PlanPoint, 3> under = {
      {{-0.05, -0.05}, {0.05, -0.05}, {0, 0.05}}};
  const Sight sight =
      Narrowed(floor.features(), WholeSight(floor.features()), under);
  for (const LampSight& lamp : sight)
    EXPECT_TRUE(lamp.edges.empty());
  // At its border something ends.
  const std::array<PlanPoint, 3> beside = {{{2.9, 0}, {3, 0}, {3, 0.1}}};
  const Sight seen =
      Narrowed(floor.features(), WholeSight(floor.features()), beside);
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_GT(seen[0].edges.size(), seen[0].lamp_edges);
}

}  // namespace
}  // namespace truelux
