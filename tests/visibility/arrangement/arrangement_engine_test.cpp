// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/arrangement/arrangement_engine.h"

#include <cmath>
#include <cstddef>
#include <future>
#include <vector>

#include <CGAL/Gmpq.h>
#include <mpfr.h>

#include <gtest/gtest.h>

#include "exact/recipe_evaluator.h"
#include "support/real.h"

namespace truelux {
namespace {

using Ring = std::vector<Point3>;
using Real = testing::ShortReal;

const Rgb kLamp = {1, 1, 1};
const Rgb kBlack = {0, 0, 0};

struct TestFace {
  Ring ring;
  Rgb emission;
};

ContourQuery Query(const std::vector<TestFace>& faces,
                   const Receiver& receiver = {{0, 0, 0}, {0, 0, 1}, 0},
                   FaceNumber only_source = {}) {
  SceneBuilder builder;
  for (const TestFace& face : faces)
    builder.AddFace(face.ring, face.emission);
  Result<Scene> scene = builder.Build();
  for (const Diagnostic& d : scene.diagnostics) {
    EXPECT_EQ(d.severity, Severity::kNote) << d.Text();
  }
  return {*scene.value, receiver, only_source};
}

Ring Reversed(const Ring& ring) {
  return {ring.rbegin(), ring.rend()};
}

/// [x0, x1] x [y0, y1] at height z, its front below.
Ring Ceiling(double x0, double x1, double y0, double y1, double z) {
  return {{x0, y0, z}, {x0, y1, z}, {x1, y1, z}, {x1, y0, z}};
}

Real RealOf(const Exact& x) {
  Real r;
  const auto rational = static_cast<CGAL::Gmpq>(x);
  mpfr_set_q(r.get(), rational.mpq(), MPFR_RNDN);
  return r;
}

Real Length(const Vec3<Exact>& v) {
  return Sqrt(RealOf(Dot(v, v)));
}

/// Lambert's sum over the arcs, each source with M = 1: E = 1/(2 pi) sum of
/// the arc's angle times the cosine between n and the inward normal.
double FormFactorOf(const ContourQuery& query, const Contour& contour) {
  const RecipeEvaluator<Exact> exact(ViewOf(query));
  const auto direction = [&](DirectionId id) {
    return exact.Direction(contour.directions[id], contour.planes,
                           contour.explicit_vectors.All());
  };
  const Vec3<Exact> n = exact.ReceiverNormal();
  Real sum;
  for (const Arc& arc : contour.arcs) {
    Vec3<Exact> inward =
        exact.Plane(contour.planes[arc.plane], contour.explicit_vectors.All());
    if (!arc.positive) inward = -inward;
    const Vec3<Exact> from = direction(arc.from);
    const Vec3<Exact> to = direction(arc.to);
    const Real angle = Atan2(Length(Cross(from, to)), RealOf(Dot(from, to)));
    sum = sum + angle * RealOf(Dot(n, inward)) / (Length(n) * Length(inward));
  }
  return (sum / (Real(2) * Real::Pi())).ToDouble();
}

double FormFactorOf(const ContourQuery& query) {
  return FormFactorOf(query, ContourByArrangement(query));
}

double FormFactorOf(const std::vector<TestFace>& faces) {
  return FormFactorOf(Query(faces));
}

/// A rectangle [0, a] x [0, b] at height 1, seen from below its corner.
double CornerFormFactor(double a, double b) {
  const double u = std::hypot(a, 1);
  const double v = std::hypot(b, 1);
  return (a / u * std::atan(b / u) + b / v * std::atan(a / v)) /
         (2 * 3.14159265358979323846);
}

/// Distinct planes of the arcs on the edges of a face; 0: walls of the charts.
int PlanesOn(const Contour& contour, FaceNumber edge_face) {
  std::vector<Vec3<Exact>> planes;
  for (const Arc& arc : contour.arcs) {
    if (arc.edge_face != edge_face) continue;
    const auto& plane =
        contour.explicit_vectors[contour.planes[arc.plane].explicit_vector()];
    bool is_new = true;
    for (const Vec3<Exact>& other : planes) {
      const Vec3<Exact> cross = Cross(plane, other);
      is_new = is_new &&
               !(cross.x.is_zero() && cross.y.is_zero() && cross.z.is_zero());
    }
    if (is_new) planes.push_back(plane);
  }
  return static_cast<int>(planes.size());
}

TEST(ArrangementEngine, ALoneSquareIsBoundedByItsFourEdges) {
  const ContourQuery query = Query({{Ceiling(-2, 3, -1, 4, 1), kLamp}});
  const Contour contour = ContourByArrangement(query);
  EXPECT_EQ(PlanesOn(contour, FaceNumber(1)), 4);
  EXPECT_EQ(PlanesOn(contour, FaceNumber(0)),
            2);  // the cuts between the charts
  ASSERT_EQ(contour.sources.size(), 1U);
  EXPECT_EQ(contour.statistics.sources, 1U);
  EXPECT_EQ(contour.statistics.arcs, contour.arcs.size());
  EXPECT_NEAR(FormFactorOf(query, contour),
              CornerFormFactor(2, 1) + CornerFormFactor(2, 4) +
                  CornerFormFactor(3, 1) + CornerFormFactor(3, 4),
              1e-15);
}

TEST(ArrangementEngine, LengthOfTheNormalDoesNotMatter) {
  const std::vector<TestFace> faces = {{Ceiling(-2, 3, -1, 4, 1), kLamp}};
  const double expected = FormFactorOf(faces);
  for (const double length : {3.0, 1e-300, 5e-324, 1e308}) {
    const Receiver receiver{{0, 0, 0}, {0, 0, length}, 0};
    EXPECT_EQ(FormFactorOf(Query(faces, receiver)), expected) << length;
  }
}

TEST(ArrangementEngine, AClosedRoomFillsTheHemisphere) {
  const Ring floor = Reversed(Ceiling(-1, 2, -3, 2, -1));
  const Ring ceiling = Ceiling(-1, 2, -3, 2, 4);
  std::vector<TestFace> room = {{floor, kLamp}, {ceiling, kLamp}};
  for (std::size_t i = 0; i < 4; ++i) {
    // floor runs against ceiling: corner 3 - i of it is below corner i.
    const std::size_t next = (i + 1) % 4;
    room.push_back(
        {{ceiling[i], floor[3 - i], floor[3 - next], ceiling[next]}, kLamp});
  }
  for (const Vector3& normal : {Vector3{0, 0, 1}, Vector3{1, 0, 0},
                                Vector3{-1, 2, -5}, Vector3{0.1, 0.7, 0.3}}) {
    const Receiver receiver{{0, 0.5, 0}, normal, 0};
    EXPECT_NEAR(FormFactorOf(Query(room, receiver)), 1, 1e-15);
  }
}

TEST(ArrangementEngine, AScaledCopyHidesTheSourceExactly) {
  // 3 p - 2 r is exact; the copy covers neither more nor less.
  const Ring near = {{0.1, 0.7, 1.3}, {0.9, -0.3, 1.1}, {-0.7, -0.6, 1.7}};
  Ring far;
  for (const Point3& p : near)
    far.push_back({16 * p.x, 16 * p.y, 16 * p.z});
  for (const Ring& copy : {near, Reversed(near)}) {
    for (const Ring& source : {far, Reversed(far)}) {
      const ContourQuery query = Query({{source, kLamp}, {copy, kBlack}});
      const Contour contour = ContourByArrangement(query);
      EXPECT_TRUE(contour.arcs.empty());
      EXPECT_TRUE(contour.sources.empty());
    }
  }
}

TEST(ArrangementEngine, VisibleAndHiddenAddUp) {
  const Ring source = Ceiling(-4, 4, -4, 4, 4);
  const Ring blocker = Ceiling(-1, 1, -1, 0.5, 2);  // its image is inside
  const double whole = FormFactorOf({{source, kLamp}});
  const double hidden = FormFactorOf({{blocker, kLamp}});
  const ContourQuery query = Query({{source, kLamp}, {blocker, kBlack}});
  const Contour contour = ContourByArrangement(query);
  EXPECT_NEAR(FormFactorOf(query, contour), whole - hidden, 1e-15);
  EXPECT_EQ(PlanesOn(contour, FaceNumber(1)), 4);
  EXPECT_EQ(PlanesOn(contour, FaceNumber(2)), 4);
}

TEST(ArrangementEngine, OnlyThePartInFrontOfTheSourceHides) {
  const Ring source = Ceiling(-4, 4, -4, 4, 2);
  // Pierces the source's plane in the line x = 1.
  const Ring whole = {{0.25, -1, 1}, {1.75, -1, 3}, {1.75, 1, 3}, {0.25, 1, 1}};
  const Ring front = {{0.25, -1, 1}, {1, -1, 2}, {1, 1, 2}, {0.25, 1, 1}};
  const ContourQuery query = Query({{source, kLamp}, {whole, kBlack}});
  const Contour contour = ContourByArrangement(query);
  const double expected = FormFactorOf({{source, kLamp}, {front, kBlack}});
  EXPECT_NEAR(FormFactorOf(query, contour), expected, 1e-15);
  EXPECT_LT(expected, FormFactorOf({{source, kLamp}}) - 1e-3);
  // Three edges of the blocker and the line where it enters.
  EXPECT_EQ(PlanesOn(contour, FaceNumber(2)), 4);
}

TEST(ArrangementEngine, StripsMayHideEachOtherInACycle) {
  // Each strip rises to the right of its neighbour's low end.
  const std::vector<Ring> strips = {
      {{-3, -2, 2}, {-3, -1, 2}, {3, -1, 4}, {3, -2, 4}},
      {{2, -3, 2}, {1, -3, 2}, {1, 3, 4}, {2, 3, 4}},
      {{3, 2, 2}, {3, 1, 2}, {-3, 1, 4}, {-3, 2, 4}},
      {{-2, 3, 2}, {-1, 3, 2}, {-1, -3, 4}, {-2, -3, 4}}};
  std::vector<TestFace> faces;
  for (const Ring& ring : strips)
    faces.push_back({ring, kLamp});
  const ContourQuery all = Query(faces);
  const Contour contour = ContourByArrangement(all);
  ASSERT_EQ(contour.sources.size(), 4U);
  std::vector<double> visible;
  for (int only = 1; only <= 4; ++only) {
    const ContourQuery query = Query(faces, all.receiver, FaceNumber(only));
    visible.push_back(FormFactorOf(query));
    const Ring& ring = strips[static_cast<std::size_t>(only) - 1];
    EXPECT_LT(visible.back(), FormFactorOf({{ring, kLamp}}) - 1e-3);
    EXPECT_NEAR(visible.back(), visible.front(), 1e-15);  // by symmetry
  }
  EXPECT_NEAR(FormFactorOf(all, contour), 4 * visible.front(), 1e-15);
}

TEST(ArrangementEngine, OfCoplanarFacesTheFirstThatEmitsIsInFront) {
  const Ring lamp = Ceiling(-1, 1, -1, 1, 1);
  const Ring black = Ceiling(0, 2, -2, 2, 1);
  const double whole = FormFactorOf({{lamp, kLamp}});
  const double rest = FormFactorOf({{Ceiling(-1, 0, -1, 1, 1), kLamp}});
  EXPECT_NEAR(FormFactorOf({{lamp, kLamp}, {black, kBlack}}), whole, 1e-15);
  EXPECT_NEAR(FormFactorOf({{black, kBlack}, {lamp, kLamp}}), whole, 1e-15);
  // Also when the back of the first is seen, even of an emitter.
  EXPECT_NEAR(FormFactorOf({{Reversed(black), kBlack}, {lamp, kLamp}}), whole,
              1e-15);
  EXPECT_NEAR(FormFactorOf({{Reversed(black), kLamp}, {lamp, kLamp}}), whole,
              1e-15);
  // Of two that emit the first is seen: together they are the union.
  EXPECT_NEAR(FormFactorOf({{black, kLamp}, {lamp, kLamp}}),
              rest + FormFactorOf({{black, kLamp}}), 1e-15);
}

TEST(ArrangementEngine, TheSameFaceTwiceCountsOnce) {
  const Ring lamp = Ceiling(-1, 1, -1, 1, 1);
  const double whole = FormFactorOf({{lamp, kLamp}});
  EXPECT_NEAR(FormFactorOf({{lamp, kLamp}, {lamp, kLamp}}), whole, 1e-15);
  const ContourQuery query = Query({{Reversed(lamp), kLamp}, {lamp, kLamp}});
  EXPECT_FALSE(ContourByArrangement(query).arcs.empty());
}

TEST(ArrangementEngine, TheBackIsBlackAndBlocks) {
  const Ring far = Ceiling(-4, 4, -4, 4, 4);
  const Ring near = Reversed(Ceiling(-1, 1, -1, 1, 2));
  EXPECT_TRUE(ContourByArrangement(Query({{near, kLamp}})).arcs.empty());
  EXPECT_NEAR(
      FormFactorOf({{far, kLamp}, {near, kLamp}}),
      FormFactorOf({{far, kLamp}}) - FormFactorOf({{Reversed(near), kLamp}}),
      1e-15);
}

TEST(ArrangementEngine, AFaceWhosePlaneContainsTheReceiverIsNotThere) {
  const Ring lamp = Ceiling(-1, 1, -1, 1, 1);
  const double whole = FormFactorOf({{lamp, kLamp}});
  const Ring through = {{0, -1, -1}, {0, 1, -1}, {0, 1, 2}, {0, -1, 2}};
  const Ring beside = {{0.5, 0.5, 0.1}, {2, 2, 0.1}, {2, 2, 1}, {1, 1, 3}};
  const Ring corner = {{0, 0, 0}, {1, 0, 1}, {0, 1, 1}};
  for (const Ring& ring : {through, beside, corner}) {
    EXPECT_EQ(FormFactorOf({{lamp, kLamp}, {ring, kBlack}}), whole);
    EXPECT_EQ(FormFactorOf({{ring, kLamp}, {lamp, kLamp}}), whole);
    EXPECT_EQ(FormFactorOf({{Reversed(ring), kLamp}, {lamp, kLamp}}), whole);
  }
}

TEST(ArrangementEngine, TheHorizonCutsAWall) {
  const Ring wall = {{1, -1, -3}, {1, -1, 2}, {1, 1, 2}, {1, 1, -3}};
  const Ring above = {{1, -1, 0}, {1, -1, 2}, {1, 1, 2}, {1, 1, 0}};
  for (const bool front : {true, false}) {
    const ContourQuery query = Query({{front ? Reversed(wall) : wall, kLamp}});
    const ContourQuery cut = Query({{front ? Reversed(above) : above, kLamp}});
    EXPECT_EQ(FormFactorOf(query), FormFactorOf(cut));
  }
  const ContourQuery query = Query({{wall, kLamp}});
  const ContourQuery other = Query({{Reversed(wall), kLamp}});
  // One of the two shows its front.
  EXPECT_NE(ContourByArrangement(query).arcs.empty(),
            ContourByArrangement(other).arcs.empty());
}

TEST(ArrangementEngine, NothingBelowTheHorizonCounts) {
  const Ring touching = {{1, -1, -1}, {1, 1, -1}, {1, 0, 0}};
  const Ring below = {{1, -1, -1}, {1, 1, -1}, {1, 0, -0.5}};
  for (const Ring& ring : {touching, below}) {
    for (const Ring& side : {ring, Reversed(ring)}) {
      const Contour contour = ContourByArrangement(Query({{side, kLamp}}));
      EXPECT_TRUE(contour.arcs.empty());
      EXPECT_EQ(contour.statistics.sources, 0U);
    }
  }
}

TEST(ArrangementEngine, OnFaceTakesAwayAllFacesInThatPlane) {
  const Ring lamp = Ceiling(-1, 1, -1, 1, 1);
  const Ring shelf = Ceiling(-2, 2, -2, 2, 0.25);
  const Ring beside = Ceiling(2, 3, 2, 3, 0.25);
  const std::vector<TestFace> faces = {
      {lamp, kLamp}, {shelf, kBlack}, {beside, kLamp}};
  EXPECT_TRUE(FormFactorOf(faces) < FormFactorOf({{lamp, kLamp}}));
  const ContourQuery on_shelf = Query(faces, {{0, 0, 0}, {0, 0, 1}, 2});
  EXPECT_EQ(FormFactorOf(on_shelf), FormFactorOf({{lamp, kLamp}}));
}

TEST(ArrangementEngine, OnlySourceMakesABlackFaceTheSource) {
  const Ring lamp = Ceiling(-1, 1, -1, 1, 1);
  const Ring shelf = Ceiling(-0.1, 0.1, -0.1, 0.1, 0.5);
  const std::vector<TestFace> faces = {{lamp, kLamp}, {shelf, kBlack}};
  const ContourQuery query =
      Query(faces, {{0, 0, 0}, {0, 0, 1}, 0}, FaceNumber(2));
  const Contour contour = ContourByArrangement(query);
  ASSERT_EQ(contour.sources.size(), 1U);
  EXPECT_EQ(contour.sources[SourceId(0)].facet, FacetId(1));
  EXPECT_NEAR(FormFactorOf(query, contour), FormFactorOf({{shelf, kLamp}}),
              1e-15);
}

TEST(ArrangementEngine, TrianglesOfABentFaceHideEachOther) {
  // The second triangle is folded over the first.
  const Ring bent = {{-1, -1, 2}, {-1, 2, 2}, {2, -1, 2}, {1, -1.5, 1}};
  const ContourQuery query = Query({{bent, kLamp}});
  ASSERT_EQ(query.scene.facets().size(), 2U);
  std::vector<TestFace> triangles;
  for (const Triangle& t : query.scene.triangles()) {
    Ring ring;
    for (const int v : t.vertices) {
      ring.push_back(query.scene.vertices()[static_cast<std::size_t>(v)]);
    }
    triangles.push_back({ring, kLamp});
  }
  const double expected = FormFactorOf(triangles);
  EXPECT_EQ(FormFactorOf(query), expected);
  EXPECT_GT(expected, 0);
}

TEST(ArrangementEngine, AConcaveSourceHasNoDiagonals) {
  const Ring l_shape = {{-1, -1, 1}, {-1, 1, 1}, {0, 1, 1},
                        {0, 0, 1},   {1, 0, 1},  {1, -1, 1}};
  const ContourQuery query = Query({{l_shape, kLamp}});
  const Contour contour = ContourByArrangement(query);
  EXPECT_NEAR(FormFactorOf(query, contour), 3 * CornerFormFactor(1, 1), 1e-15);
  // The two inner edges lie in the cuts; four planes and no other remain.
  EXPECT_EQ(PlanesOn(contour, FaceNumber(1)), 4);
  EXPECT_EQ(PlanesOn(contour, FaceNumber(0)), 2);
}

TEST(ArrangementEngine, ThreadsDoNotDisturbEachOther) {
  std::vector<TestFace> faces = {{Ceiling(-4, 4, -4, 4, 4), kLamp}};
  for (int i = 0; i < 6; ++i) {
    faces.push_back(
        {{{-0.1 * i, -1.3, 1}, {0.7, 0.3 * i, 1.1}, {-0.9, 0.4, 2.7 - 0.2 * i}},
         kBlack});
  }
  const ContourQuery query = Query(faces);
  const double expected = FormFactorOf(query);
  std::vector<std::future<Contour>> answers;
  for (int i = 0; i < 4; ++i) {
    answers.push_back(std::async(std::launch::async, [&query] {
      for (int k = 0; k < 4; ++k)
        ContourByArrangement(query);
      return ContourByArrangement(query);
    }));
  }
  for (std::future<Contour>& answer : answers) {
    EXPECT_EQ(FormFactorOf(query, answer.get()), expected);
  }
}

}  // namespace
}  // namespace truelux
