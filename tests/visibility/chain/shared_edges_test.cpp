// SPDX-License-Identifier: GPL-3.0-or-later
// Receivers of a block share the edges that their chains are made of: the same
// bits however they are grouped, on meshes that the chain is used for.

#include "visibility/chain/shared_edges.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/irradiance.h"

#include "exact/number.h"
#include "radiometry/evaluate.h"
#include "scene/index/convex_pieces.h"
#include "scene/scene_access.h"
#include "support/mesh_scenes.h"
#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scenes.h"
#include "support/sweep.h"
#include "visibility/edges/contour_engine.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

/// Two lamps above one or two spheres that together have over 300 inner edges
/// towards most receivers below.
std::vector<TestFace> SpheresUnderLamps(PortableRandom& random) {
  std::vector<TestFace> faces{{Ceiling(-2, 0, -1, 1, 4), kLamp},
                              {{{1, -1, 3}, {1, 1, 3}, {2, 0, 5}}, {0, 1, 3}}};
  const int count = random.Integer(1, 2);
  for (int i = 0; i < count; ++i) {
    const Point3 centre{random.Uniform(-1, 1), random.Uniform(-1, 1),
                        random.Uniform(1, 2)};
    std::vector<Ring> mesh =
        SphereMesh(random, random.Integer(18, 24), centre,
                   random.Uniform(0.7, 1.3), random.OneIn(2) ? 0 : 0.02);
    if (random.OneIn(3)) mesh = Damaged(random, mesh, 50);
    for (const Ring& ring : mesh)
      faces.push_back({ring, kBlack});
  }
  return faces;
}

/// Receivers in a row of small or of large steps, with one normal or many;
/// some are said to be on a face.
std::vector<Receiver> RowOfReceivers(PortableRandom& random, int count) {
  std::vector<Receiver> receivers;
  const double step = random.OneIn(2) ? 0.01 : 0.7;
  const bool one_normal = random.OneIn(2);
  const Point3 first{random.Uniform(-3, 1), random.Uniform(-1, 1),
                     random.Uniform(-2, 0)};
  for (int i = 0; i < count; ++i) {
    Receiver r{{first.x + step * i, first.y, first.z}, {0, 0, 1}, 0};
    if (!one_normal) {
      r.normal = {random.Uniform(-1, 1), random.Uniform(-1, 1),
                  random.Uniform(0, 1) + 0.1};
    }
    if (random.OneIn(8)) r.on_face = random.Integer(1, 300);
    receivers.push_back(r);
  }
  return receivers;
}

void ExpectSame(const Irradiance& actual, const Irradiance& expected) {
  EXPECT_EQ(actual.value, expected.value);
  EXPECT_EQ(actual.bound, expected.bound);
}

class SharedEdgesByMethod : public ::testing::TestWithParam<Method> {};

TEST_P(SharedEdgesByMethod, GroupingChangesNoBit) {
  PortableRandom random(1);
  int shaded = 0;
  const int count = SweepSize(100, 2000);
  for (int i = 0; i < count; ++i) {
    const std::vector<TestFace> faces = SpheresUnderLamps(random);
    const Oracle oracle(MakeScene(faces), {.method = GetParam()});
    const Oracle lamps(MakeScene({faces[0], faces[1]}));
    const std::vector<Receiver> receivers = RowOfReceivers(random, 12);
    const std::vector<Receiver> backwards(receivers.rbegin(), receivers.rend());
    const auto together = oracle.Evaluate(receivers);
    const auto reversed = oracle.Evaluate(backwards);
    const auto first_half = oracle.Evaluate(std::span(receivers).first(5));
    const auto other_half = oracle.Evaluate(std::span(receivers).subspan(5));
    for (std::size_t k = 0; k < receivers.size(); ++k) {
      const Irradiance alone = oracle.Evaluate(receivers[k]);
      ExpectSame(together[k], alone);
      ExpectSame(reversed[receivers.size() - 1 - k], alone);
      ExpectSame(k < 5 ? first_half[k] : other_half[k - 5], alone);
      if (receivers[k].on_face > 0) continue;
      if (alone.value[1] < 0.99 * lamps.Evaluate(receivers[k]).value[1])
        ++shaded;
    }
    ASSERT_FALSE(HasFailure()) << i;
  }
  EXPECT_GT(shaded, 4 * count);
}

// On a lattice edges end on edges, in view; behind the receiver, too, and below
// the horizon, where only some of a block's receivers ask for them.
TEST_P(SharedEdgesByMethod, GroupingChangesNoBitOnALattice) {
  int lit = 0;
  const int count = SweepSize(300, 6000);
  for (int i = 0; i < count; ++i) {
    PortableRandom random(static_cast<std::uint64_t>(i));
    std::vector<TestFace> faces =
        RandomScene(random, true, random.Integer(4, 40), 3);
    for (TestFace& face : faces)
      face.emission = kBlack;
    // In tiles, so that the chain is used however few edges there are.
    for (const double x : {-6.0, -2.0, 2.0})
      faces.push_back({Ceiling(x, x + 4, -3, 3, 4), kLamp});
    const Oracle oracle(MakeScene(faces), {.method = GetParam()});
    std::vector<Receiver> receivers;
    for (int k = 0; k < 6; ++k) {
      receivers.push_back(RandomReceiver(random, true, 3));
      receivers.back().normal = {0, 0, 1};
    }
    const auto together = oracle.Evaluate(receivers);
    for (std::size_t k = 0; k < receivers.size(); ++k) {
      const Irradiance alone = oracle.Evaluate(receivers[k]);
      ExpectSame(together[k], alone);
      if (alone.value[0] > 0) ++lit;
    }
    ASSERT_FALSE(HasFailure()) << i;
  }
  EXPECT_GT(lit, count);
}

INSTANTIATE_TEST_SUITE_P(Methods, SharedEdgesByMethod,
                         ::testing::Values(Method::kCertified, Method::kDouble),
                         [](const auto& test) {
                           return test.param == Method::kDouble ? "Double"
                                                                : "Certified";
                         });

TEST(SharedEdges, ABuilderMakesTheSameContoursInABlockAsAlone) {
  PortableRandom random(2);
  std::uint64_t sources = 0;
  std::uint64_t queries = 0;
  const EvaluationQuery in_double{.method = Method::kDouble};
  const int count = SweepSize(100, 2000);
  for (int i = 0; i < count; ++i) {
    const Scene scene = MakeScene(SpheresUnderLamps(random));
    const ContourEngine by_cost(scene);
    const ContourEngine by_blockers(scene, ContourPath::kBlockers);
    ContourBuilder in_block(by_cost);
    ContourBuilder alone(by_cost);
    ContourBuilder blockers(by_blockers);
    const std::vector<Receiver> receivers = RowOfReceivers(random, 8);
    in_block.StartBlock(receivers);
    for (const Receiver& r : receivers) {
      const ContourQuery query{scene, r};
      Contour contour;
      in_block.Build(query, contour);
      const Irradiance shared = EvaluateContour(query, contour, in_double);
      const Rgb certified = EvaluateContour(query, contour, {}).value;
      alone.Build(query, contour);
      ExpectSame(shared, EvaluateContour(query, contour, in_double));
      // Summed in another order, but of the same region.
      blockers.Build(query, contour);
      EXPECT_EQ(certified, EvaluateContour(query, contour, {}).value);
    }
    // The chains are the same, edge by edge.
    EXPECT_EQ(in_block.chain_counts().sources, alone.chain_counts().sources);
    EXPECT_EQ(blockers.chain_counts().sources, 0U);
    sources += in_block.chain_counts().sources;
    queries += in_block.chain_counts().queries;
    ASSERT_FALSE(HasFailure()) << i;
  }
  // More than a quarter of what two lamps and eight receivers make.
  EXPECT_GT(sources, 4U * static_cast<std::uint64_t>(count));
  EXPECT_GT(queries, 0U);
}

/// A sphere and its tree.
struct Indexed {
  Scene scene;
  SilhouetteTree tree;

  explicit Indexed(int n) {
    PortableRandom random(3);
    std::vector<TestFace> faces{{Ceiling(-1, 1, -1, 1, 4), kLamp}};
    for (const Ring& ring : SphereMesh(random, n, {0, 0, 2}, 1, 0))
      faces.push_back({ring, kBlack});
    scene = MakeScene(faces);
    tree = SilhouetteTree(scene, ConvexPieces(scene));
  }

  [[nodiscard]] ShaftSource lamp() const {
    return {scene.vertices(), TrianglesOf(scene, FacetsOf(scene)[FacetId(0)])};
  }
};

std::vector<EdgeId> Visited(const SilhouetteTree& tree, const Shaft& shaft,
                            const Box& box) {
  std::vector<EdgeId> edges;
  tree.Visit(shaft, box, [&](const SilhouetteEdge& edge) {
    edges.push_back(edge.edge);
    return true;
  });
  return edges;
}

std::vector<EdgeId> IdsOf(const std::vector<SilhouetteEdge>* edges) {
  std::vector<EdgeId> ids;
  for (const SilhouetteEdge& edge : *edges)
    ids.push_back(edge.edge);
  return ids;
}

TEST(SharedEdges, AreTheEdgesOfTheBlockIfTheFirstReceiverHasManyOfThem) {
  const Indexed sphere(20);
  const RoundUpward rounding;
  const Box block{{-0.1, -0.1, 0}, {0.1, 0.1, 0}};
  const Shaft shaft(sphere.lamp(), block);
  const auto make_shaft = [&] { return shaft; };
  const std::vector<EdgeId> expected = Visited(sphere.tree, shaft, block);
  ASSERT_GT(expected.size(), 50U);
  SharedEdges shared;
  for (int i = 0; i < 3; ++i) {
    shared.Start();
    // The first receiver is by itself.
    EXPECT_EQ(shared.Get(sphere.tree, make_shaft, block), nullptr);
    EXPECT_EQ(shared.Get(sphere.tree, make_shaft, block), nullptr);
    shared.Measure(expected.size() / 2);
    const auto* edges = shared.Get(sphere.tree, make_shaft, block);
    ASSERT_NE(edges, nullptr);
    EXPECT_EQ(IdsOf(edges), expected);
    // What other receivers look at does not matter.
    shared.Measure(0);
    EXPECT_EQ(shared.Get(sphere.tree, make_shaft, block), edges);
    EXPECT_EQ(IdsOf(edges), expected);
  }
}

TEST(SharedEdges, AreNotSharedIfTheFirstReceiverHasFewOfThem) {
  const Indexed sphere(20);
  const RoundUpward rounding;
  const Box block{{-9, -9, 0}, {9, 9, 0}};
  const Shaft shaft(sphere.lamp(), block);
  const auto make_shaft = [&] { return shaft; };
  ASSERT_GT(Visited(sphere.tree, shaft, block).size(), 100U);
  SharedEdges shared;
  shared.Start();
  shared.Measure(1);
  EXPECT_EQ(shared.Get(sphere.tree, make_shaft, block), nullptr);
  shared.Measure(1000000);
  EXPECT_EQ(shared.Get(sphere.tree, make_shaft, block), nullptr);
  // Another block.
  shared.Start();
  shared.Measure(1000000);
  EXPECT_NE(shared.Get(sphere.tree, make_shaft, block), nullptr);
}

TEST(SharedEdges, OfABlockAreThoseOfEachReceiverInTheSameOrderAndMore) {
  const Indexed sphere(24);
  PortableRandom random(4);
  for (int i = 0; i < 50; ++i) {
    std::vector<Point3> receivers(5);
    Box block;
    for (Point3& r : receivers) {
      r = {random.Uniform(-2, 2), random.Uniform(-2, 2), 0};
      block.Include(r);
    }
    const RoundUpward rounding;
    SharedEdges shared;
    shared.Start();
    shared.Measure(1000000);
    const std::vector<EdgeId> of_block = IdsOf(shared.Get(
        sphere.tree, [&] { return Shaft(sphere.lamp(), block); }, block));
    for (const Point3& r : receivers) {
      const std::vector<EdgeId> alone =
          Visited(sphere.tree, Shaft(sphere.lamp(), Box::Of(r)), Box::Of(r));
      auto next = of_block.begin();
      for (const EdgeId edge : alone) {
        next = std::find(next, of_block.end(), edge);
        ASSERT_TRUE(next != of_block.end()) << i;
        ++next;
      }
    }
  }
}

}  // namespace
}  // namespace truelux
