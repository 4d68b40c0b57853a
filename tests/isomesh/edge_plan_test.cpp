// SPDX-License-Identifier: GPL-3.0-or-later
// Lines and contours become edges that meet in their ends only.

#include "isomesh/edge_plan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "isomesh/plan_checks.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

std::vector<Seam> SquareWithKink() {
  std::vector<Seam> seams =
      RectangleSeams({-2, -2}, {2, 2}, SideKind::kOutline);
  seams.push_back({{-2, -2}, {2, 1.7}, SideKind::kKink, 0});
  return seams;
}

double DistanceTo(const EdgePlan& plan, const PlanEdge& edge,
                  const PlanPoint& p) {
  const PlanPoint a = plan.points[static_cast<std::size_t>(edge.from)];
  const PlanPoint way = plan.points[static_cast<std::size_t>(edge.to)] - a;
  const double along = std::clamp(Dot(p - a, way) / Dot(way, way), 0.0, 1.0);
  return truelux::LengthOf(p - a - along * way);
}

TEST(EdgePlan, AContourDividesTheSeamsThatItMeets) {
  const std::vector<Seam> seams = SquareWithKink();
  ContourLine line;
  line.level = 3;
  // From the outline over the kink to the outline, beside it by a margin.
  constexpr double kMargin = 1e-10;
  line.points.resize(3);
  line.points[0].at = {-1, 2 - kMargin};
  line.points[0].seam = 2;
  // Within rounding on the kink.
  const PlanPoint way = seams[4].to - seams[4].from;
  line.points[1].at = seams[4].from + 0.5731 * way;
  line.points[1].seam = 4;
  line.points[2].at = {2 - kMargin, -1};
  line.points[2].seam = 1;
  const EdgePlan plan =
      EdgePlanOf(seams, std::vector<ContourLine>{line}, {1e-3, 1e-5});
  // Five corners and three points; each seam with a point is two edges. A seam
  // ends in the middle of another one, as in a first mesh it does not.
  EXPECT_EQ(plan.points.size(), 8U);
  EXPECT_EQ(plan.edges.size(), 11U);
  EXPECT_EQ(plan.crossings, 0);
  EXPECT_EQ(plan.drawn, 0);
  EXPECT_EQ(CrossingsOf(plan), 0);
  std::vector<double> lengths(seams.size());
  double of_contour = 0;
  for (const PlanEdge& edge : plan.edges) {
    if (edge.seam >= 0) {
      lengths[static_cast<std::size_t>(edge.seam)] += LengthOf(plan, edge);
      EXPECT_EQ(edge.kind, seams[static_cast<std::size_t>(edge.seam)].kind);
      EXPECT_EQ(edge.level, -1);
    } else {
      EXPECT_EQ(edge.level, 3);
      EXPECT_EQ(edge.kind, SideKind::kInner);
      of_contour += LengthOf(plan, edge);
    }
  }
  for (std::size_t i = 0; i < seams.size(); ++i) {
    EXPECT_NEAR(lengths[i], truelux::LengthOf(seams[i].to - seams[i].from),
                1e-15);
  }
  const PlanPoint middle = line.points[1].at;
  EXPECT_NEAR(of_contour,
              std::hypot(middle.s + 1, middle.t - 2) +
                  std::hypot(middle.s - 2, middle.t + 1),
              1e-9);
  // Its ends are on the outline itself.
  EXPECT_TRUE(std::ranges::any_of(plan.points, [](const PlanPoint& p) {
    return p == PlanPoint{-1, 2};
  }));
}

TEST(EdgePlan, ContoursKeepTheirPlaceAndLoseVertices) {
  const std::vector<Seam> seams =
      RectangleSeams({-2, -2}, {2, 2}, SideKind::kOutline);
  const std::vector<ContourLine> lines = {ArcLine(0, {}, 1, 1000)};
  for (const double chord : {1e-2, 1e-3, 1e-4}) {
    const EdgePlan plan = EdgePlanOf(seams, lines, {chord, 1e-5});
    const std::size_t count = plan.edges.size() - 4;
    // So many sides of a regular polygon have this sagitta at radius 1.
    const double sides = std::numbers::pi / std::acos(1 - chord);
    EXPECT_LT(static_cast<double>(count), 3 * sides);
    EXPECT_GT(static_cast<double>(count), 0.7 * sides);
    for (const ContourPoint& point : lines[0].points) {
      double least = HUGE_VAL;
      for (const PlanEdge& edge : plan.edges) {
        if (edge.level == 0)
          least = std::min(least, DistanceTo(plan, edge, point.at));
      }
      EXPECT_LE(least, chord * (1 + 1e-9));
    }
  }
}

TEST(EdgePlan, ContoursNearerThanTheToleranceDoNotCross) {
  const std::vector<Seam> seams =
      RectangleSeams({-2, -2}, {2, 2}, SideKind::kOutline);
  std::vector<ContourLine> lines;
  for (std::size_t i = 0; i < 8; ++i)
    lines.push_back(ArcLine(i, {}, 1 + 1e-3 * static_cast<double>(i), 317));
  const EdgePlan plan = EdgePlanOf(seams, lines, {2e-2, 1e-5});
  EXPECT_EQ(plan.crossings, 0);
  EXPECT_EQ(CrossingsOf(plan), 0);
  std::vector<int> counts(lines.size());
  for (const PlanEdge& edge : plan.edges) {
    if (edge.level >= 0) ++counts[static_cast<std::size_t>(edge.level)];
  }
  for (const int count : counts)
    EXPECT_GE(count, 3);
  EXPECT_LT(plan.edges.size(), 8U * 317U / 2);
}

TEST(EdgePlan, ContoursThatRunIntoACornerEndInIt) {
  const std::vector<Seam> seams = SquareWithKink();
  std::vector<ContourLine> lines;
  // A fan of levels that end a little before the corner (2, 2).
  for (std::size_t i = 0; i < 5; ++i) {
    const double angle = 0.1 + 0.12 * static_cast<double>(i);
    const PlanPoint way = {-std::cos(angle), -std::sin(angle)};
    ContourLine& line = lines.emplace_back();
    line.level = i;
    for (const double length : {1.0, 0.1, 1e-3, 5e-6, 1e-6}) {
      ContourPoint& point = line.points.emplace_back();
      point.at = PlanPoint{2, 2} + length * way;
    }
  }
  const EdgePlan plan = EdgePlanOf(seams, lines, {1e-3, 1e-5});
  EXPECT_EQ(plan.drawn, 10);
  EXPECT_NEAR(plan.most_drawn, 5e-6, 1e-12);
  EXPECT_EQ(CrossingsOf(plan), 0);
  int at_corner = 0;
  for (const PlanEdge& edge : plan.edges) {
    for (const int end : {edge.from, edge.to}) {
      if (edge.level >= 0 &&
          plan.points[static_cast<std::size_t>(end)] == PlanPoint{2, 2})
        ++at_corner;
    }
  }
  EXPECT_EQ(at_corner, 5);
}

TEST(EdgePlan, ACrossingThatNobodyKnewIsCounted) {
  const std::vector<Seam> seams = SquareWithKink();
  ContourLine line;
  line.points.resize(2);
  line.points[0].at = {-1, 1};
  line.points[1].at = {1, -1};
  const EdgePlan plan =
      EdgePlanOf(seams, std::vector<ContourLine>{line}, {1e-3, 1e-5});
  EXPECT_EQ(plan.crossings, 1);
  EXPECT_EQ(CrossingsOf(plan), 0);
}

// The mesher cannot divide what is as thin as a rounding.
TEST(EdgePlan, WhatIsAlikeIsJoined) {
  std::vector<Seam> seams =
      RectangleSeams({-2, -2}, {2, 2}, SideKind::kOutline);
  seams.push_back({{-1, 0}, {1, 0}, SideKind::kJump, 0});
  // A kink beside it within rounding, longer and then shorter.
  seams.push_back({{-1.5, 0x1p-52}, {0.5, -0x1p-53}, SideKind::kKink, 1});
  std::vector<ContourLine> lines(2);
  for (std::size_t i = 0; i < 2; ++i) {
    // To the jump from both sides.
    const double side = i == 0 ? 1 : -1;
    lines[i].points.resize(2);
    lines[i].points[0].at = {0.25, side};
    lines[i].points[1].at = {0.25 + side * 0x1p-50, side * 1e-10};
    lines[i].points[1].seam = 4;
  }
  const EdgePlan plan = EdgePlanOf(seams, lines, {1e-3, 1e-5});
  // The square, -1.5, -1, 0.5 and 1 on the jump, and the contours.
  EXPECT_EQ(plan.points.size(), 4U + 4 + 3);
  EXPECT_EQ(plan.crossings, 0);
  EXPECT_EQ(CrossingsOf(plan), 0);
  double of_jump = 0;
  double of_kink = 0;
  for (const PlanEdge& edge : plan.edges) {
    if (edge.seam == 4) of_jump += LengthOf(plan, edge);
    if (edge.seam == 5) of_kink += LengthOf(plan, edge);
    EXPECT_GT(LengthOf(plan, edge), 0.1);
  }
  EXPECT_NEAR(of_jump, 2, 1e-12);
  EXPECT_NEAR(of_kink, 0.5, 1e-12);
}

}  // namespace
}  // namespace truelux
