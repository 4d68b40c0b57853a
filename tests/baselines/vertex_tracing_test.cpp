// SPDX-License-Identifier: GPL-3.0-or-later
#include "baselines/vertex_tracing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scenes.h"

namespace truelux {
namespace {

using testing::Ceiling;
using testing::kBlack;
using testing::kLamp;
using testing::MakeScene;
using testing::PortableRandom;
using testing::Ring;
using testing::TestFace;

const Receiver kUp{{0, 0, 0}, {0, 0, 1}, 0};
constexpr VertexTracingOptions kRays{};
constexpr VertexTracingOptions kCones{Tracing::kCones, 1e-7};

/// The largest error of a channel, relative to the certified value.
double RelativeError(const Scene& scene, const Receiver& receiver,
                     const VertexTracingOptions& options) {
  const Rgb truth = testing::Evaluate(scene, receiver);
  const Rgb value = VertexTracing(scene, options).Evaluate(receiver);
  double error = 0;
  for (std::size_t c = 0; c < truth.size(); ++c) {
    EXPECT_GT(truth[c], 0);
    error = std::max(error, std::abs(value[c] / truth[c] - 1));
  }
  return error;
}

void ExpectBothRight(const std::vector<TestFace>& faces,
                     const Receiver& receiver, double tolerance = 1e-12) {
  const Scene scene = MakeScene(faces);
  EXPECT_LT(RelativeError(scene, receiver, kRays), tolerance);
  EXPECT_LT(RelativeError(scene, receiver, kCones), tolerance);
}

TestFace Lamp() {
  return {Ceiling(-0.5, 0.5, -0.5, 0.5, 1), kLamp};
}

TestFace RandomTriangle(PortableRandom& random, const Rgb& emission) {
  const Point3 c{random.Uniform(-0.6, 0.6), random.Uniform(-0.6, 0.6),
                 random.Uniform(0.2, 0.8)};
  Ring ring;
  for (int k = 0; k < 3; ++k) {
    ring.push_back({c.x + random.Uniform(-0.3, 0.3),
                    c.y + random.Uniform(-0.3, 0.3),
                    c.z + random.Uniform(-0.01, 0.01)});
  }
  return {ring, emission};
}

/// Apart in depth, so that none passes through another.
std::vector<TestFace> Stack(PortableRandom& random, int count, bool emitting) {
  std::vector<TestFace> faces = {Lamp()};
  for (int i = 0; i < count; ++i) {
    const double m = emitting && i % 2 == 0 ? random.Uniform(0.5, 2) : 0;
    TestFace face = RandomTriangle(random, {m, 2 * m, m});
    const double lift = 0.2 + 0.7 * i / count - face.ring[0].z;
    for (Point3& p : face.ring)
      p.z += lift;
    faces.push_back(face);
  }
  return faces;
}

TEST(VertexTracing, UnoccludedSquare) {
  ExpectBothRight({Lamp()}, kUp);
  ExpectBothRight({{Ceiling(-1, 0.5, -0.25, 2, 1.5), kLamp}},
                  {{0.1, 0.2, 0.3}, {0.3, -0.2, 1}, 0});
}

TEST(VertexTracing, OneBlocker) {
  const TestFace inside{
      {{-0.1, -0.12, 0.5}, {0.13, -0.1, 0.5}, {0, 0.14, 0.4}}};
  ExpectBothRight({Lamp(), inside}, kUp);
  const TestFace across{
      {{0.1, 0.02, 0.5}, {0.53, -0.1, 0.6}, {0.2, 0.34, 0.4}}};
  ExpectBothRight({Lamp(), across}, kUp);
  // From behind it hides as much.
  ExpectBothRight({Lamp(), {testing::Reversed(across.ring)}}, kUp);
}

TEST(VertexTracing, WhatLiesBehindTheSourceOrAsideHidesNothing) {
  const TestFace behind{{{-0.3, -0.3, 2}, {1, 0, 3}, {0.2, 0.7, 2.5}}};
  const TestFace aside{{{2, 2, 0.5}, {3, 2, 0.7}, {2, 3, 0.6}}};
  ExpectBothRight({Lamp(), behind, aside}, kUp);
}

TEST(VertexTracing, NothingFromBehindBelowOrWithoutEmission) {
  for (const VertexTracingOptions& options : {kRays, kCones}) {
    const Scene below = MakeScene({{Ceiling(-1, 1, -1, 1, -1), kLamp}});
    EXPECT_EQ(VertexTracing(below, options).Evaluate(kUp), kBlack);
    const Scene behind = MakeScene({{testing::Floor(-1, 1, -1, 1, 1), kLamp}});
    EXPECT_EQ(VertexTracing(behind, options).Evaluate(kUp), kBlack);
    const Scene dark = MakeScene({{Ceiling(-1, 1, -1, 1, 1), kBlack}});
    EXPECT_EQ(VertexTracing(dark, options).Evaluate(kUp), kBlack);
    const Scene hidden = MakeScene({Lamp(), {Ceiling(-1, 1, -1, 1, 0.5)}});
    EXPECT_EQ(VertexTracing(hidden, options).Evaluate(kUp), kBlack);
  }
}

TEST(VertexTracing, TwoEmittersOneInFrontOfTheOther) {
  const Rgb dim{0.25, 1, 4};
  const TestFace front{{{-0.2, -0.1, 0.5}, {0, 0.2, 0.5}, {0.3, -0.1, 0.6}},
                       dim};
  ExpectBothRight({Lamp(), front}, kUp);
  ExpectBothRight({Lamp(), {testing::Reversed(front.ring), dim}}, kUp);
}

TEST(VertexTracing, BackgroundWithoutEmission) {
  // The blocker reaches over the lamp's edge into nothing.
  const TestFace over{{{0.1, 0.1, 0.5}, {0.9, 0.2, 0.5}, {0.2, 0.8, 0.6}}};
  ExpectBothRight({Lamp(), over}, kUp);
}

TEST(VertexTracing, HorizonCutsTheSource) {
  const TestFace wall{{{1, 1, -1}, {1, -1, -1}, {1, -1, 2}, {1, 1, 2}}, kLamp};
  const TestFace blocker{{{0.5, 0.3, -0.3}, {0.6, -0.7, 0.4}, {0.5, 0.4, 0.6}}};
  const Receiver tilted{{0, 0, 0}, {0.2, 0.7, 0.3}, 0};
  // Some of the rest is cut off, and next to the square rounding is large.
  ExpectBothRight({wall}, kUp, 1e-9);
  ExpectBothRight({wall, blocker}, kUp, 1e-9);
  ExpectBothRight({wall}, tilted, 1e-9);
  ExpectBothRight({wall, blocker}, tilted, 1e-9);
  ExpectBothRight({Lamp(), blocker}, {{0, 0, 0}, {1, 0.2, 0.1}, 0}, 1e-9);
}

TEST(VertexTracing, WallsThatMeetAtTheHorizon) {
  // All three are cut by the square, two along one side of it.
  const TestFace left{{{1, 0, -1}, {1, -2, -1}, {1, -2, 2}, {1, 0, 2}}, kLamp};
  const TestFace right{{{1, 2, -1}, {1, 0, -1}, {1, 0, 2}, {1, 2, 2}},
                       {4, 1, 2}};
  const TestFace front{
      {{0.7, 0.5, -1}, {0.7, 0.5, 0.6}, {0.7, -0.6, 0.5}, {0.7, -0.6, -1}}};
  ExpectBothRight({left, right, front}, kUp, 1e-9);
}

TEST(VertexTracing, SlabsOfTrianglesInGeneralPosition) {
  PortableRandom random(1);
  int shaded = 0;
  for (int i = 0; i < 60; ++i) {
    const std::vector<TestFace> faces = Stack(random, 1 + i / 2, false);
    const Scene scene = MakeScene(faces);
    const Receiver r{{random.Uniform(-0.5, 0.5), random.Uniform(-0.5, 0.5), 0},
                     {random.Uniform(-0.3, 0.3), random.Uniform(-0.3, 0.3), 1},
                     0};
    const double truth = testing::Evaluate(scene, r)[0];
    if (truth < 1e-3) continue;
    if (truth < 0.9 * testing::Evaluate(MakeScene({Lamp()}), r)[0]) ++shaded;
    EXPECT_LT(RelativeError(scene, r, kRays), 1e-9) << "scene " << i;
    EXPECT_LT(RelativeError(scene, r, {Tracing::kCones, 1e-10}), 1e-9)
        << "scene " << i;
  }
  EXPECT_GT(shaded, 30);
}

TEST(VertexTracing, EmittersInGeneralPosition) {
  PortableRandom random(2);
  for (int i = 0; i < 30; ++i) {
    const Scene scene = MakeScene(Stack(random, 12, true));
    const Receiver r{{random.Uniform(-0.5, 0.5), random.Uniform(-0.5, 0.5), 0},
                     {random.Uniform(-1, 1), random.Uniform(-1, 1), 1},
                     0};
    EXPECT_LT(RelativeError(scene, r, kRays), 1e-9) << "scene " << i;
    EXPECT_LT(RelativeError(scene, r, {Tracing::kCones, 1e-10}), 1e-9)
        << "scene " << i;
  }
}

/// Faces of a box that emit or are black, outwards.
std::vector<TestFace> Box(const Point3& low, const Point3& high,
                          const std::array<Rgb, 6>& emission) {
  const auto [x0, y0, z0] = low;
  const auto [x1, y1, z1] = high;
  return {
      {Ceiling(x0, x1, y0, y1, z0), emission[0]},
      {testing::Floor(x0, x1, y0, y1, z1), emission[1]},
      {{{x0, y0, z0}, {x1, y0, z0}, {x1, y0, z1}, {x0, y0, z1}}, emission[2]},
      {{{x0, y1, z0}, {x0, y1, z1}, {x1, y1, z1}, {x1, y1, z0}}, emission[3]},
      {{{x0, y0, z0}, {x0, y0, z1}, {x0, y1, z1}, {x0, y1, z0}}, emission[4]},
      {{{x1, y0, z0}, {x1, y1, z0}, {x1, y1, z1}, {x1, y0, z1}}, emission[5]}};
}

TEST(VertexTracing, BoxesWithSharedEdgesInFrontOfALamp) {
  // At a shared edge only the slope tells the face in front.
  const std::array<Rgb, 6> sides = {
      {{1, 2, 3}, {3, 1, 2}, {5, 1, 1}, {1, 6, 1}, {2, 2, 9}, {4, 3, 8}}};
  for (const bool emits : {false, true}) {
    std::vector<TestFace> faces = Box({-0.13, 0.11, 0.4}, {0.22, 0.31, 0.7},
                                      emits ? sides : std::array<Rgb, 6>{});
    faces.push_back(Lamp());
    ExpectBothRight(faces, kUp);
    ExpectBothRight(faces, {{0.3, -0.6, 0.1}, {-0.2, 0.3, 1}, 0});
    ExpectBothRight(faces, {{-0.4, 0.2, 0.45}, {1, 0.1, 0.1}, 0}, 1e-9);
  }
}

TEST(VertexTracing, ShuttersHingedAtTheLamp) {
  // One depth along the hinge, and only the slope tells what is in front.
  const TestFace lamp = Lamp();
  const TestFace shutter{
      {{0.5, -0.5, 1}, {0.5, 0.5, 1}, {0.2, 0.4, 0.7}, {0.2, -0.4, 0.7}}};
  ExpectBothRight({lamp, shutter}, kUp);
  ExpectBothRight({shutter, lamp}, kUp);
  const TestFace bright{testing::Reversed(shutter.ring), {3, 1, 7}};
  ExpectBothRight({lamp, bright}, kUp);
  ExpectBothRight({bright, lamp}, kUp);
}

TEST(VertexTracing, NonConvexSourceAndManyCorners) {
  const TestFace arrow{{{-1, -1, 1},
                        {-0.9, 1.2, 1},
                        {-0.1, 0.1, 1},
                        {1.1, 1, 1},
                        {0.8, -0.9, 1}},
                       kLamp};
  const TestFace over{{{0.1, 0.13, 0.5}, {0.3, -0.2, 0.5}, {-0.2, -0.3, 0.6}}};
  ExpectBothRight({arrow}, kUp);
  ExpectBothRight({arrow, over}, kUp);
  Ring disc;
  for (int k = 0; k < 12; ++k) {
    disc.push_back({std::sin(k * 0.5), std::cos(k * 0.5), 1});
  }
  ExpectBothRight({{disc, kLamp}, over}, kUp);
}

TEST(VertexTracing, OnFaceIsIgnored) {
  const Scene scene =
      MakeScene({Lamp(), {Ceiling(-2, 2, -2, 2, 0x1p-20), kBlack}});
  const VertexTracing tracing(scene);
  EXPECT_GT(tracing.Evaluate({{}, {0, 0, 1}, 2})[0], 0.1);
  EXPECT_EQ(tracing.Evaluate(kUp), kBlack);
}

/// Triangles one above the other, an edge of each through (0.3, 0.2, 1) seen
/// from the origin; but the last one misses it by `miss`.
std::vector<TestFace> ThreeEdges(PortableRandom& random, double miss) {
  std::vector<TestFace> faces = {Lamp()};
  for (int i = 0; i < 3; ++i) {
    const double depth = 0.3 + 0.2 * i;
    const double turn = random.Uniform(0, 6.28);
    const auto at = [&](double along, double aside) {
      if (i == 2) aside += miss;
      return Point3{
          depth * (0.3 + along * std::cos(turn) - aside * std::sin(turn)),
          depth * (0.2 + along * std::sin(turn) + aside * std::cos(turn)),
          depth};
    };
    faces.push_back({{at(-0.17, 0), at(0.1, 0), at(0.05, 0.13)}});
  }
  return faces;
}

TEST(VertexTracing, ThreeEdgesThroughOnePointByCones) {
  PortableRandom random(3);
  int wrong_by_rays = 0;
  for (int i = 0; i < 60; ++i) {
    const Scene scene = MakeScene(ThreeEdges(random, 0));
    EXPECT_LT(RelativeError(scene, kUp, {Tracing::kCones, 1e-9}), 1e-7)
        << "scene " << i;
    if (RelativeError(scene, kUp, kRays) > 1e-6) ++wrong_by_rays;
  }
  EXPECT_GT(wrong_by_rays, 5);
}

TEST(VertexTracing, ACrossingCountedTwiceAsPublishedIsNotByStrictBookkeeping) {
  PortableRandom random(4);
  int wrong_as_published = 0;
  for (int i = 0; i < 60; ++i) {
    const Scene scene = MakeScene(ThreeEdges(random, 1e-6));
    EXPECT_LT(RelativeError(scene, kUp, kRays), 1e-12) << "scene " << i;
    EXPECT_LT(RelativeError(scene, kUp, {Tracing::kCones, 1e-6, true}), 1e-4)
        << "scene " << i;
    if (RelativeError(scene, kUp, {Tracing::kCones, 1e-6}) > 1e-3)
      ++wrong_as_published;
  }
  EXPECT_GT(wrong_as_published, 5);
}

TEST(VertexTracing, BlockerSeenEdgeOnUpToRounding) {
  PortableRandom random(5);
  const TestFace lamp{Ceiling(0, 32, 0, 32, 17), kLamp};
  const Receiver r{{18, 18, 1}, {0, 0, 1}, 0};
  // Its first corner is in line with two of the blade's.
  const TestFace near{{{16, 18, 5}, {15.3, 19, 5}, {16.4, 19.1, 5}}};
  const double truth = testing::Evaluate(MakeScene({lamp, near}), r)[0];
  for (int i = 0; i < 400; ++i) {
    // In a plane with the receiver.
    TestFace blade{{{12, 18, 13}, {14, 18, 9}, {14, 16, 9}}};
    for (Point3& p : blade.ring)
      p = {random.Nudge(p.x), random.Nudge(p.y), random.Nudge(p.z)};
    const VertexTracing tracing(MakeScene({lamp, near, blade}), kCones);
    EXPECT_NEAR(tracing.Evaluate(r)[0] / truth, 1, 1e-12) << "scene " << i;
  }
}

TEST(VertexTracing, TwoVerticesAndAnEdgeExactlyInLine) {
  // Small integers: even rays find the conjunction, and take it once.
  const TestFace lamp{Ceiling(-4, 4, -4, 4, 8), kLamp};
  const TestFace near{{{1, 1, 4}, {-1, 1, 4}, {0, -1, 4}}};
  const TestFace far{{{1, 1, 4}, {2, 1, 4}, {1, 3, 4}}};
  TestFace lifted{testing::Scaled(far.ring, 0.5)};
  ExpectBothRight({lamp, near, far}, kUp);
  ExpectBothRight({lamp, near, lifted}, kUp);
  // A corner of the blocker on the middle of the lamp's edge.
  ExpectBothRight({lamp, {{{2, 0, 4}, {1, 1, 4}, {1, -1, 4}}}}, kUp);
}

TEST(VertexTracing, NapeAngleOutOfRangeIsRefused) {
  for (const double angle : {0.0, -1e-6, 0.2, std::nan("")}) {
    EXPECT_THROW(VertexTracing(Scene(), {Tracing::kCones, angle}),
                 std::invalid_argument);
  }
}

}  // namespace
}  // namespace truelux
