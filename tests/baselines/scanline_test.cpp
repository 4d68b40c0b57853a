// SPDX-License-Identifier: GPL-3.0-or-later
#include "baselines/scanline.h"

#include <algorithm>
#include <cmath>
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
using testing::TestFace;

const Receiver kUp{{0, 0, 0}, {0, 0, 1}, 0};

/// The largest error of a channel, relative to the certified value.
double RelativeError(const Scene& scene, const Receiver& receiver, int rows) {
  const Rgb truth = testing::Evaluate(scene, receiver);
  const Rgb value = ScanlineQuadrature(scene).Evaluate(receiver, rows);
  double error = 0;
  for (std::size_t c = 0; c < truth.size(); ++c) {
    EXPECT_GT(truth[c], 0);
    error = std::max(error, std::abs(value[c] / truth[c] - 1));
  }
  return error;
}

/// A lamp behind triangles in general position.
Scene Slab(PortableRandom& random, int count) {
  std::vector<TestFace> faces = {{Ceiling(-0.5, 0.5, -0.5, 0.5, 1), kLamp}};
  for (int i = 0; i < count; ++i) {
    const Point3 c{random.Uniform(-0.7, 0.7), random.Uniform(-0.7, 0.7),
                   random.Uniform(0.2, 0.8)};
    testing::Ring ring;
    for (int k = 0; k < 3; ++k) {
      ring.push_back({c.x + random.Uniform(-0.15, 0.15),
                      c.y + random.Uniform(-0.15, 0.15),
                      c.z + random.Uniform(-0.15, 0.15)});
    }
    faces.push_back({ring, kBlack});
  }
  return MakeScene(faces);
}

TEST(Scanline, UnoccludedSourceConvergesWithTheSquareOfTheRows) {
  const Scene scene = MakeScene({{Ceiling(-1, 0.5, -0.25, 2, 1.5), kLamp}});
  const Receiver tilted{{0.1, 0.2, 0.3}, {0.3, -0.2, 1}, 0};
  const double coarse = RelativeError(scene, tilted, 64);
  EXPECT_LT(coarse, 1e-4);
  EXPECT_LT(RelativeError(scene, tilted, 4096), coarse / 2000);
}

TEST(Scanline, TriangleSource) {
  const Scene scene =
      MakeScene({{{{0, 0, 2}, {0.5, 1.5, 1.25}, {1.5, 0.25, 1}}, kLamp}});
  EXPECT_LT(RelativeError(scene, kUp, 4096), 1e-6);
}

TEST(Scanline, HorizonCutsTheSource) {
  const Scene scene =
      MakeScene({{{{1, 1, -1}, {1, -1, -1}, {1, -1, 2}, {1, 1, 2}}, kLamp}});
  EXPECT_LT(RelativeError(scene, kUp, 4096), 1e-6);
  const Receiver tilted{{0, 0, 0}, {0.2, 0.7, 0.3}, 0};
  EXPECT_LT(RelativeError(scene, tilted, 4096), 1e-6);
}

TEST(Scanline, NothingFromBehindOrBelow) {
  const Scene scene = MakeScene({{Ceiling(-1, 1, -1, 1, -1), kLamp}});
  const ScanlineQuadrature quadrature(scene);
  EXPECT_EQ(quadrature.Evaluate(kUp, 64), kBlack);
  EXPECT_EQ(quadrature.Evaluate({{0, 0, -2}, {0, 0, -1}, 0}, 64), kBlack);
}

TEST(Scanline, ManyBlockersConverge) {
  PortableRandom random(1);
  for (int i = 0; i < 8; ++i) {
    const Scene scene = Slab(random, 30);
    EXPECT_LT(RelativeError(scene, kUp, 2048), 2e-4);
    EXPECT_LT(RelativeError(scene, kUp, 65536), 1e-6);
  }
}

TEST(Scanline, BlockerThroughTheSourceAndBehindTheReceiver) {
  const Scene scene =
      MakeScene({{Ceiling(-0.5, 0.5, -0.5, 0.5, 1), kLamp},
                 {{{0.1, 0.13, 0.4}, {0.3, -0.11, 1.7}, {-0.2, 0.07, 1.2}}},
                 {{{0.13, -0.2, -1}, {0.17, 0.7, -0.8}, {-0.4, 0.31, 2.5}}}});
  EXPECT_LT(RelativeError(scene, kUp, 65536), 1e-6);
}

TEST(Scanline, NonConvexSource) {
  const Scene scene = MakeScene({{{{-1, -1, 1},
                                   {-0.9, 1.2, 1},
                                   {-0.1, 0.1, 1},
                                   {1.1, 1, 1},
                                   {0.8, -0.9, 1}},
                                  kLamp}});
  EXPECT_LT(RelativeError(scene, kUp, 16384), 1e-6);
}

TEST(Scanline, OnFaceIsIgnored) {
  const Scene scene = MakeScene({{Ceiling(-1, 1, -1, 1, 1), kLamp},
                                 {Ceiling(-2, 2, -2, 2, 0x1p-20), kBlack}});
  const Rgb open = ScanlineQuadrature(scene).Evaluate({{}, {0, 0, 1}, 2}, 64);
  EXPECT_GT(open[0], 0.1);
  EXPECT_EQ(ScanlineQuadrature(scene).Evaluate(kUp, 64), kBlack);
}

TEST(Scanline, SoupsOfEmittersThatHideEachOther) {
  PortableRandom random(2);
  int lit = 0;
  for (int i = 0; i < 40; ++i) {
    const Scene scene = MakeScene(testing::RandomScene(random, false, 12));
    const Receiver receiver = testing::RandomReceiver(random, false);
    const Rgb truth = testing::Evaluate(scene, receiver);
    const Rgb value = ScanlineQuadrature(scene).Evaluate(receiver, 8192);
    if (truth[0] > 0) ++lit;
    for (std::size_t c = 0; c < truth.size(); ++c)
      EXPECT_NEAR(value[c], truth[c], 1e-4) << "scene " << i;
  }
  EXPECT_GT(lit, 10);
}

}  // namespace
}  // namespace truelux
