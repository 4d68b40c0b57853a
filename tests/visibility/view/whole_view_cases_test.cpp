// SPDX-License-Identifier: GPL-3.0-or-later
// The whole view on every case: its regions tile the hemisphere, they fit
// together around every vertex, and what they say of sources is what the
// visible contour says.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/io.h"
#include "truelux/irradiance.h"

#include "support/case_files.h"
#include "support/view_sums.h"
#include "visibility/view/whole_view.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

constexpr double kPi = std::numbers::pi;

using Key = std::array<double, 3>;

Key KeyOf(const Vector3& v) {
  return {v.x, v.y, v.z};
}

/// What one case shows to its first receivers.
void ForEachView(
    const std::string& name, std::size_t limit,
    const std::function<void(const ContourQuery&, const WholeView&)>& look) {
  const Scene scene = ReadScene(CaseFolder(name) / "scene.obj").value.value();
  const auto rows = ReadNumbers(CaseFolder(name) / "receivers.csv");
  for (std::size_t i = 0; i < std::min(rows.size(), limit); ++i) {
    const auto& row = rows[i];
    const Receiver receiver{{row[0], row[1], row[2]},
                            {row[3], row[4], row[5]},
                            row.size() > 6 ? static_cast<int>(row[6]) : 0};
    SCOPED_TRACE(name + ", receiver " + std::to_string(i));
    const ContourQuery query{scene, receiver};
    look(query, WholeViewOf(query));
  }
}

bool Emits(const Scene& scene, int face) {
  const Rgb& m = scene.faces()[static_cast<std::size_t>(face - 1)].emission;
  return m[0] > 0 || m[1] > 0 || m[2] > 0;
}

bool ShowsSource(const Scene& scene, const WholeView& view, int region) {
  if (region < 0) return false;
  const ViewRegion& r = view.regions[static_cast<std::size_t>(region)];
  return r.face > 0 && r.front && Emits(scene, r.face);
}

double ShareOf(const ContourQuery& query, const WholeView& view,
               std::size_t region) {
  return DiscShareOf(view, region, query.receiver.normal);
}

void ExpectRegionsTileTheHemisphere(const ContourQuery& query,
                                    const WholeView& view) {
  const Oracle oracle(query.scene);
  double disc = 0;
  double solid_angle = 0;
  std::map<int, double> shares;
  for (std::size_t r = 0; r < view.regions.size(); ++r) {
    const double share = ShareOf(query, view, r);
    EXPECT_GT(share, -1e-9);
    disc += share;
    const double own = SolidAngleByTurns(view, r);
    EXPECT_GT(own, -1e-6);
    solid_angle += own;
    shares[view.regions[r].front ? view.regions[r].face : 0] += share;
    EXPECT_FALSE(view.regions[r].loops.empty());
  }
  EXPECT_NEAR(disc, 1, 1e-9);
  EXPECT_NEAR(solid_angle, 2 * kPi, 1e-6);
  for (int f = 1; f <= static_cast<int>(query.scene.faces().size()); ++f) {
    if (!Emits(query.scene, f)) continue;
    EXPECT_NEAR(shares[f], oracle.FormFactor(query.receiver, f).value[0],
                1e-10);
  }
}

void ExpectLoopsAreClosedAndEveryArcIsInTwo(const ContourQuery& /*query*/,
                                            const WholeView& view) {
  std::map<std::pair<int, int>, int> uses;
  for (std::size_t r = 0; r < view.regions.size(); ++r) {
    for (const ViewLoop& loop : view.regions[r].loops) {
      for (std::size_t i = 0; i < loop.arcs.size(); ++i) {
        const int a = loop.arcs[i];
        const int b = loop.arcs[(i + 1) % loop.arcs.size()];
        const WholeViewArc& arc = view.arcs[static_cast<std::size_t>(a)];
        const WholeViewArc& next = view.arcs[static_cast<std::size_t>(b)];
        const int region = static_cast<int>(r);
        EXPECT_EQ(arc.left == region ? arc.to : arc.from,
                  next.left == region ? next.from : next.to);
        EXPECT_TRUE(arc.left == region || arc.right == region);
        ++uses[{a, region}];
      }
    }
  }
  for (std::size_t a = 0; a < view.arcs.size(); ++a) {
    const WholeViewArc& arc = view.arcs[a];
    EXPECT_NE(arc.left, arc.right);
    EXPECT_EQ((uses[{static_cast<int>(a), arc.left}]), 1);
    if (arc.right >= 0) {
      EXPECT_EQ((uses[{static_cast<int>(a), arc.right}]), 1);
    }
    EXPECT_EQ(arc.right < 0, arc.kind == ViewArcKind::kHorizon);
    EXPECT_EQ(arc.edge.face == 0, arc.kind == ViewArcKind::kHorizon);
    EXPECT_EQ(arc.edge.other_face != 0, arc.kind == ViewArcKind::kMeeting);
  }
}

void ExpectNeighboursShowDifferentFaces(const ContourQuery& /*query*/,
                                        const WholeView& view) {
  for (const WholeViewArc& arc : view.arcs) {
    if (arc.right < 0) continue;
    EXPECT_NE(view.regions[static_cast<std::size_t>(arc.left)].face,
              view.regions[static_cast<std::size_t>(arc.right)].face);
  }
}

using VertexFacts = std::tuple<Key, VertexKind, bool, int, int>;

VertexFacts FactsOf(const ContourVertex& v) {
  return {KeyOf(v.direction), v.kind, v.conjunctive, v.planes, v.vertex};
}

/// The vertices of a source's border, in the view: those where it does not go
/// straight on, and scene vertices.
void ExpectVerticesOfSourcesAreThoseOfTheContour(const ContourQuery& query,
                                                 const WholeView& view) {
  const VisibleContour contour =
      Oracle(query.scene, {.engine = Engine::kArrangement})
          .Contour(query.receiver);
  std::map<Key, int> arcs_at;
  for (const ContourArc& arc : contour.arcs) {
    for (const int v : {arc.from, arc.to})
      ++arcs_at[KeyOf(contour.vertices[static_cast<std::size_t>(v)].direction)];
  }
  // Rounded, several vertices may have one direction.
  std::set<VertexFacts> in_view;
  for (const WholeViewVertex& v : view.vertices) {
    if (v.bounds_source) in_view.insert(FactsOf(v.vertex));
  }
  std::set<VertexFacts> in_contour;
  for (const ContourVertex& v : contour.vertices) {
    in_contour.insert(FactsOf(v));
    if (in_view.contains(FactsOf(v))) continue;
    // Where two sources border on each other, the contour keeps the points
    // at which a hidden edge passes: two arcs of each end there.
    EXPECT_EQ(arcs_at[KeyOf(v.direction)] % 4, 0);
    EXPECT_NE(v.kind, VertexKind::kIntrinsic);
  }
  for (const WholeViewVertex& v : view.vertices) {
    EXPECT_GE(v.edges.empty() ? 0 : v.vertex.planes, 1);
    if (!v.bounds_source || in_contour.contains(FactsOf(v.vertex))) continue;
    // A hidden scene vertex on a border that lies on a chart's cut.
    EXPECT_EQ(v.vertex.kind, VertexKind::kIntrinsic);
    EXPECT_TRUE(v.vertex.conjunctive);
  }
}

/// Per source and plane, the total angle of its arcs; planes as the contour
/// gives them, towards the visible side.
using Borders = std::map<std::pair<int, Key>, double>;

void ExpectBordersOfSourcesAreThoseOfTheContour(const ContourQuery& query,
                                                const WholeView& view) {
  const VisibleContour contour = Oracle(query.scene).Contour(query.receiver);
  Borders expected;
  for (const ContourArc& arc : contour.arcs) {
    const Vector3& a =
        contour.vertices[static_cast<std::size_t>(arc.from)].direction;
    const Vector3& b =
        contour.vertices[static_cast<std::size_t>(arc.to)].direction;
    expected[{arc.source, KeyOf(arc.plane_normal)}] +=
        std::atan2(LengthOf(CrossOf(a, b)), DotOf(a, b));
  }
  Borders borders;
  const auto add = [&](int region, const Vector3& plane, double angle) {
    if (!ShowsSource(query.scene, view, region)) return;
    const int face = view.regions[static_cast<std::size_t>(region)].face;
    borders[{face, KeyOf(plane)}] += angle;
  };
  for (const WholeViewArc& arc : view.arcs) {
    add(arc.left, arc.plane_normal, AngleOf(view, arc));
    // A zero must not become minus zero.
    const Vector3 back{0 - arc.plane_normal.x, 0 - arc.plane_normal.y,
                       0 - arc.plane_normal.z};
    add(arc.right, back, AngleOf(view, arc));
  }
  EXPECT_EQ(borders.size(), expected.size());
  for (const auto& [key, angle] : expected) {
    const auto found = borders.find(key);
    ASSERT_NE(found, borders.end()) << "source " << key.first;
    EXPECT_NEAR(found->second, angle, 1e-9);
  }
}

class WholeViewOfCase : public ::testing::TestWithParam<std::string> {};

TEST_P(WholeViewOfCase, IsConsistentAndAgreesWithTheContour) {
  ForEachView(GetParam(), 2,
              [](const ContourQuery& query, const WholeView& view) {
                ExpectRegionsTileTheHemisphere(query, view);
                ExpectLoopsAreClosedAndEveryArcIsInTwo(query, view);
                ExpectNeighboursShowDifferentFaces(query, view);
                ExpectVerticesOfSourcesAreThoseOfTheContour(query, view);
                ExpectBordersOfSourcesAreThoseOfTheContour(query, view);
              });
}

INSTANTIATE_TEST_SUITE_P(All, WholeViewOfCase, ::testing::ValuesIn(CaseNames()),
                         [](const auto& case_info) { return case_info.param; });

}  // namespace
}  // namespace truelux
