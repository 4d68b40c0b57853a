// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives by the contour engine's two paths: the same statuses, kinks with
// their sizes b, and bits, on meshes and on emitters that are cut in many
// faces. Receivers lie where edges coincide as often as anywhere.

#include <vector>

#include <gtest/gtest.h>

#include "truelux/derivatives.h"

#include "radiometry/derivatives/receiver_derivatives.h"
#include "support/mesh_scenes.h"
#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scenes.h"
#include "support/sweep.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

/// A lamp of two times two quads over cubes or a sphere.
Scene RandomMeshScene(PortableRandom& random, bool lattice) {
  std::vector<TestFace> faces;
  for (int i = 0; i < 2; ++i) {
    for (int k = 0; k < 2; ++k) {
      faces.push_back({Ceiling(i - 1, i, k - 1, k, 4),
                       random.OneIn(3) ? Rgb{1, 2, 3} : kLamp});
    }
  }
  const std::vector<Ring> mesh =
      lattice ? VoxelMesh(random, 3, random.Integer(2, 4),
                          {-2, -2, random.Integer(0, 1) * 1.0})
              : SphereMesh(random, random.Integer(3, 6),
                           {random.Uniform(-0.5, 0.5), 0, 2}, 0.8,
                           random.OneIn(2) ? 0 : 0.2);
  for (const Ring& ring : mesh)
    faces.push_back({ring, kBlack});
  return MakeScene(faces);
}

Derivatives By(ContourPath path, const Scene& scene, const Receiver& r) {
  const ContourEngine engine(scene, path);
  OracleWorkspace workspace(engine);
  const ContourQuery query{scene, r};
  return DerivativesAt(engine, query, {}, {}, true, workspace);
}

bool AreEqual(const Vector3& a, const Vector3& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

void ExpectEqual(const Derivatives& a, const Derivatives& b) {
  EXPECT_EQ(a.irradiance.value, b.irradiance.value);
  EXPECT_EQ(a.smoothness, b.smoothness);
  EXPECT_EQ(a.undecided, b.undecided);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_TRUE(AreEqual(a.channels[c].gradient, b.channels[c].gradient));
    EXPECT_TRUE(AreEqual(a.channels[c].tangential, b.channels[c].tangential));
    EXPECT_TRUE(AreEqual(a.channels[c].normal, b.channels[c].normal));
    EXPECT_TRUE(AreEqual(a.channels[c].vector, b.channels[c].vector));
    EXPECT_EQ(a.channels[c].jacobian, b.channels[c].jacobian);
  }
  ASSERT_EQ(a.kinks.size(), b.kinks.size());
  for (std::size_t i = 0; i < a.kinks.size(); ++i) {
    EXPECT_TRUE(AreEqual(a.kinks[i].normal, b.kinks[i].normal));
    EXPECT_EQ(a.kinks[i].size, b.kinks[i].size);
    EXPECT_EQ(a.kinks[i].faces, b.kinks[i].faces);
  }
}

TEST(DerivativePaths, AgreeOnMeshes) {
  const int count = SweepSize(60, 600);
  int smooth = 0;
  int kinks = 0;
  int jumps = 0;
  for (int seed = 0; seed < count; ++seed) {
    PortableRandom random(static_cast<std::uint64_t>(seed));
    const bool lattice = seed % 3 != 0;
    const Scene scene = RandomMeshScene(random, lattice);
    for (int i = 0; i < 3; ++i) {
      Receiver r = RandomReceiver(random, lattice, 2);
      if (!lattice) r.position.z = -1;
      r.normal = {0, 0, 1};
      if (random.OneIn(5)) r.on_face = random.Integer(1, 8);
      const Derivatives expected = By(ContourPath::kBlockers, scene, r);
      SCOPED_TRACE(::testing::Message() << "seed " << seed << " " << i);
      ExpectEqual(By(ContourPath::kChain, scene, r), expected);
      ExpectEqual(By(ContourPath::kByCost, scene, r), expected);
      if (HasFailure()) return;
      smooth += expected.smoothness == Smoothness::kC1 ? 1 : 0;
      kinks += expected.smoothness == Smoothness::kKink ? 1 : 0;
      jumps += expected.smoothness == Smoothness::kDiscontinuous ? 1 : 0;
    }
  }
  EXPECT_GT(smooth, count / 4);
  EXPECT_GT(kinks, count / 8);
  EXPECT_GT(jumps, 0);
}

}  // namespace
}  // namespace truelux
