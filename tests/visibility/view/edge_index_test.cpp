// SPDX-License-Identifier: GPL-3.0-or-later
// The edges through directions of random scenes, against their slow twin: on
// lattices (everything coincides), with shared vertices and edges, the same
// with one-ulp noise (everything almost coincides), and in general position.
//
// TRUELUX_LONG_TEST=N makes N scenes of each kind instead of the usual few.

#include "visibility/view/edge_index.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "exact/exact_conversion.h"
#include "support/plain_edges.h"
#include "support/random_scene.h"
#include "visibility/view/edges_at.h"
#include "visibility/view/nearest_edge.h"
#include "visibility/view/relevant_triangles.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

enum class Kind { kLattice, kShared, kNoise, kGeneral };

std::size_t Index(int i) {
  return static_cast<std::size_t>(i);
}

int SceneCount() {
  const char* text = std::getenv("TRUELUX_LONG_TEST");
  return text != nullptr ? std::stoi(text) : 12;
}

/// Triangles between a few points, so that many edges have several triangles.
std::vector<TestFace> SharedScene(PortableRandom& random, int count) {
  std::vector<Point3> points;
  for (int i = 0; i < 7; ++i)
    points.push_back(RandomPoint(random, true, 2));
  std::vector<TestFace> faces;
  const auto pick = [&] { return points[Index(random.Integer(0, 6))]; };
  while (static_cast<int>(faces.size()) < count) {
    const Ring ring = {pick(), pick(), pick()};
    if (OnOneLine(ring[0], ring[1], ring[2])) continue;
    faces.push_back({ring, random.OneIn(2) ? kLamp : kBlack});
  }
  return faces;
}

std::vector<TestFace> SceneOf(PortableRandom& random, Kind kind) {
  const int count = random.Integer(2, 8);
  const bool is_shared =
      kind == Kind::kShared || (kind == Kind::kNoise && random.OneIn(2));
  std::vector<TestFace> faces =
      is_shared ? SharedScene(random, count)
                : RandomScene(random, kind != Kind::kGeneral, count, 2);
  if (kind != Kind::kNoise) return faces;
  for (TestFace& face : faces) {
    face.ring.resize(3);  // noise would bend a quad
    for (Point3& p : face.ring)
      p = {random.Nudge(p.x), random.Nudge(p.y), random.Nudge(p.z)};
  }
  return faces;
}

RationalVector RationalOf(const Vec3<Exact>& v) {
  return {truelux::RationalOf(v.x), truelux::RationalOf(v.y),
          truelux::RationalOf(v.z)};
}

std::set<PlainHit> Plain(const std::vector<EdgeHit>& hits) {
  std::set<PlainHit> plain;
  for (const EdgeHit& hit : hits)
    plain.insert(PlainHitOf(hit));
  return plain;
}

/// Where something could be: vertices, points of edges, edges that cross as
/// seen from r, edges that pass through faces; and anywhere.
class Directions {
 public:
  Directions(const EdgeIndex& index, PortableRandom& random)
      : index_(index), random_(random) {}

  std::optional<Vec3<Exact>> Next() {
    if (index_.edges().size() == 0) return std::nullopt;
    const Segment s = index_.SegmentOf(AnyEdge());
    const Vec3<Exact> a = index_.exact().FromReceiver(s.a);
    const Vec3<Exact> b = index_.exact().FromReceiver(s.b);
    switch (random_.Integer(0, 9)) {
      case 0:
        return a;
      case 1:
        return Between(a, random_.Integer(1, 7), b);
      case 2:
        return Vec3<Exact>{Exact(random_.Uniform(-1, 1)),
                           Exact(random_.Uniform(-1, 1)),
                           Exact(random_.Uniform(-1, 1))};
      case 3:
      case 4:
      case 5:
        return PassingOf(s);
      default:
        return CrossingOf(s, a, b);
    }
  }

 private:
  SceneEdgeId AnyEdge() {
    return SceneEdgeId(random_.Integer(0, index_.edges().size() - 1));
  }

  static Vec3<Exact> Between(const Vec3<Exact>& a, int part,
                             const Vec3<Exact>& b) {
    const Vec3<Exact> way = Exact(part) * (a - b);
    return Exact(8) * a - way;
  }

  /// Where the edge crosses the plane of a random triangle.
  std::optional<Vec3<Exact>> PassingOf(const Segment& s) {
    const auto triangles = index_.triangles();
    const TriangleId t = triangles[Index(
        random_.Integer(0, static_cast<int>(triangles.size()) - 1))];
    const RecipeEvaluator<Exact>& exact = index_.exact();
    const Exact at_a = exact.AboveTriangle(t, s.a);
    const Exact at_b = exact.AboveTriangle(t, s.b);
    if (SignOf(at_a) * SignOf(at_b) != Sign::kNegative) return std::nullopt;
    const Vec3<Exact> d =
        at_a * exact.FromReceiver(s.b) - at_b * exact.FromReceiver(s.a);
    return SignOf(at_a) == Sign::kPositive ? d : -d;
  }

  /// Where the edge, from a to b, crosses a random other one.
  std::optional<Vec3<Exact>> CrossingOf(const Segment& s, const Vec3<Exact>& a,
                                        const Vec3<Exact>& b) {
    for (int tries = 0; tries < 20; ++tries) {
      const Segment t = index_.SegmentOf(AnyEdge());
      if (t.edge == s.edge) continue;
      const Vec3<Exact> u = index_.exact().FromReceiver(t.a);
      const Vec3<Exact> v = index_.exact().FromReceiver(t.b);
      const Vec3<Exact> d = Cross(Cross(a, b), Cross(u, v));
      if (Dot(d, d).is_zero()) continue;
      for (const Vec3<Exact>& way : {d, -d}) {
        if (PointOnArc(a, b, way) && PointOnArc(u, v, way)) return way;
      }
    }
    return std::nullopt;
  }

  const EdgeIndex& index_;
  PortableRandom& random_;
};

/// What was looked at, so that a test that sees nothing does not pass.
struct Counts {
  int hits = 0;
  int cuts = 0;
  int conjunctions = 0;  ///< three edges or more
  int inner = 0;         ///< edges there that do not bound the source
  int near = 0;
};

class EdgesOf : public ::testing::TestWithParam<Kind> {
 protected:
  /// Compares everything about one direction.
  void Compare(const ContourQuery& query, const EdgeIndex& index,
               const Vec3<Exact>& d) {
    const PlainEdges plain(query);
    const RationalVector rational = RationalOf(d);
    const EdgesAt at(index, d);
    const auto everything = Plain(at.NotBehind(FacetId()));
    EXPECT_EQ(everything, plain.NotBehind(-1, rational));
    const int facets = static_cast<int>(query.scene.facets().size());
    for (int facet = 0; facet < facets; ++facet) {
      if (!plain.TakesPart(facet)) continue;
      const auto of_source = Plain(at.OfSource(FacetId(facet)));
      EXPECT_EQ(of_source, plain.OfSource(facet, rational, NamedBy::kView));
      Count(everything, of_source);
      if (!plain.Meets(facet, rational)) continue;
      EXPECT_EQ(Plain(at.NotBehind(FacetId(facet))),
                plain.NotBehind(facet, rational));
      CompareOfSource(query, facet, d, plain);
    }
  }

  void Count(const std::set<PlainHit>& everything,
             const std::set<PlainHit>& of_source) {
    for (const PlainHit& hit : of_source) {
      ++counts.hits;
      counts.cuts += hit.edge.a < 0 ? 1 : 0;
    }
    counts.conjunctions += of_source.size() > 2 ? 1 : 0;
    for (const PlainHit& hit : everything)
      counts.inner += of_source.contains(hit) ? 0 : 1;
  }

  /// The same by the index of one source alone, and the nearest edge.
  void CompareOfSource(const ContourQuery& query, int facet,
                       const Vec3<Exact>& d, const PlainEdges& plain) {
    const RationalVector rational = RationalOf(d);
    const FacetFront source(query, FacetId(facet));
    const EdgeIndex index(query, TrianglesOfSource(query, source));
    EXPECT_EQ(Plain(EdgesAt(index, d).OfSource(FacetId(facet))),
              plain.OfSource(facet, rational, NamedBy::kSource));
    const auto nearest = NearestEdge(index, source).To(d);
    // A segment that passes behind the source is measured by its ends.
    if (plain.PassesBehind(facet, rational)) return;
    const auto angle = plain.NearestAngle(facet, rational);
    ASSERT_TRUE(angle.has_value());
    // A miss by less than the rounding of directions may be passed over.
    if (*angle < 1e-15 && (!nearest || nearest->angle > 1e-12)) return;
    // Edges that are farther away may be left out.
    const double reach = kBesideSource * 0.99;
    if (!nearest || *angle > reach) {
      EXPECT_GT(*angle, reach);
      EXPECT_TRUE(!nearest || nearest->angle > reach);
      return;
    }
    ++counts.near;
    EXPECT_GT(nearest->angle, 0);
    // Below that, the directions to vertices are too coarse.
    if (std::max(nearest->angle, *angle) > 1e-12) {
      EXPECT_NEAR(nearest->angle, *angle, 1e-3 * *angle);
    }
  }

  Counts counts;
};

TEST_P(EdgesOf, DirectionsAreThoseOfTheSlowTwin) {
  for (int seed = 0; seed < SceneCount(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    PortableRandom random(static_cast<std::uint64_t>(seed) * 4 +
                          static_cast<std::uint64_t>(GetParam()));
    const auto faces = SceneOf(random, GetParam());
    Receiver receiver = RandomReceiver(random, GetParam() != Kind::kGeneral, 2);
    if (random.OneIn(4))
      receiver.on_face = random.Integer(1, static_cast<int>(faces.size()));
    const ContourQuery query{MakeScene(faces), receiver};
    const EdgeIndex index(query, RelevantTriangles(query));
    Directions directions(index, random);
    for (int i = 0; i < 30; ++i) {
      const auto d = directions.Next();
      if (d && !Dot(*d, *d).is_zero()) Compare(query, index, *d);
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(counts.hits, 20 * SceneCount());
  EXPECT_GT(counts.inner, 20 * SceneCount());
  EXPECT_GT(counts.cuts, SceneCount());
  if (GetParam() == Kind::kLattice || GetParam() == Kind::kShared) {
    EXPECT_GT(counts.conjunctions, 2 * SceneCount());
  }
  if (GetParam() == Kind::kNoise) {
    EXPECT_GT(counts.near, SceneCount());
  }
}

std::string NameOfKind(const ::testing::TestParamInfo<Kind>& kind) {
  switch (kind.param) {
    case Kind::kLattice:
      return "Lattice";
    case Kind::kShared:
      return "Shared";
    case Kind::kNoise:
      return "Noise";
    case Kind::kGeneral:
      break;
  }
  return "General";
}

INSTANTIATE_TEST_SUITE_P(Random, EdgesOf,
                         ::testing::Values(Kind::kLattice, Kind::kShared,
                                           Kind::kNoise, Kind::kGeneral),
                         NameOfKind);

}  // namespace
}  // namespace truelux
