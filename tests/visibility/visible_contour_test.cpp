// SPDX-License-Identifier: GPL-3.0-or-later
// The public contour: which vertices there are, of which kind, and that arcs
// and vertices fit together.

#include <algorithm>

#include <gtest/gtest.h>

#include "truelux/irradiance.h"

#include "support/scenes.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

const Ring kSource = Ceiling(-4, 4, -4, 4, 8);

VisibleContour Look(const std::vector<TestFace>& faces,
                    Engine engine = Engine::kContour) {
  return Oracle(MakeScene(faces), {.engine = engine})
      .Contour({{0, 0, 0}, {0, 0, 1}, 0});
}

int Count(const VisibleContour& contour, VertexKind kind, bool conjunctive) {
  return static_cast<int>(
      std::ranges::count_if(contour.vertices, [&](const ContourVertex& v) {
        return v.kind == kind && v.conjunctive == conjunctive;
      }));
}

TEST(VisibleContour, OfALoneSquareHasFourIntrinsicVertices) {
  const VisibleContour c = Look({{kSource, kLamp}});
  EXPECT_EQ(c.arcs.size(), 4U);
  EXPECT_EQ(Count(c, VertexKind::kIntrinsic, false), 4);
  EXPECT_EQ(c.vertices.size(), 4U);
  for (const ContourArc& arc : c.arcs) {
    EXPECT_EQ(arc.source, 1);
    EXPECT_EQ(arc.edge_face, 1);
  }
  for (const ContourVertex& v : c.vertices) {
    EXPECT_EQ(v.planes, 2);
    EXPECT_GE(v.vertex, 0);
    EXPECT_EQ(std::abs(v.direction.z), 1);
    EXPECT_EQ(std::abs(v.direction.x), 0.5);
  }
}

TEST(VisibleContour, ArcsKeepTheVisibleSideOnTheLeft) {
  const VisibleContour c = Look({{kSource, kLamp}, {Ceiling(0, 1, 0, 1, 4)}});
  ASSERT_EQ(c.arcs.size(), 8U);
  for (const ContourArc& arc : c.arcs) {
    const Vector3& a = c.vertices[static_cast<std::size_t>(arc.from)].direction;
    const Vector3& b = c.vertices[static_cast<std::size_t>(arc.to)].direction;
    const Vector3& n = arc.plane_normal;
    EXPECT_GT((a.y * b.z - a.z * b.y) * n.x + (a.z * b.x - a.x * b.z) * n.y +
                  (a.x * b.y - a.y * b.x) * n.z,
              0);
    // (-1, -1, 4), seen, is on that side of every arc of the outer border;
    // the inner border turns its back to the blocker's middle.
    const double out = arc.edge_face == 1 ? 1 : -1;
    const Vector3 p =
        arc.edge_face == 1 ? Vector3{-1, -1, 8} : Vector3{0.5, 0.5, 4};
    EXPECT_GT(out * (p.x * n.x + p.y * n.y + p.z * n.z), 0);
  }
}

TEST(VisibleContour, EdgesThatCrossInTheImageMakeApparentVertices) {
  // Across the border of the source.
  const VisibleContour c = Look({{kSource, kLamp}, {Ceiling(1, 9, -1, 1, 4)}});
  EXPECT_EQ(Count(c, VertexKind::kApparent, false), 2);
  EXPECT_EQ(Count(c, VertexKind::kIntrinsic, false), 6);
  EXPECT_EQ(Count(c, VertexKind::kApparent, true), 0);
}

TEST(VisibleContour, ThreeEdgesThroughOnePointMakeItConjunctive) {
  const Ring a = {{1, 1, 4}, {-1, -1, 4}, {1, -1, 4}};
  const Ring b = {{1, -0.5, 2}, {-1, 0.5, 2}, {-1, -0.5, 2}};
  const Ring c = {{0, 0.25, 1}, {0, -0.25, 1}, {0.25, -0.25, 1}};
  const VisibleContour two = Look({{kSource, kLamp}, {a}, {b}});
  const VisibleContour three = Look({{kSource, kLamp}, {a}, {b}, {c}});
  const auto at_zenith = [](const VisibleContour& contour) {
    return *std::ranges::find_if(contour.vertices, [](const ContourVertex& v) {
      return v.direction.x == 0 && v.direction.y == 0;
    });
  };
  EXPECT_EQ(at_zenith(two).kind, VertexKind::kApparent);
  EXPECT_FALSE(at_zenith(two).conjunctive);
  EXPECT_EQ(at_zenith(two).planes, 2);
  EXPECT_TRUE(at_zenith(three).conjunctive);
  EXPECT_EQ(at_zenith(three).planes, 3);
}

TEST(VisibleContour, EdgeThroughASceneVertexMakesItConjunctive) {
  const Ring through = {{-1, -1, 4}, {4, 4, 4}, {4, -4, 4}};
  const VisibleContour c = Look({{kSource, kLamp}, {through}});
  EXPECT_EQ(Count(c, VertexKind::kIntrinsic, true), 1);
}

TEST(VisibleContour, TwoSceneVerticesInLineAreConjunctive) {
  const Ring corner = {{2, 2, 4}, {1, 0, 4}, {0, 1, 4}};
  const VisibleContour c = Look({{kSource, kLamp}, {corner}});
  EXPECT_EQ(Count(c, VertexKind::kIntrinsic, true), 1);
}

TEST(VisibleContour, ManyEdgesThatEndAtOneSceneVertexAreNoConjunction) {
  // A fan of blockers around one vertex: all meet there, nothing else does.
  const Point3 tip = {0, 0, 4};
  const VisibleContour c = Look({{kSource, kLamp},
                                 {{tip, {2, 1, 5}, {2, -1, 5}}},
                                 {{tip, {-1, 2, 5}, {1, 2, 5}}},
                                 {{tip, {-1, -3, 5}, {-3, -1, 5}}}});
  EXPECT_EQ(Count(c, VertexKind::kIntrinsic, true), 0);
  const auto top = std::ranges::find_if(c.vertices, [](const auto& v) {
    return v.direction.x == 0 && v.direction.y == 0;
  });
  ASSERT_NE(top, c.vertices.end());
  EXPECT_EQ(top->planes, 6);
}

TEST(VisibleContour, InnerEdgesAreNotCounted) {
  // Two triangles of a blocking mesh: at (0, 1, 4) their common edge ends.
  const Ring left = {{-1, -1, 4}, {-1, 1, 4}, {0, 1, 4}};
  const Ring right = {{-1, -1, 4}, {0, 1, 4}, {0.5, -1, 4}};
  const VisibleContour c = Look({{kSource, kLamp}, {left}, {right}});
  const auto end = std::ranges::find_if(c.vertices, [](const auto& v) {
    return v.direction == Vector3{0, 0.25, 1};
  });
  ASSERT_NE(end, c.vertices.end());
  EXPECT_EQ(end->planes, 2);
  EXPECT_FALSE(end->conjunctive);
}

TEST(VisibleContour, HorizonPointsAreKnown) {
  const Ring wall = {{2, -1, -3}, {2, -1, 3}, {2, 1, 3}, {2, 1, -3}};
  const VisibleContour c = Look({{wall, kLamp}});
  EXPECT_EQ(c.arcs.size(), 4U);
  EXPECT_EQ(Count(c, VertexKind::kHorizon, false), 2);
  EXPECT_EQ(Count(c, VertexKind::kIntrinsic, false), 2);
  EXPECT_EQ(std::ranges::count(c.arcs, 0, &ContourArc::edge_face), 1);
  // A vertex exactly on the horizon is both.
  const Ring on = {{2, -1, 0}, {2, 0, 2}, {2, 1, 0}};
  EXPECT_EQ(Count(Look({{Reversed(on), kLamp}}), VertexKind::kIntrinsic, true) +
                Count(Look({{on, kLamp}}), VertexKind::kIntrinsic, true),
            2);
}

TEST(VisibleContour, HasTheSameVerticesAndArcsFromBothEngines) {
  // All four charts of the arrangement see the source; its cuts must not show.
  const Ring bent = {{-3, -3, 6}, {-3, 3, 6}, {2, 3, 6}, {3, -3, 5}};
  const std::vector<std::vector<TestFace>> scenes = {
      {{Ceiling(-1, 2, -3, 1, 4), kLamp}},
      {{kSource, kLamp},
       {{{-2, -2, 4}, {4, 4, 4}, {4, -4, 4}}},
       {Ceiling(-1, 0.25, -0.5, 0.5, 2)}},
      {{bent, kLamp}, {Ceiling(0, 1, -9, 0, 3)}}};
  for (const std::vector<TestFace>& faces : scenes) {
    const VisibleContour a = Look(faces);
    const VisibleContour b = Look(faces, Engine::kArrangement);
    EXPECT_GE(a.arcs.size(), 4U);
    EXPECT_EQ(a.arcs.size(), b.arcs.size());
    ASSERT_EQ(a.vertices.size(), b.vertices.size());
    for (const ContourVertex& v : a.vertices) {
      const bool found = std::ranges::any_of(b.vertices, [&v](const auto& w) {
        return w.direction == v.direction && w.kind == v.kind &&
               w.conjunctive == v.conjunctive && w.planes == v.planes;
      });
      EXPECT_TRUE(found);
    }
  }
}

}  // namespace
}  // namespace truelux
