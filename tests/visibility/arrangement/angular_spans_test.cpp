// SPDX-License-Identifier: GPL-3.0-or-later
// The span lists of views that can be drawn by hand, and what every span list
// has to be.

#include "visibility/arrangement/angular_spans.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scenes.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

/// The receiver at the origin that looks up; its charts meet in the planes
/// x = 0 and y = 0.
constexpr Receiver kUp{{0, 0, 0}, {0, 0, 1}, 0};

const TestFace kBackground = {Ceiling(-8, 8, -8, 8, 16), kLamp};

/// The point of the background that everything below coincides with.
constexpr Point3 kHub{2, 1, 16};

AngularSpans SpansOf(const std::vector<TestFace>& faces,
                     const Receiver& receiver = kUp) {
  return AngularSpansOf({MakeScene(faces), receiver});
}

Vec3<Exact> Direction(const Point3& p) {
  return {Exact(p.x), Exact(p.y), Exact(p.z)};
}

bool SameDirection(const Vec3<Exact>& a, const Vec3<Exact>& b) {
  const Vec3<Exact> c = Cross(a, b);
  return c.x.is_zero() && c.y.is_zero() && c.z.is_zero() &&
         SignOf(Dot(a, b)) == Sign::kPositive;
}

/// All vertices in one direction: two if it is on a cut between charts.
std::vector<SpanVertex> VerticesAt(const AngularSpans& spans, const Point3& p) {
  std::vector<SpanVertex> found;
  std::ranges::copy_if(spans.vertices, std::back_inserter(found),
                       [&](const SpanVertex& v) {
                         return SameDirection(v.direction, Direction(p));
                       });
  return found;
}

/// The facets around a vertex in order, beginning with the given one.
std::vector<int> Labels(const SpanVertex& vertex, int first) {
  std::vector<int> labels;
  for (const AngularSpan& span : vertex.spans)
    labels.push_back(span.facet.value());
  std::rotate(labels.begin(), std::ranges::find(labels, first), labels.end());
  return labels;
}

double Norm(const Vec3<Exact>& v) {
  return std::sqrt(Dot(v, v).to_double());
}

/// The angle at v from one edge to the next, in (0, 2 pi].
double Turn(const Vec3<Exact>& v, const AngularSpan& from,
            const AngularSpan& to) {
  const double sine =
      Dot(Cross(from.edge_plane, to.edge_plane), v).to_double() / Norm(v);
  const double cosine = Dot(from.edge_plane, to.edge_plane).to_double();
  const double angle = std::atan2(sine, cosine);
  return angle > 0 ? angle : angle + 2 * std::numbers::pi;
}

/// The angles of the spans, in their order.
std::vector<double> Turns(const SpanVertex& vertex) {
  std::vector<double> turns;
  const std::size_t size = vertex.spans.size();
  for (std::size_t i = 0; i < size; ++i) {
    turns.push_back(
        Turn(vertex.direction, vertex.spans[i], vertex.spans[(i + 1) % size]));
  }
  return turns;
}

/// What holds around every vertex.
void ExpectOneFullCircle(const SpanVertex& vertex) {
  ASSERT_GE(vertex.spans.size(), 2U);
  double sum = 0;
  for (const double turn : Turns(vertex))
    sum += turn;
  EXPECT_NEAR(sum, 2 * std::numbers::pi, 1e-9);
  FacetId previous = vertex.spans.back().facet;
  for (const AngularSpan& span : vertex.spans) {
    EXPECT_NE(span.facet, previous);
    previous = span.facet;
    EXPECT_TRUE(
        SameDirection(span.edge_plane, Cross(vertex.direction, span.edge_end)));
  }
}

/// A direction in the plane of the background.
struct Step {
  double x;
  double y;
};

/// A small triangle with a corner at kHub, between two steps that turn to the
/// left as seen from above; its front is below.
Ring Wedge(const Step& right, const Step& left) {
  return {kHub,
          {kHub.x + left.x / 4, kHub.y + left.y / 4, 16},
          {kHub.x + right.x / 4, kHub.y + right.y / 4, 16}};
}

/// One with an edge that passes kHub along a step, and lies to its left.
Ring HalfPlane(const Step& along) {
  return {{kHub.x + along.x / 4, kHub.y + along.y / 4, 16},
          {kHub.x - along.x / 4, kHub.y - along.y / 4, 16},
          {kHub.x - along.y / 4, kHub.y + along.x / 4, 16}};
}

TEST(AngularSpans, OfAnIntrinsicVertexBeforeABackground) {
  const AngularSpans spans =
      SpansOf({kBackground, {Scaled(Wedge({1, 0}, {0, 1}), 0.5)}});
  const auto vertices = VerticesAt(spans, kHub);
  ASSERT_EQ(vertices.size(), 1U);
  EXPECT_EQ(Labels(vertices[0], 0), (std::vector<int>{0, 1}));
  ExpectOneFullCircle(vertices[0]);
  for (std::size_t i = 0; i < 2; ++i) {
    const AngularSpan& span = vertices[0].spans[i];
    EXPECT_EQ(span.is_source, span.facet == FacetId(0));
    const bool narrow = Turns(vertices[0])[i] < 2;
    EXPECT_EQ(narrow, span.facet == FacetId(1));
  }
}

TEST(AngularSpans, OfAnApparentVertex) {
  // The nearer edge goes on, the farther one ends there.
  const AngularSpans spans =
      SpansOf({kBackground,
               {Scaled(HalfPlane({1, 0}), 0.5)},
               {Scaled(HalfPlane({0, 1}), 0.25), kLamp}});
  const auto vertices = VerticesAt(spans, kHub);
  ASSERT_EQ(vertices.size(), 1U);
  // Facet 2 is left of the line, 1 above right of it, 0 below right.
  EXPECT_EQ(Labels(vertices[0], 0), (std::vector<int>{0, 1, 2}));
  ExpectOneFullCircle(vertices[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    const AngularSpan& span = vertices[0].spans[i];
    EXPECT_EQ(span.is_source, span.facet != FacetId(1));
    if (span.facet == FacetId(2)) {
      EXPECT_NEAR(Turns(vertices[0])[i], std::numbers::pi, 1e-14);
    }
  }
}

TEST(AngularSpans, OfAConjunctionOfThreeEdgesAndOneVertex) {
  // Figure 3(c). From above, in degrees and from near to far: 4 covers -45 to
  // 27, 3 covers 45 to 225, 2 covers 90 to 270, 1 covers 0 to 180.
  std::vector<TestFace> faces = {kBackground,
                                 {Scaled(HalfPlane({1, 0}), 0.5)},
                                 {Scaled(HalfPlane({0, 1}), 0.25)},
                                 {Scaled(HalfPlane({1, 1}), 0.125), kLamp},
                                 {Scaled(Wedge({1, -1}, {2, 1}), 0.0625)}};
  const auto vertices = VerticesAt(SpansOf(faces), kHub);
  ASSERT_EQ(vertices.size(), 1U);
  EXPECT_EQ(Labels(vertices[0], 0), (std::vector<int>{0, 4, 1, 3, 2}));
  ExpectOneFullCircle(vertices[0]);
  for (const AngularSpan& span : vertices[0].spans) {
    EXPECT_EQ(span.is_source,
              span.facet == FacetId(0) || span.facet == FacetId(3));
  }
  // The order of the faces in the file only names them.
  std::ranges::reverse(faces);
  const auto renamed = VerticesAt(SpansOf(faces), kHub);
  ASSERT_EQ(renamed.size(), 1U);
  EXPECT_EQ(Labels(renamed[0], 4), (std::vector<int>{4, 0, 3, 1, 2}));
}

TEST(AngularSpans, HaveNoneForWhatIsHidden) {
  // A corner and two edges that cross, behind what covers both.
  EXPECT_TRUE(VerticesAt(SpansOf({kBackground,
                                  {Scaled(Wedge({1, 0}, {0, 1}), 0.5)},
                                  {Scaled(HalfPlane({1, 0}), 0.75)},
                                  {Ceiling(0.125, 0.5, 0.0625, 0.25, 2)}}),
                         kHub)
                  .empty());
}

TEST(AngularSpans, OfACutBetweenChartsAreInTwoHalves) {
  const AngularSpans spans = SpansOf({kBackground});
  // Where the border of the background passes from one chart to the next.
  const auto halves = VerticesAt(spans, {0, 8, 16});
  ASSERT_EQ(halves.size(), 2U);
  double seen = 0;
  for (const SpanVertex& half : halves) {
    EXPECT_EQ(Labels(half, 0), (std::vector<int>{0, -1}));
    ExpectOneFullCircle(half);
    for (std::size_t i = 0; i < 2; ++i) {
      if (half.spans[i].facet == FacetId(0)) seen += Turns(half)[i];
    }
  }
  EXPECT_NEAR(seen, std::numbers::pi, 1e-14);
  EXPECT_EQ(VerticesAt(spans, {8, 8, 16}).size(), 1U);
  EXPECT_EQ(VerticesAt(spans, {0, 0, 16}).size(), 4U);
  EXPECT_EQ(spans.vertices.size(), 4U + 4 * 2 + 4);
  EXPECT_EQ(spans.statistics.sources, 1U);
}

TEST(AngularSpans, OfTheHorizonKnowTheOtherEndOfTheirEdges) {
  // A wall that stands on the receiver plane.
  const TestFace wall = {{{4, 1, 0}, {4, 1, 2}, {4, 3, 2}, {4, 3, 0}}, kLamp};
  const auto vertices = VerticesAt(SpansOf({wall}), {4, 1, 0});
  ASSERT_EQ(vertices.size(), 1U);
  EXPECT_EQ(Labels(vertices[0], 0), (std::vector<int>{0, -1}));
  ExpectOneFullCircle(vertices[0]);
  for (const AngularSpan& span : vertices[0].spans) {
    const Point3 end =
        span.facet == FacetId(0) ? Point3{4, 3, 0} : Point3{4, 1, 2};
    EXPECT_TRUE(SameDirection(span.edge_end, Direction(end)));
  }
}

TEST(AngularSpans, AreNoneWhereNothingEmitsTowardsTheReceiver) {
  EXPECT_TRUE(SpansOf({{kBackground.ring}}).vertices.empty());
  EXPECT_TRUE(SpansOf({{Reversed(kBackground.ring), kLamp}}).vertices.empty());
  EXPECT_TRUE(
      SpansOf({kBackground, {Ceiling(-8, 8, -8, 8, 8)}}).vertices.empty());
}

TEST(AngularSpans, OfRandomViewsAreFullCirclesAndTheirEdgesHaveTwoEnds) {
  std::size_t most = 0;
  int edges = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    PortableRandom random(seed);
    const bool lattice = seed % 4 != 0;
    const std::vector<TestFace> faces = RandomScene(random, lattice, 8, 2);
    const AngularSpans spans =
        SpansOf(faces, RandomReceiver(random, lattice, 2));
    for (const SpanVertex& v : spans.vertices) {
      ExpectOneFullCircle(v);
      most = std::max(most, v.spans.size());
      for (const AngularSpan& span : v.spans) {
        if (!span.is_source) continue;
        // Seen from its other end, the span is the one before the edge.
        const auto ends_here = [&](const SpanVertex& w) {
          if (!SameDirection(w.direction, span.edge_end)) return false;
          const std::size_t size = w.spans.size();
          for (std::size_t i = 0; i < size; ++i) {
            if (SameDirection(w.spans[i].edge_end, v.direction) &&
                w.spans[(i + size - 1) % size].facet == span.facet) {
              return true;
            }
          }
          return false;
        };
        EXPECT_EQ(std::ranges::count_if(spans.vertices, ends_here), 1);
        ++edges;
      }
    }
  }
  EXPECT_GE(most, 5U);
  EXPECT_GT(edges, 500);
}

}  // namespace
}  // namespace truelux
