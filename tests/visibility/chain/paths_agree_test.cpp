// SPDX-License-Identifier: GPL-3.0-or-later
// The contour engine's two paths, by blockers and by the chain, and the slow
// twin that leaves out nothing: the same bits on soups and meshes of every
// kind. Every depth along the chain is what a ray query says.

#include <cstdint>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "radiometry/evaluate.h"
#include "support/plain_contour.h"
#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scene_kinds.h"
#include "support/scenes.h"
#include "support/sweep.h"
#include "visibility/edges/contour_engine.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

/// The values of a contour's sources one by one, with their facets; those of
/// which nothing is visible are left out.
std::vector<std::pair<FacetId, Rgb>> ValuesBySource(const ContourQuery& query,
                                                    const Contour& contour) {
  std::vector<std::pair<FacetId, Rgb>> values;
  for (const SourceArcs& source : contour.sources) {
    Contour only = contour;
    only.sources.clear();
    only.sources.push_back(source);
    const Rgb value = EvaluateContour(query, only, {}).value;
    if (value != Rgb{}) values.emplace_back(source.facet, value);
  }
  return values;
}

/// A kind of scene, and how many.
struct Kind {
  const char* name;
  int count;
  std::vector<TestFace> (*make)(PortableRandom&);
  bool lattice;
  /// What no scene of the kind would test if it were zero.
  std::vector<std::uint64_t ChainCounts::*> must_occur;
};

void PrintTo(const Kind& kind, std::ostream* out) {
  *out << kind.name;
}

Point3 MiddleOf(const Ring& ring) {
  const Point3& a = ring[0];
  const Point3& c = ring[2];
  return {a.x / 2 + c.x / 2, a.y / 2 + c.y / 2, a.z / 2 + c.z / 2};
}

/// The number of the face that is nearest to the way from a point to the first
/// face, so that it matters whether the face is there.
int FaceOnTheWay(const Point3& from, const std::vector<TestFace>& faces) {
  const Point3 to = MiddleOf(faces[0].ring);
  const Vector3 way{to.x - from.x, to.y - from.y, to.z - from.z};
  const double length = way.x * way.x + way.y * way.y + way.z * way.z;
  int nearest = 1;
  double least = HUGE_VAL;
  for (std::size_t i = 1; i < faces.size(); ++i) {
    const Point3 m = MiddleOf(faces[i].ring);
    const Vector3 d{m.x - from.x, m.y - from.y, m.z - from.z};
    const double t = (d.x * way.x + d.y * way.y + d.z * way.z) / length;
    if (!(t > 0) || !(t < 1)) continue;
    const double distance = std::abs(d.x - t * way.x) +
                            std::abs(d.y - t * way.y) +
                            std::abs(d.z - t * way.z);
    if (distance < least) {
      least = distance;
      nearest = static_cast<int>(i) + 1;
    }
  }
  return nearest;
}

/// A receiver anywhere, or on a face, an edge or a corner of the scene.
Receiver ReceiverFor(const Kind& kind, PortableRandom& random,
                     const std::vector<TestFace>& faces) {
  Receiver r = RandomReceiver(random, kind.lattice, 3);
  const auto& face = faces[static_cast<std::size_t>(
      random.Integer(0, static_cast<int>(faces.size()) - 1))];
  const Point3& a = face.ring[0];
  const Point3& b = face.ring[1];
  const Point3& c = face.ring[2];
  const auto middle = [](const Point3& p, const Point3& q) -> Point3 {
    return {p.x / 2 + q.x / 2, p.y / 2 + q.y / 2, p.z / 2 + q.z / 2};
  };
  switch (random.Integer(0, 6)) {
    case 0:
      r.position = a;
      break;
    case 1:
      r.position = middle(a, b);
      break;
    case 2:
      r.position = middle(a, c);
      break;
    case 3:
      r.on_face = FaceOnTheWay(r.position, faces);
      break;
    case 4:
      r.position = middle(a, c);
      r.on_face = static_cast<int>(&face - faces.data()) + 1;
      break;
    case 5: {  // a little behind the face that it is said to be on
      const Point3 m = middle(a, c);
      r.position = {m.x + 0.01 * (r.position.x - m.x),
                    m.y + 0.01 * (r.position.y - m.y),
                    m.z + 0.01 * (r.position.z - m.z)};
      r.on_face = static_cast<int>(&face - faces.data()) + 1;
      break;
    }
    default:
      break;
  }
  if (std::string(kind.name) == "FarAway" && r.position.x < 0x1p30) {
    r.position = {r.position.x + 0x1p40, r.position.y - 0x1p41,
                  r.position.z + 0x1p39};
  }
  return r;
}

class PathsAgree : public ::testing::TestWithParam<Kind> {};

TEST_P(PathsAgree, OnScenesOfAllKinds) {
  const Kind& kind = GetParam();
  const int count = SweepSize(kind.count, 10 * kind.count);
  int lit = 0;
  int dark = 0;
  int joined_count = 0;
  ChainCounts counts;
  for (int seed = 0; seed < count; ++seed) {
    PortableRandom random(static_cast<std::uint64_t>(seed) + 7);
    const std::vector<TestFace> faces = kind.make(random);
    const Scene scene = MakeScene(faces);
    const ContourEngine by_blockers(scene, ContourPath::kBlockers);
    const ContourEngine by_chain(scene, ContourPath::kCheckedChain);
    ContourBuilder blockers_path(by_blockers);
    ContourBuilder chain_path(by_chain);
    for (int i = 0; i < 4; ++i) {
      const Receiver r = ReceiverFor(kind, random, faces);
      const ContourQuery query{scene, r};
      Contour contour;
      blockers_path.Build(query, contour);
      const Rgb expected = EvaluateContour(query, contour, {}).value;
      const auto expected_by_source = ValuesBySource(query, contour);
      chain_path.Build(query, contour);
      const Rgb actual = EvaluateContour(query, contour, {}).value;
      ASSERT_EQ(ValuesBySource(query, contour), expected_by_source)
          << "seed " << seed << ", receiver " << i;
      ContourQuery joined = query;
      joined.join_sources = true;
      chain_path.Build(joined, contour);
      ASSERT_EQ(EvaluateContour(joined, contour, {}).value, expected)
          << "seed " << seed << ", receiver " << i;
      if (contour.is_joined) ++joined_count;
      ASSERT_EQ(actual, expected) << "seed " << seed << ", receiver " << i;
      if (i == 0) {
        const Rgb plain = EvaluateContour(query, PlainContour(query), {}).value;
        ASSERT_EQ(actual, plain) << "seed " << seed << ", receiver " << i;
      }
      ++(actual[0] > 0 ? lit : dark);
    }
    const ChainCounts& more = chain_path.chain_counts();
    counts.edges += more.edges;
    counts.several += more.several;
    counts.clipped += more.clipped;
    counts.cuts += more.cuts;
    counts.in_plane += more.in_plane;
    counts.borders += more.borders;
    counts.diagonals += more.diagonals;
    counts.touching += more.touching;
    counts.overlaps += more.overlaps;
    counts.wide += more.wide;
    counts.entered += more.entered;
    counts.crossed += more.crossed;
    counts.propagated += more.propagated;
  }
  EXPECT_GT(lit, count / 4);
  EXPECT_GT(dark, 0);
  if (std::string(kind.name) == "CutLamps") {
    EXPECT_GT(joined_count, count);
  }
  for (const auto count_of : kind.must_occur)
    EXPECT_GT(counts.*count_of, 0U);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, PathsAgree,
    ::testing::Values(Kind{"LatticeSoup",
                           400,
                           LatticeSoup,
                           true,
                           {&ChainCounts::several, &ChainCounts::clipped,
                            &ChainCounts::cuts, &ChainCounts::in_plane,
                            &ChainCounts::overlaps, &ChainCounts::entered,
                            &ChainCounts::crossed, &ChainCounts::propagated}},
                      Kind{"GeneralSoup",
                           200,
                           GeneralSoup,
                           false,
                           {&ChainCounts::clipped, &ChainCounts::cuts,
                            &ChainCounts::crossed, &ChainCounts::propagated}},
                      Kind{"NoisyLattice",
                           60,
                           NoisyLattice,
                           true,
                           {&ChainCounts::overlaps, &ChainCounts::wide,
                            &ChainCounts::crossed}},
                      Kind{"Spheres",
                           60,
                           Spheres,
                           false,
                           {&ChainCounts::several, &ChainCounts::borders,
                            &ChainCounts::crossed, &ChainCounts::wide}},
                      Kind{"LargeSpheres",
                           40,
                           LargeSpheres,
                           false,
                           {&ChainCounts::cuts, &ChainCounts::borders,
                            &ChainCounts::propagated}},
                      Kind{"BrokenSpheres",
                           100,
                           BrokenSpheres,
                           false,
                           {&ChainCounts::several, &ChainCounts::borders,
                            &ChainCounts::overlaps}},
                      Kind{"Voxels",
                           100,
                           Voxels,
                           true,
                           {&ChainCounts::in_plane, &ChainCounts::borders,
                            &ChainCounts::diagonals, &ChainCounts::overlaps}},
                      Kind{"BrokenVoxels",
                           100,
                           BrokenVoxels,
                           true,
                           {&ChainCounts::several, &ChainCounts::in_plane,
                            &ChainCounts::diagonals, &ChainCounts::crossed}},
                      Kind{"GlowingVoxels",
                           40,
                           GlowingVoxels,
                           true,
                           {&ChainCounts::in_plane, &ChainCounts::entered}},
                      Kind{"CutLamps",
                           120,
                           CutLamps,
                           true,
                           {&ChainCounts::diagonals, &ChainCounts::touching,
                            &ChainCounts::entered, &ChainCounts::in_plane,
                            &ChainCounts::crossed}},
                      Kind{"FarAway",
                           40,
                           FarAway,
                           true,
                           {&ChainCounts::in_plane, &ChainCounts::overlaps,
                            &ChainCounts::crossed}}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace truelux
