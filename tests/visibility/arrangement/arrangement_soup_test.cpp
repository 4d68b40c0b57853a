// SPDX-License-Identifier: GPL-3.0-or-later
// Random scenes with small integer coordinates, where shared corners, touching
// faces, coplanar overlaps and receivers in special position are common: the
// contour must say the same as exact ray casting.

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "exact/recipe_evaluator.h"
#include "scene/scene_access.h"
#include "support/portable_random.h"
#include "visibility/arrangement/arrangement_engine.h"

namespace truelux {
namespace {

using testing::PortableRandom;
using Evaluator = RecipeEvaluator<Exact>;

Point3 RandomPoint(PortableRandom& random, int range) {
  const auto coordinate = [&] {
    return static_cast<double>(random.Integer(-range, range));
  };
  return {coordinate(), coordinate(), coordinate()};
}

ContourQuery RandomQuery(PortableRandom& random) {
  const int range = random.Integer(2, 5);
  std::vector<Point3> pool;
  for (int i = 0; i < 8; ++i)
    pool.push_back(RandomPoint(random, range));
  SceneBuilder builder;
  const int faces = random.Integer(2, 9);
  for (int i = 0; i < faces; ++i) {
    std::vector<Point3> ring;
    for (int k = 0; k < 3; ++k) {
      ring.push_back(pool[static_cast<std::size_t>(random.Integer(0, 7))]);
    }
    const Point3 a = ring[0];
    const Point3 b = ring[1];
    const Point3 c = ring[2];
    if (random.OneIn(3)) {  // a parallelogram: a facet of two triangles
      ring.insert(ring.begin() + 2,
                  {b.x + c.x - a.x, b.y + c.y - a.y, b.z + c.z - a.z});
    }
    builder.AddFace(ring, random.OneIn(3) ? Rgb{} : Rgb{1, 0, 0});
    if (random.OneIn(4)) {  // the same plane again, shifted
      for (Point3& p : ring) {
        p = {p.x + b.x - a.x, p.y + b.y - a.y, p.z + b.z - a.z};
      }
      builder.AddFace(ring, random.OneIn(2) ? Rgb{0, 2, 0} : Rgb{});
    }
  }
  const Receiver receiver{
      random.OneIn(3) ? pool[0] : RandomPoint(random, range),
      {static_cast<double>(random.Integer(-2, 2)),
       static_cast<double>(random.Integer(-2, 2)),
       random.OneIn(2) ? 1.0 : -0.7},
      0};
  return {*builder.Build().value, receiver};
}

/// A direction towards a random point of a random triangle.
Vec3<Exact> RandomDirection(PortableRandom& random, const ContourQuery& query) {
  const Evaluator exact(ViewOf(query));
  const auto triangles = query.scene.triangles();
  const Triangle& triangle = triangles[static_cast<std::size_t>(
      random.Integer(0, static_cast<int>(triangles.size()) - 1))];
  Vec3<Exact> direction{0, 0, 0};
  for (const VertexId v : CornersOf(triangle)) {
    direction =
        direction - Exact(-random.Integer(1, 99)) * exact.FromReceiver(v);
  }
  return direction;
}

enum class Hit { kMiss, kInside, kBoundary };

/// Where direction d meets the cone of a triangle, corners relative to r.
Hit HitOf(const std::array<Vec3<Exact>, 3>& corners, const Vec3<Exact>& d) {
  const Sign whole = SignOf(Determinant(corners[0], corners[1], corners[2]));
  Hit hit = Hit::kInside;
  for (std::size_t k = 0; k < 3; ++k) {
    const Sign side =
        SignOf(Determinant(corners[k], corners[(k + 1) % 3], d)) * whole;
    if (side == Sign::kNegative) return Hit::kMiss;
    if (side == Sign::kZero) hit = Hit::kBoundary;
  }
  return hit;
}

/// The facet that is seen along d: -1 is none, nothing if d meets an edge.
std::optional<int> FacetAlong(const ContourQuery& query, const Vec3<Exact>& d) {
  const Evaluator exact(ViewOf(query));
  int front = -1;
  Exact front_height;
  Exact front_slope;
  for (const TriangleId t : TrianglesOf(query.scene).ids()) {
    const Triangle& triangle = TrianglesOf(query.scene)[t];
    Exact height = exact.Height(t);
    if (height.is_zero()) continue;
    const auto [a, b, c] = CornersOf(triangle);
    const Hit hit = HitOf(
        {exact.FromReceiver(a), exact.FromReceiver(b), exact.FromReceiver(c)},
        d);
    if (hit == Hit::kMiss) continue;
    if (hit == Hit::kBoundary) return std::nullopt;
    // The distance is height / slope; both are made positive.
    Exact slope = Dot(exact.TriangleNormal(t), d);
    if (SignOf(height) == Sign::kNegative) {
      height = -height;
      slope = -slope;
    }
    const Sign nearer = SignOf(slope * front_height - front_slope * height);
    // Triangles come in file order: of equals the first stays.
    if (front < 0 || nearer == Sign::kPositive) {
      front = triangle.facet;
      front_height = height;
      front_slope = slope;
    }
  }
  return front;
}

struct ExactArc {
  Vec3<Exact> inward;
  Vec3<Exact> from;
  Vec3<Exact> to;
};

std::vector<ExactArc> ArcsOf(const ContourQuery& query, const Contour& contour,
                             const SourceArcs& source) {
  const Evaluator exact(ViewOf(query));
  const auto direction = [&](DirectionId id) {
    return exact.Direction(contour.directions[id], contour.planes,
                           contour.explicit_vectors.All());
  };
  std::vector<ExactArc> arcs;
  for (const Arc& arc : contour.ArcsOf(source)) {
    const Vec3<Exact> normal =
        exact.Plane(contour.planes[arc.plane], contour.explicit_vectors.All());
    arcs.push_back({arc.positive ? normal : -normal, direction(arc.from),
                    direction(arc.to)});
  }
  return arcs;
}

/// How often the arcs go around d: 1 inside a region they bound, 0 outside.
/// Counts the arcs that the way from d to the point a on the horizon meets.
std::optional<int> WindingAround(const std::vector<ExactArc>& arcs,
                                 const Vec3<Exact>& d, const Vec3<Exact>& a) {
  const Vec3<Exact> way = Cross(d, a);
  int winding = 0;
  for (const ExactArc& arc : arcs) {
    const Exact side_from = Dot(way, arc.from);
    const Exact side_to = Dot(way, arc.to);
    const bool from_left = SignOf(side_from) != Sign::kNegative;
    const bool to_left = SignOf(side_to) != Sign::kNegative;
    if (from_left == to_left) continue;
    // Inside the arc, in the plane of the way.
    Vec3<Exact> meeting = side_from * arc.to - side_to * arc.from;
    if (!from_left) meeting = -meeting;
    const Sign ahead = SignOf(Dot(Cross(d, meeting), way));
    if (ahead == Sign::kZero) return std::nullopt;
    if (ahead == Sign::kNegative) continue;
    winding += SignOf(Dot(arc.inward, d)) == Sign::kPositive ? 1 : -1;
  }
  return winding;
}

bool SameDirection(const Vec3<Exact>& a, const Vec3<Exact>& b) {
  const Vec3<Exact> cross = Cross(a, b);
  return cross.x.is_zero() && cross.y.is_zero() && cross.z.is_zero() &&
         SignOf(Dot(a, b)) == Sign::kPositive;
}

bool IsSource(const ContourQuery& query, int facet) {
  const Facet& f = query.scene.facets()[static_cast<std::size_t>(facet)];
  const Rgb& m = query.scene.faces()[static_cast<std::size_t>(f.face)].emission;
  const Evaluator exact(ViewOf(query));
  return m != Rgb{} &&
         SignOf(exact.Height(FirstTriangleOf(f))) == Sign::kNegative;
}

TEST(ArrangementSoup, ArcsRunInTheirPlanesWithTheVisibleSideLeft) {
  PortableRandom random(11);
  std::size_t count = 0;
  for (int i = 0; i < 100; ++i) {
    const ContourQuery query = RandomQuery(random);
    const Contour contour = ContourByArrangement(query);
    const Vec3<Exact> n = Evaluator(ViewOf(query)).ReceiverNormal();
    for (const SourceArcs& source : contour.sources) {
      for (const ExactArc& arc : ArcsOf(query, contour, source)) {
        EXPECT_TRUE(Dot(arc.inward, arc.from).is_zero());
        EXPECT_TRUE(Dot(arc.inward, arc.to).is_zero());
        EXPECT_EQ(SignOf(Dot(Cross(arc.from, arc.to), arc.inward)),
                  Sign::kPositive);
        EXPECT_NE(SignOf(Dot(n, arc.from)), Sign::kNegative);
        EXPECT_NE(SignOf(Dot(n, arc.to)), Sign::kNegative);
        ++count;
      }
    }
    EXPECT_EQ(contour.statistics.arcs, contour.arcs.size());
  }
  EXPECT_GT(count, 500U);
}

TEST(ArrangementSoup, AsManyArcsEndInADirectionAsStartThere) {
  PortableRandom random(12);
  int directions = 0;
  for (int i = 0; i < 100; ++i) {
    const ContourQuery query = RandomQuery(random);
    const Contour contour = ContourByArrangement(query);
    for (const SourceArcs& source : contour.sources) {
      const std::vector<ExactArc> arcs = ArcsOf(query, contour, source);
      for (const ExactArc& arc : arcs) {
        int balance = 0;
        for (const ExactArc& other : arcs) {
          balance += SameDirection(arc.from, other.from) ? 1 : 0;
          balance -= SameDirection(arc.from, other.to) ? 1 : 0;
        }
        EXPECT_EQ(balance, 0);
        ++directions;
      }
    }
  }
  EXPECT_GT(directions, 200);
}

TEST(ArrangementSoup, ADirectionIsInAContourIfARayMeetsThatSourceFirst) {
  PortableRandom random(13);
  int seen = 0;
  int unseen = 0;
  for (int i = 0; i < 150; ++i) {
    const ContourQuery query = RandomQuery(random);
    if (query.scene.triangles().empty()) continue;
    const Contour contour = ContourByArrangement(query);
    const Vector3& n = query.receiver.normal;
    const Vec3<Exact> normal{n.x, n.y, n.z};
    // Along the horizon; the middle of a chart, not one of its cuts.
    const Vec3<Exact> horizon{n.z, n.z, -Exact(n.x) - Exact(n.y)};
    std::vector<std::vector<ExactArc>> arcs(query.scene.facets().size());
    for (const SourceArcs& source : contour.sources)
      arcs[source.facet.index()] = ArcsOf(query, contour, source);
    for (int k = 0; k < 40; ++k) {
      const Vec3<Exact> d = RandomDirection(random, query);
      if (SignOf(Dot(normal, d)) != Sign::kPositive) continue;
      const std::optional<int> front = FacetAlong(query, d);
      if (!front) continue;
      for (std::size_t f = 0; f < arcs.size(); ++f) {
        if (!IsSource(query, static_cast<int>(f))) {
          EXPECT_TRUE(arcs[f].empty());
          continue;
        }
        const bool expected =
            *front == static_cast<int>(f) && IsSource(query, *front);
        const std::optional<int> winding = WindingAround(arcs[f], d, horizon);
        if (!winding) continue;  // d lies on a cut
        EXPECT_EQ(*winding, expected ? 1 : 0) << "scene " << i;
        (expected ? seen : unseen) += 1;
      }
    }
  }
  EXPECT_GT(seen, 500);
  EXPECT_GT(unseen, 1000);
}

}  // namespace
}  // namespace truelux
