// SPDX-License-Identifier: GPL-3.0-or-later
// The whole view of scenes whose view is known.

#include "visibility/view/whole_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/io.h"

#include "support/case_files.h"
#include "support/random_scene.h"
#include "support/scenes.h"
#include "support/view_sums.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

constexpr double kPi = std::numbers::pi;

WholeView Look(const std::vector<TestFace>& faces,
               const Vector3& normal = {0, 0, 1}, const Point3& at = {0, 0, 0},
               int on_face = 0) {
  return WholeViewOf({MakeScene(faces), {at, normal, on_face}});
}

std::multiset<int> FacesSeen(const WholeView& view) {
  std::multiset<int> faces;
  for (const ViewRegion& region : view.regions)
    faces.insert(region.face);
  return faces;
}

int CountOf(const WholeView& view, ViewArcKind kind) {
  return static_cast<int>(
      std::ranges::count(view.arcs, kind, &WholeViewArc::kind));
}

/// What does not depend on numbering: faces, kinds, and exact geometry rounded.
using Key = std::array<double, 3>;
using ArcFacts = std::tuple<ViewArcKind, int, int, Key, Key, Key>;
using VertexFacts = std::tuple<Key, VertexKind, bool, int, int, std::size_t>;

Key KeyOf(const Vector3& v) {
  return {v.x, v.y, v.z};
}

/// Arcs in the sense in which the first side has the smaller name; names: per
/// face number of the view what it is called.
std::multiset<ArcFacts> ArcsOf(const WholeView& view,
                               const std::vector<int>& names) {
  const auto name = [&](int region) {
    if (region < 0) return -1;
    const int face = view.regions[static_cast<std::size_t>(region)].face;
    return face == 0 ? 0 : names[static_cast<std::size_t>(face - 1)];
  };
  const auto end = [&](int vertex) {
    return vertex < 0 ? Key{} : KeyOf(DirectionOf(view, vertex));
  };
  std::multiset<ArcFacts> facts;
  for (const WholeViewArc& arc : view.arcs) {
    const int left = name(arc.left);
    const int right = name(arc.right);
    const Vector3& n = arc.plane_normal;
    const bool turn = right < left;
    const Key plane = turn ? Key{0 - n.x, 0 - n.y, 0 - n.z} : KeyOf(n);
    facts.insert({arc.kind, turn ? right : left, turn ? left : right,
                  turn ? end(arc.to) : end(arc.from),
                  turn ? end(arc.from) : end(arc.to), plane});
  }
  return facts;
}

std::multiset<VertexFacts> VerticesOf(const WholeView& view) {
  std::multiset<VertexFacts> facts;
  for (const WholeViewVertex& v : view.vertices) {
    facts.insert({KeyOf(v.vertex.direction), v.vertex.kind,
                  v.vertex.conjunctive, v.vertex.planes, v.planes_with_hidden,
                  v.edges.size()});
  }
  return facts;
}

const Ring kLow = Ceiling(-1, 1, -1, 1, 2);
const Ring kHigh = Ceiling(-4, 4, -4, 4, 4);

TEST(WholeView, OfNothingIsOneRegionWithoutVertices) {
  for (const Vector3& normal : {Vector3{0, 0, 1}, Vector3{1, 2, 3}}) {
    const WholeView view = Look({}, normal);
    ASSERT_EQ(view.regions.size(), 1U);
    EXPECT_EQ(view.regions[0].face, 0);
    EXPECT_EQ(view.regions[0].loops.size(), 1U);
    ASSERT_EQ(view.arcs.size(), 1U);
    EXPECT_EQ(view.arcs[0].from, -1);
    EXPECT_EQ(view.arcs[0].to, -1);
    EXPECT_TRUE(view.arcs[0].at_least_pi);
    EXPECT_TRUE(view.vertices.empty());
    EXPECT_NEAR(SolidAngleByTurns(view, 0), 2 * kPi, 1e-12);
  }
}

TEST(WholeView, OfASquareBeforeASquareHasOneHole) {
  const WholeView view = Look({{kLow}, {kHigh, kLamp}});
  EXPECT_EQ(FacesSeen(view), (std::multiset<int>{0, 1, 2}));
  EXPECT_EQ(view.arcs.size(), 9U);
  EXPECT_EQ(CountOf(view, ViewArcKind::kSilhouette), 8);
  EXPECT_EQ(view.vertices.size(), 8U);
  for (const ViewRegion& region : view.regions)
    EXPECT_EQ(region.loops.size(), region.face == 1 ? 1U : 2U);
}

TEST(WholeView, OfAFaceThatCoversAllIsThatFaceAlone) {
  // The receiver is in a tent of two faces, and the cuts are nowhere.
  const double s = 1 << 20;
  const WholeView view =
      Look({{{{0, -s, 1}, {0, s, 1}, {s, s, -1}, {s, -s, -1}}, kLamp},
            {{{0, -s, 1}, {-s, -s, -1}, {-s, s, -1}, {0, s, 1}}, kLamp},
            {{{-s, -s, -1}, {0, -s, 1}, {s, -s, -1}}},
            {{{-s, s, -1}, {s, s, -1}, {0, s, 1}}}},
           {0, 0, 1}, {1, 2, 0});
  EXPECT_EQ(FacesSeen(view), (std::multiset<int>{1, 2, 3, 4}));
  // A box without a floor, from its ceiling's middle, looking at one wall only
  // through a hemisphere that this wall fills: all of the rest is behind.
  const std::vector<Ring> box = BoxAround(1);
  std::vector<TestFace> faces;
  for (const Ring& ring : box)
    faces.push_back({ring, kLamp});
  const WholeView closed = Look(faces, {1, 2, 3}, {0.25, 0.5, 0.125});
  double share = 0;
  for (std::size_t r = 0; r < closed.regions.size(); ++r) {
    EXPECT_GT(closed.regions[r].face, 0);
    EXPECT_TRUE(closed.regions[r].front);
    share += DiscShareOf(closed, r, {1, 2, 3});
  }
  EXPECT_NEAR(share, 1, 1e-14);
  EXPECT_EQ(CountOf(closed, ViewArcKind::kSilhouette), 0);
}

TEST(WholeView, OfFacesThatPassThroughEachOtherShowsTheirLine) {
  const Ring a = {{-2, -2, 3}, {-2, 2, 3}, {2, 2, 5}, {2, -2, 5}};
  const Ring b = {{-2, -2, 5}, {-2, 2, 5}, {2, 2, 3}, {2, -2, 3}};
  const WholeView view = Look({{a}, {b, kLamp}});
  ASSERT_EQ(CountOf(view, ViewArcKind::kMeeting), 1);
  const auto arc =
      std::ranges::find(view.arcs, ViewArcKind::kMeeting, &WholeViewArc::kind);
  EXPECT_EQ(arc->edge, (SeenEdge{1, -1, -1, 2}));
  EXPECT_EQ(std::abs(arc->plane_normal.x), 1);
  EXPECT_EQ(arc->plane_normal.y, 0);
  EXPECT_EQ(arc->plane_normal.z, 0);
  for (const int end : {arc->from, arc->to}) {
    const WholeViewVertex& v = view.vertices[static_cast<std::size_t>(end)];
    // Two edges that cross in space, and the line.
    EXPECT_EQ(v.vertex.kind, VertexKind::kApparent);
    EXPECT_EQ(v.vertex.planes, 3);
  }
}

TEST(WholeView, OfATentShowsNothingNowhere) {
  const double s = 64;
  const WholeView tent =
      Look({{{{0, -s, 1}, {0, s, 1}, {s, s, -1}, {s, -s, -1}}, kLamp},
            {{{0, -s, 1}, {-s, -s, -1}, {-s, s, -1}, {0, s, 1}}, kLamp},
            {{{-s, -s, -1}, {0, -s, 1}, {s, -s, -1}}},
            {{{-s, s, -1}, {s, s, -1}, {0, s, 1}}}},
           {0, 0, 1}, {1, 2, 0});
  EXPECT_EQ(FacesSeen(tent), (std::multiset<int>{1, 2, 3, 4}));
  EXPECT_EQ(CountOf(tent, ViewArcKind::kInner), 5);
  EXPECT_EQ(CountOf(tent, ViewArcKind::kHorizon), 4);
}

TEST(WholeView, OfAFaceAtTheHorizonFillsTheHemisphere) {
  // Only a face whose plane is at the receiver up to the smallest number comes
  // near: the share of the disc that nothing takes is its distance squared.
  const WholeView view =
      Look({{Ceiling(-1, 1, -1, 1, 0x1p-40), kLamp}}, {0, 0, 1});
  ASSERT_EQ(view.regions.size(), 2U);
  for (std::size_t r = 0; r < 2; ++r) {
    const double share = DiscShareOf(view, r, {0, 0, 1});
    EXPECT_NEAR(share, view.regions[r].face, 1e-12);
  }
}

TEST(WholeView, OfCoplanarFacesShowsTheEarlierOne) {
  const Ring other = Ceiling(0, 3, 0, 3, 2);
  const WholeView view = Look({{kLow}, {other}});
  EXPECT_EQ(FacesSeen(view), (std::multiset<int>{0, 1, 2}));
  EXPECT_EQ(CountOf(view, ViewArcKind::kContact), 2);
  const auto share = [](const WholeView& v, int face) {
    double sum = 0;
    for (std::size_t r = 0; r < v.regions.size(); ++r) {
      if (v.regions[r].face == face) sum += DiscShareOf(v, r, {0, 0, 1});
    }
    return sum;
  };
  const WholeView swapped = Look({{other}, {kLow}});
  EXPECT_GT(share(view, 1), share(swapped, 2));
  EXPECT_NEAR(share(view, 1) + share(view, 2),
              share(swapped, 1) + share(swapped, 2), 1e-15);
}

TEST(WholeView, KnowsContactsFromInnerEdges) {
  // A wall on a ceiling: its upper edge lies in the ceiling's face, which it
  // does not share; both wall faces share theirs.
  const WholeView view = Look({{Ceiling(-4, 4, -4, 4, 4)},
                               {{{-1, 1, 4}, {1, 1, 4}, {1, 2, 2}, {-1, 2, 2}}},
                               {{{1, 1, 4}, {2, 1, 4}, {2, 2, 2}, {1, 2, 2}}}});
  EXPECT_EQ(CountOf(view, ViewArcKind::kContact), 2);
  EXPECT_EQ(CountOf(view, ViewArcKind::kInner), 1);
  for (const WholeViewArc& arc : view.arcs) {
    if (arc.kind == ViewArcKind::kContact) {
      EXPECT_GE(arc.edge.face, 2);
    }
    if (arc.kind == ViewArcKind::kInner) {
      EXPECT_EQ(arc.edge.face, 2);
    }
  }
}

TEST(WholeView, LeavesOutFacesThroughTheReceiverAndOnItsFace) {
  const Ring through = {{1, -1, -1}, {1, -1, 3}, {1, 1, 3}, {1, 1, -1}};
  EXPECT_EQ(FacesSeen(Look({{through}, {kHigh}}, {0, 0, 1}, {1, 0, 0})),
            (std::multiset<int>{0, 2}));
  EXPECT_EQ(FacesSeen(Look({{kLow}, {kHigh}}, {0, 0, 1}, {0, 0, 0}, 1)),
            (std::multiset<int>{0, 2}));
}

TEST(WholeView, OfAFaceThatSetsHasHorizonVertices) {
  const WholeView view =
      Look({{{{-1, 2, -1}, {-1, 2, 1}, {1, 2, 1}, {1, 2, -1}}, kLamp}});
  EXPECT_EQ(FacesSeen(view), (std::multiset<int>{0, 1}));
  EXPECT_EQ(std::ranges::count_if(view.vertices,
                                  [](const WholeViewVertex& v) {
                                    return v.vertex.kind ==
                                               VertexKind::kHorizon &&
                                           v.vertex.planes == 2;
                                  }),
            2);
  EXPECT_EQ(CountOf(view, ViewArcKind::kHorizon), 2);
  EXPECT_EQ(std::ranges::count(view.arcs, true, &WholeViewArc::at_least_pi), 1);
}

TEST(WholeView, DoesNotDependOnTheOrderOfFacesAndCorners) {
  PortableRandom random(21);
  int arcs = 0;
  for (int i = 0; i < 40; ++i) {
    const bool lattice = i % 2 == 0;
    const std::vector<TestFace> faces =
        WithoutCoplanarFaces(RandomScene(random, lattice, 9));
    const Receiver receiver = RandomReceiver(random, lattice);
    std::vector<TestFace> other(faces.rbegin(), faces.rend());
    for (TestFace& face : other)
      std::rotate(face.ring.begin(), face.ring.begin() + 1, face.ring.end());
    std::vector<int> names;
    std::vector<int> other_names;
    for (int k = 1; k <= static_cast<int>(faces.size()); ++k) {
      names.push_back(k);
      other_names.insert(other_names.begin(), k);
    }
    const WholeView a = WholeViewOf({MakeScene(faces), receiver});
    const WholeView b = WholeViewOf({MakeScene(other), receiver});
    EXPECT_EQ(ArcsOf(a, names), ArcsOf(b, other_names));
    EXPECT_EQ(VerticesOf(a), VerticesOf(b));
    EXPECT_EQ(a.regions.size(), b.regions.size());
    arcs += static_cast<int>(a.arcs.size());
  }
  EXPECT_GT(arcs, 500);
}

TEST(WholeView, DoesNotDependOnWhereTheChartsAreCut) {
  // Normals along a line have other cuts; all faces are well above both
  // horizons, which do not show in what is compared.
  PortableRandom random(22);
  for (int i = 0; i < 20; ++i) {
    std::vector<TestFace> faces;
    for (TestFace& face : RandomScene(random, i % 2 == 0, 9)) {
      for (Point3& p : face.ring)
        p.z += 40;
      faces.push_back(face);
    }
    std::vector<int> names(faces.size());
    for (std::size_t k = 0; k < names.size(); ++k)
      names[k] = static_cast<int>(k) + 1;
    const auto look = [&](const Vector3& normal) {
      const WholeView view = Look(faces, normal);
      std::multiset<ArcFacts> facts = ArcsOf(view, names);
      std::erase_if(facts, [](const ArcFacts& f) {
        return std::get<0>(f) == ViewArcKind::kHorizon;
      });
      return std::pair{facts, VerticesOf(view)};
    };
    const auto first = look({0, 0, 1});
    EXPECT_EQ(look({0.125, 0.25, 3}), first);
    EXPECT_EQ(look({0, 0, 0x1p-300}), first);
    EXPECT_EQ(look({-0.3, 0.1, 1.7}), first);
  }
}

/// The largest number of edges that coincide in a vertex: seen around it, and
/// with those hidden behind.
std::pair<int, int> MostEdges(const std::string& name) {
  const auto rows = ReadNumbers(CaseFolder(name) / "receivers.csv");
  const auto& row = rows.front();
  const WholeView view =
      WholeViewOf({ReadScene(CaseFolder(name) / "scene.obj").value.value(),
                   {{row[0], row[1], row[2]}, {row[3], row[4], row[5]}, 0}});
  std::pair<int, int> most;
  for (const WholeViewVertex& v : view.vertices) {
    most.first = std::max(most.first, v.vertex.planes);
    most.second = std::max(most.second, v.planes_with_hidden);
  }
  return most;
}

TEST(WholeView, CountsTheEdgesOfConjunctions) {
  // The numbers behind are those in the cases' names and first lines; the ones
  // in front are fewer where few blockers hide all others around the point.
  EXPECT_EQ(MostEdges("c03_edges5"), (std::pair{5, 5}));
  EXPECT_EQ(MostEdges("c07_edges10"), (std::pair{3, 10}));
  EXPECT_EQ(MostEdges("c11_edges12_vertex"), (std::pair{3, 14}));
  EXPECT_EQ(MostEdges("c15_vertex_on_edge3"), (std::pair{4, 4}));
  EXPECT_EQ(MostEdges("c19_collinear_both_u"), (std::pair{3, 3}));
  EXPECT_EQ(MostEdges("c23_source_vertex8"), (std::pair{6, 10}));
  EXPECT_EQ(MostEdges("c27_coplanar_blockers"), (std::pair{6, 6}));
}

}  // namespace
}  // namespace truelux
