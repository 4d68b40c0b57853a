// SPDX-License-Identifier: GPL-3.0-or-later
// Jumps are the feet of what stands on a surface, cut to the surface exactly.

#include "surface/surface_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/scenes.h"
#include "surface/surface_clip.h"
#include "surface/surface_frame.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

/// The jumps on the first face, as (x, y) of both ends.
std::vector<std::array<double, 4>> JumpsOf(const std::vector<TestFace>& faces,
                                           bool is_reverse = false) {
  const Scene scene = MakeScene(faces);
  const std::array<int, 1> first = {0};
  std::string defect;
  SurfaceFrame frame = SurfaceFrameOf(scene, first, defect).value();
  std::vector<std::array<double, 4>> jumps;
  for (const ExactSurfaceLine& line :
       JumpLinesOf(scene, frame, first, is_reverse, nullptr)) {
    EXPECT_TRUE(line.is_jump);
    EXPECT_EQ(line.from.z, 0);
    EXPECT_EQ(line.to.z, 0);
    EXPECT_FALSE(line.faces.empty());
    jumps.push_back({line.from.x.get_d(), line.from.y.get_d(),
                     line.to.x.get_d(), line.to.y.get_d()});
  }
  return jumps;
}

const TestFace kGround = {Floor(-2, 2, -2, 2, 0)};

TEST(SurfaceLines, AWallThatStandsThere) {
  const Ring wall = {{-1, 0, 0}, {1, 0, 0}, {1, 0, 1}, {-1, 0, 1}};
  EXPECT_EQ(JumpsOf({kGround, {wall}}),
            (std::vector<std::array<double, 4>>{{-1, 0, 1, 0}}));
  // It is above only one side.
  EXPECT_TRUE(JumpsOf({kGround, {wall}}, true).empty());
}

TEST(SurfaceLines, AWallThatGoesThroughAndBeyond) {
  const Ring wall = {{1, 0, -1}, {5, 0, -1}, {5, 0, 1}, {1, 0, 1}};
  std::vector<std::array<double, 4>> found = JumpsOf({kGround, {wall}});
  // A wall of two triangles has a foot for each; together from 1 to the edge.
  double least = 9;
  double most = -9;
  for (const auto& jump : found) {
    least = std::min({least, jump[0], jump[2]});
    most = std::max({most, jump[0], jump[2]});
  }
  EXPECT_EQ(least, 1);
  EXPECT_EQ(most, 2);
  EXPECT_EQ(JumpsOf({kGround, {wall}}, true).size(), found.size());
}

TEST(SurfaceLines, WhatTouchesInPointsOrFromBelowMakesNone) {
  EXPECT_TRUE(JumpsOf({kGround, {{{0, 0, 0}, {1, 0, 1}, {0, 1, 1}}}}).empty());
  EXPECT_TRUE(
      JumpsOf({kGround, {{{-1, 0, 0}, {1, 0, 0}, {0, 0, -1}}}}).empty());
  EXPECT_TRUE(JumpsOf({kGround, {Floor(-1, 1, -1, 1, 0)}}).empty());
  EXPECT_TRUE(JumpsOf({kGround, {Floor(-1, 1, -1, 1, 1)}}).empty());
}

TEST(SurfaceLines, TwoSheetsOfAWallAreOneLine) {
  const Ring wall = {{-1, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  const Ring other = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 1}};
  EXPECT_EQ(JumpsOf({kGround, {wall}, {other}}).size(), 1U);
}

TEST(SurfaceClip, CutsSegmentsToFaces) {
  const Ring ring = {{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1, 1, 0},
                     {1, 3, 0}, {4, 3, 0}, {4, 4, 0}, {0, 4, 0}};
  const Scene scene = MakeScene({{ring}});
  const std::array<int, 1> faces = {0};
  std::string defect;
  const SurfaceFrame frame = SurfaceFrameOf(scene, faces, defect).value();
  const SurfaceClip clip(scene, frame, faces);
  // Across both legs of a C.
  const auto parts = clip.PartsOf({{2, -1, 0}, {2, 5, 0}});
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].from.y, 0);
  EXPECT_EQ(parts[0].to.y, 1);
  EXPECT_EQ(parts[1].from.y, 3);
  EXPECT_EQ(parts[1].to.y, 4);
  EXPECT_TRUE(clip.PartsOf({{2, 1.5, 0}, {2, 2.5, 0}}).empty());
  // The trace of a plane, in the extent.
  const auto trace = clip.TraceOf({1, 0, 7}, 2);
  ASSERT_EQ(trace.size(), 1U);
  EXPECT_EQ(trace[0].from.x, 2);
  EXPECT_EQ(trace[0].to.x, 2);
  EXPECT_TRUE(clip.TraceOf({0, 0, 1}, 0).empty());
  EXPECT_TRUE(clip.TraceOf({1, 0, 0}, 9).empty());
}

}  // namespace
}  // namespace truelux
