// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/index/silhouette_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "exact/number.h"
#include "scene/index/silhouette_twin.h"
#include "scene/scene_access.h"
#include "support/mesh_scenes.h"
#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scenes.h"
#include "support/sweep.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

constexpr double kMax = std::numeric_limits<double>::max();

/// A kind of scene: its mesh is scaled by a power of two, and then moved.
struct Kind {
  const char* name;
  std::vector<Ring> (*make)(PortableRandom&);
  int exponent = 0;
  double offset = 0;
  /// Whether something is known of every normal, so that all edges that are
  /// inner from somewhere are taken for such.
  bool is_known = true;
};

void PrintTo(const Kind& kind, std::ostream* out) {
  *out << kind.name;
}

Point3 SomeCentre(PortableRandom& random) {
  return {random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1)};
}

std::vector<Ring> SmoothSphere(PortableRandom& random) {
  return SphereMesh(random, random.Integer(3, 24), SomeCentre(random),
                    random.Uniform(0.5, 2), 0);
}

std::vector<Ring> NoisySphere(PortableRandom& random) {
  return SphereMesh(random, random.Integer(3, 16), SomeCentre(random),
                    random.Uniform(0.5, 2), 0.2);
}

std::vector<Ring> DamagedSphere(PortableRandom& random) {
  return Damaged(random, SmoothSphere(random), random.Integer(3, 30));
}

std::vector<Ring> Voxels(PortableRandom& random) {
  return VoxelMesh(random, random.Integer(2, 5), random.Integer(2, 4),
                   {-2, -2, -2}, random.OneIn(3));
}

std::vector<Ring> DamagedVoxels(PortableRandom& random) {
  return Damaged(random, Voxels(random), random.Integer(3, 30));
}

std::vector<Ring> RingsOf(const std::vector<TestFace>& faces) {
  std::vector<Ring> rings;
  for (const TestFace& face : faces)
    rings.push_back(face.ring);
  return rings;
}

std::vector<Ring> LatticeSoup(PortableRandom& random) {
  return RingsOf(
      RandomScene(random, true, random.Integer(2, 80), random.Integer(1, 3)));
}

std::vector<Ring> GeneralSoup(PortableRandom& random) {
  return RingsOf(RandomScene(random, false, random.Integer(2, 60)));
}

double Placed(const Kind& kind, double x) {
  return std::ldexp(x, kind.exponent) + kind.offset;
}

Point3 Placed(const Kind& kind, const Point3& p) {
  return {Placed(kind, p.x), Placed(kind, p.y), Placed(kind, p.z)};
}

/// The first face is the lamp.
Scene SceneOf(const Kind& kind, PortableRandom& random) {
  const Ring lamp = random.OneIn(2)
                        ? Ceiling(-2, 2, -1, 1, random.Integer(0, 5))
                        : Ring{{-1, -2, 2}, {0, 3, 4}, {3, 1, -1}};
  std::vector<TestFace> faces{{lamp, kLamp}};
  for (const Ring& ring : kind.make(random))
    faces.push_back({ring, kBlack});
  for (TestFace& face : faces) {
    for (Point3& p : face.ring)
      p = Placed(kind, p);
  }
  return MakeScene(faces);
}

/// Receivers near each other or apart, or one; some of them corners of the
/// scene, which lie in planes of pieces; some as far away as can be.
std::vector<Point3> SomeReceivers(const Kind& kind, PortableRandom& random,
                                  const Scene& scene) {
  std::vector<Point3> receivers;
  const Point3 first = RandomPoint(random, random.OneIn(2), 4);
  const bool near = random.OneIn(2);
  const int count = random.OneIn(2) ? 1 : random.Integer(2, 6);
  for (int i = 0; i < count; ++i) {
    const auto vertices = scene.vertices();
    if (random.OneIn(6)) {
      receivers.push_back(vertices[static_cast<std::size_t>(
          random.Integer(0, static_cast<int>(vertices.size()) - 1))]);
    } else if (random.OneIn(20)) {
      const auto far = [&] {
        return random.OneIn(4) ? -kMax : kMax * random.Uniform(-1, 1);
      };
      receivers.push_back({far(), far(), far()});
    } else if (near) {
      receivers.push_back(
          Placed(kind, Point3{first.x + random.Uniform(0, 0.1),
                              first.y + random.Uniform(0, 0.1), first.z}));
    } else {
      receivers.push_back(
          Placed(kind, RandomPoint(random, random.OneIn(2), 4)));
    }
  }
  return receivers;
}

std::vector<SilhouetteEdge> Visited(const SilhouetteTree& tree,
                                    const Shaft& shaft, const Box& box) {
  std::vector<SilhouetteEdge> visited;
  EXPECT_TRUE(tree.Visit(shaft, box, [&](const SilhouetteEdge& edge) {
    visited.push_back(edge);
    return true;
  }));
  return visited;
}

std::vector<EdgeId> IdsOf(const std::vector<SilhouetteEdge>& edges) {
  std::vector<EdgeId> ids;
  for (const SilhouetteEdge& edge : edges)
    ids.push_back(edge.edge);
  return ids;
}

std::vector<EdgeId> Sorted(std::vector<EdgeId> edges) {
  std::ranges::sort(edges);
  return edges;
}

/// Whether `part` is `whole` with some edges left out.
bool IsSubsequence(const std::vector<EdgeId>& part,
                   const std::vector<EdgeId>& whole) {
  auto next = whole.begin();
  return std::ranges::all_of(part, [&](EdgeId x) {
    next = std::find(next, whole.end(), x);
    return next != whole.end() && (++next, true);
  });
}

constexpr Box kEverywhere{{-1e308, -1e308, -1e308}, {1e308, 1e308, 1e308}};

/// The first facet, as what shafts lead to.
ShaftSource LampOf(const Scene& scene) {
  return {scene.vertices(), TrianglesOf(scene, FacetsOf(scene)[FacetId(0)])};
}

class SilhouetteTreeOfKind : public ::testing::TestWithParam<Kind> {};

TEST_P(SilhouetteTreeOfKind, VisitsOnceWhatIsNotInner) {
  const Kind& kind = GetParam();
  std::size_t needed = 0;
  std::size_t left_out = 0;
  const int count = SweepSize(40, 400);
  for (int seed = 0; seed < count; ++seed) {
    PortableRandom random(static_cast<std::uint64_t>(seed) + 1);
    const Scene scene = SceneOf(kind, random);
    const ConvexPieces pieces(scene);
    const SilhouetteTree tree(scene, pieces);
    for (int block = 0; block < 4; ++block) {
      const std::vector<Point3> receivers = SomeReceivers(kind, random, scene);
      Box box;
      for (const Point3& r : receivers)
        box.Include(r);
      const RoundUpward rounding;
      const ShaftSource lamp = LampOf(scene);
      const Shaft wide(lamp, kEverywhere);
      // The shaft of a block, of one receiver, or of everything.
      const Shaft shaft(lamp, block == 0   ? kEverywhere
                              : block == 1 ? Box::Of(receivers[0])
                                           : box);
      const std::vector<SilhouetteEdge> visited = Visited(tree, shaft, box);
      const std::vector<EdgeId> ids = IdsOf(visited);
      const std::vector<EdgeId> sorted = Sorted(ids);
      ASSERT_TRUE(std::ranges::adjacent_find(sorted) == sorted.end()) << seed;
      for (const SilhouetteEdge& edge : visited) {
        ASSERT_TRUE(IsFirst(pieces, edge.edge)) << seed;
        ASSERT_EQ(edge.piece, pieces.PieceOf(edge.edge)) << seed;
        const PieceId other = OnlyOtherPiece(pieces, edge.edge);
        if (kind.is_known || edge.other_piece.valid()) {
          ASSERT_EQ(edge.other_piece, other) << seed;
        }
      }
      for (const EdgeId edge : NotInner(scene, pieces, receivers)) {
        if (!shaft.Keeps(BoxOf(scene, pieces, edge))) continue;
        ASSERT_TRUE(std::ranges::binary_search(sorted, edge)) << seed;
        ++needed;
      }
      // The order is that of the whole tree, whoever asks.
      const std::vector<EdgeId> all = IdsOf(Visited(tree, wide, kEverywhere));
      ASSERT_TRUE(IsSubsequence(ids, all)) << seed;
      left_out += all.size() - ids.size();
    }
  }
  EXPECT_GT(needed, 1000U);
  EXPECT_GT(left_out, 1000U);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, SilhouetteTreeOfKind,
    ::testing::Values(
        Kind{"SmoothSphere", SmoothSphere}, Kind{"NoisySphere", NoisySphere},
        Kind{"DamagedSphere", DamagedSphere}, Kind{"Voxels", Voxels},
        Kind{"DamagedVoxels", DamagedVoxels}, Kind{"LatticeSoup", LatticeSoup},
        Kind{"GeneralSoup", GeneralSoup},
        // The corners are rounded to 2^-12, so that triangles may lose their
        // area, and normals are known badly or not at all.
        Kind{"FarSphere", SmoothSphere, 0, 0x1p40, false},
        Kind{"FarVoxels", Voxels, 0, 0x1p40},
        Kind{"LargeSphere", SmoothSphere, 200},
        Kind{"HugeSphere", SmoothSphere, 1000, 0, false},
        Kind{"HugeVoxels", DamagedVoxels, 1000, 0, false},
        Kind{"SmallSphere", SmoothSphere, -200},
        Kind{"TinySphere", NoisySphere, -540, 0, false},
        Kind{"DenormalVoxels", Voxels, -1072, 0, false}),
    [](const auto& test) { return std::string(test.param.name); });

/// A sphere of n rings below a lamp.
Scene SphereScene(int n, double noise) {
  PortableRandom random(5);
  std::vector<TestFace> faces{{Ceiling(-1, 1, -1, 1, 4), kLamp}};
  for (const Ring& ring : SphereMesh(random, n, {0, 0, 0}, 1, noise))
    faces.push_back({ring, kBlack});
  return MakeScene(faces);
}

TEST(SilhouetteTree, VisitsASmallShareOfALargeSphere) {
  const Scene scene = SphereScene(60, 0);
  const ConvexPieces pieces(scene);
  const SilhouetteTree tree(scene, pieces);
  PortableRandom random(6);
  for (int i = 0; i < 50; ++i) {
    const Point3 r{random.Uniform(2, 6), random.Uniform(-6, 6),
                   random.Uniform(-6, 6)};
    const std::vector<EdgeId> needed = NotInner(scene, pieces, {&r, 1});
    const RoundUpward rounding;
    const Shaft wide(LampOf(scene), kEverywhere);
    const std::size_t visited = Visited(tree, wide, Box::Of(r)).size();
    EXPECT_GE(visited, needed.size());
    EXPECT_LT(5 * visited, CountPaired(pieces));
  }
}

/// The corners of a grid of slivers in one plane are integers, and so are receivers
/// in that plane. The normals are differences of products that do not fit in a
/// double, and much smaller than these.
TEST(SilhouetteTree, VisitsAllOfThePlaneThatTheReceiverLiesIn) {
  PortableRandom random(8);
  for (int i = 0; i < 200; ++i) {
    std::array<double, 3> u{};
    std::array<double, 3> v{};
    for (std::size_t k = 0; k < 3; ++k) {
      u[k] = random.Integer(1 << 29, 1 << 30);
      v[k] = u[k] + random.Integer(-(1 << 14), 1 << 14);
    }
    const auto at = [&](int s, int t) -> Point3 {
      return {s * u[0] + t * v[0], s * u[1] + t * v[1], s * u[2] + t * v[2]};
    };
    std::vector<TestFace> faces{{Ceiling(-1, 1, -1, 1, 4), kLamp}};
    for (int s = 0; s < 8; ++s) {
      for (int t = 0; t < 8; ++t) {
        faces.push_back({{at(s, t), at(s + 1, t), at(s, t + 1)}, kBlack});
        faces.push_back(
            {{at(s + 1, t + 1), at(s, t + 1), at(s + 1, t)}, kBlack});
      }
    }
    const Scene scene = MakeScene(faces);
    const ConvexPieces pieces(scene);
    const SilhouetteTree tree(scene, pieces);
    const Point3 r = at(random.Integer(-9, 20), random.Integer(-9, 20));
    const RoundUpward rounding;
    const Shaft wide(LampOf(scene), kEverywhere);
    const std::size_t all = Visited(tree, wide, kEverywhere).size();
    EXPECT_EQ(Visited(tree, wide, Box::Of(r)).size(), all) << i;
  }
}

TEST(SilhouetteTree, ManyReceiversNeedMoreThanOne) {
  const Scene scene = SphereScene(40, 0);
  const SilhouetteTree tree(scene, ConvexPieces(scene));
  const RoundUpward rounding;
  const Shaft wide(LampOf(scene), kEverywhere);
  Box box = Box::Of({3, 0, 0});
  const std::size_t one = Visited(tree, wide, box).size();
  box.Include(Point3{3, 1, 0});
  const std::size_t row = Visited(tree, wide, box).size();
  box.Include(Point3{-3, -3, -3});
  const std::size_t around = Visited(tree, wide, box).size();
  EXPECT_LT(one, row);
  EXPECT_LT(2 * row, around);
}

TEST(SilhouetteTree, StopsWhenToldTo) {
  const Scene scene = SphereScene(20, 0.1);
  const SilhouetteTree tree(scene, ConvexPieces(scene));
  const RoundUpward rounding;
  const Shaft wide(LampOf(scene), kEverywhere);
  const std::size_t all = Visited(tree, wide, kEverywhere).size();
  for (const std::size_t most : {std::size_t{1}, all / 2, all}) {
    std::size_t visited = 0;
    EXPECT_FALSE(tree.Visit(wide, kEverywhere, [&](const SilhouetteEdge&) {
      return ++visited < most;
    }));
    EXPECT_EQ(visited, most);
  }
}

TEST(SilhouetteTree, OfNothingVisitsNothing) {
  const Scene lamp = MakeScene({{Ceiling(-1, 1, -1, 1, 4), kLamp}});
  const RoundUpward rounding;
  const Shaft wide(LampOf(lamp), kEverywhere);
  const Scene nothing;
  for (const SilhouetteTree& tree :
       {SilhouetteTree(), SilhouetteTree(nothing, ConvexPieces(nothing))}) {
    EXPECT_TRUE(Visited(tree, wide, kEverywhere).empty());
    EXPECT_FALSE(tree.HasNear(wide, 1));
  }
  // A border is visited, but it is no inner edge.
  const SilhouetteTree of_lamp(lamp, ConvexPieces(lamp));
  EXPECT_EQ(Visited(of_lamp, wide, Box::Of({0, 0, 0})).size(), 4U);
  EXPECT_FALSE(of_lamp.HasNear(wide, 1));
}

TEST(SilhouetteTree, CountsWhatIsNear) {
  PortableRandom random(7);
  int between = 0;
  for (int n = 4; n < 40; ++n) {
    const Scene scene = SphereScene(n, n % 2 == 0 ? 0 : 0.1);
    const ConvexPieces pieces(scene);
    const SilhouetteTree tree(scene, pieces);
    const SilhouetteTree same(scene, pieces);
    const std::size_t all = CountPaired(pieces);
    const RoundUpward rounding;
    const ShaftSource lamp = LampOf(scene);
    EXPECT_TRUE(tree.HasNear(Shaft(lamp, kEverywhere), all)) << n;
    EXPECT_FALSE(tree.HasNear(Shaft(lamp, kEverywhere), all + 1)) << n;
    // From above the lamp the sphere is behind it.
    EXPECT_FALSE(tree.HasNear(Shaft(lamp, Box::Of({0, 0, 9})), 1)) << n;
    for (int i = 0; i < 20; ++i) {
      const Point3 r = RandomPoint(random, false, 4);
      const Shaft shaft(lamp, Box::Of(r));
      // The greatest number that is near.
      std::size_t near = 0;
      while (tree.HasNear(shaft, near + 1))
        ++near;
      EXPECT_LE(near, all);
      for (const std::size_t count : {near / 2, near, near + 1, all}) {
        if (count == 0) continue;
        EXPECT_EQ(tree.HasNear(shaft, count), count <= near);
        EXPECT_EQ(same.HasNear(shaft, count), count <= near);
      }
      if (near > 0 && near < all) ++between;
    }
  }
  EXPECT_GT(between, 100);
}

}  // namespace
}  // namespace truelux
