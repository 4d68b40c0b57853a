// SPDX-License-Identifier: GPL-3.0-or-later
#include "explain/receiver_detail.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/scenes.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

const Receiver kUp{{0, 0, 0}, {0, 0, 1}, 0};
const Ring kSource = Ceiling(-4, 4, -4, 4, 8);

ReceiverDetail Detail(const std::vector<TestFace>& faces,
                      const Receiver& receiver = kUp) {
  return DetailFinder(MakeScene(faces)).Find(receiver, true);
}

TEST(ReceiverDetail, NamesTheEdgesThatMeet) {
  // Three edges of three blockers cross at the zenith.
  const std::vector<TestFace> faces = {
      {kSource, kLamp},
      {{{1, 1, 4}, {-1, -1, 4}, {1, -1, 4}}},
      {{{1, -0.5, 2}, {-1, 0.5, 2}, {-1, -0.5, 2}}},
      {{{0, 0.25, 1}, {0, -0.25, 1}, {0.25, -0.25, 1}}}};
  const ReceiverDetail detail = Detail(faces);
  // Others coincide by the regularity of the numbers; at the zenith all three
  // blockers meet.
  const auto zenith =
      std::ranges::find_if(detail.meetings, [](const MeetingEdges& m) {
        std::vector<int> met;
        for (const SeenEdge& edge : m.edges)
          met.push_back(edge.face);
        return met == std::vector<int>{2, 3, 4};
      });
  ASSERT_NE(zenith, detail.meetings.end());
  EXPECT_EQ(zenith->planes, 3);
  EXPECT_FALSE(zenith->on_horizon);
  ReceiverDetail only;
  only.meetings = {*zenith};
  EXPECT_EQ(LinesOf(MakeScene(faces), only, 3),
            std::vector<std::string>{
                "meet: face 2, edge (1, 1, 4) to (-1, -1, 4); face 3, edge (1, "
                "-0.5, 2) to (-1, 0.5, 2); face 4, edge (0, 0.25, 1) to (0, "
                "-0.25, 1)"});
  EXPECT_NE(SummaryOf(detail).find("conjunction"), std::string::npos);
  EXPECT_EQ(detail.traits.conjunctions,
            static_cast<int>(detail.meetings.size()));
  const std::size_t lines = LinesOf(MakeScene(faces), detail, 2).size();
  EXPECT_EQ(lines, 3U);
}

TEST(ReceiverDetail, TheHorizonMeetsToo) {
  const ReceiverDetail detail =
      Detail({{{{2, -1, 0}, {2, 0, 2}, {2, 1, 0}}, kLamp}});
  const ReceiverDetail other =
      Detail({{{{2, 1, 0}, {2, 0, 2}, {2, -1, 0}}, kLamp}});
  const auto& meetings =
      detail.meetings.empty() ? other.meetings : detail.meetings;
  ASSERT_EQ(meetings.size(), 2U);
  for (const MeetingEdges& meeting : meetings)
    EXPECT_TRUE(meeting.on_horizon);
}

/// A blocker's edge that passes the source's corner (4, 4, 8) at x / z =
/// 1/2 + offset.
std::vector<TestFace> EdgeBesideCorner(double offset) {
  const double x = 2 + 4 * offset;
  return {{kSource, kLamp}, {{{x, -1, 4}, {x, 9, 4}, {9, 9, 4}, {9, -1, 4}}}};
}

TEST(ReceiverDetail, MeasuresANearConjunctionDownToTheLastBits) {
  for (const double offset : {1e-7, 1e-12, 0x1p-53}) {
    for (const double side : {-1.0, 1.0}) {
      const ReceiverDetail detail = Detail(EdgeBesideCorner(side * offset));
      ASSERT_TRUE(detail.nearest.has_value());
      // From the direction (1, 1, 2) to the plane x = (1/2 + offset) z; where
      // the edge cuts the corner off, the corner is not seen but the crossings
      // beside it are.
      const double angle =
          detail.nearest->angle / (offset * 2 / std::sqrt(6.0 * 1.25));
      EXPECT_GT(angle, 0.5) << offset * side;
      EXPECT_LT(angle, 2) << offset * side;
      EXPECT_TRUE(detail.meetings.empty());
      EXPECT_NE(SummaryOf(detail).find("near-conjunction ("),
                std::string::npos);
    }
  }
  // Exactly through it: that is a conjunction, and nothing is near.
  const ReceiverDetail exact = Detail(EdgeBesideCorner(0));
  EXPECT_GE(exact.traits.conjunctions, 1);
  ASSERT_TRUE(exact.nearest.has_value());
  EXPECT_GT(exact.nearest->angle, 0.05);
}

TEST(ReceiverDetail, OfALoneSquareTheNearestEdgeIsThatOfTheNextCorner) {
  const ReceiverDetail detail = Detail({{kSource, kLamp}});
  ASSERT_TRUE(detail.nearest.has_value());
  // From the corner (1, 1, 2) to the edge x = -1/2 z.
  EXPECT_NEAR(detail.nearest->angle, std::acos(4.0 / 6), 1e-12);
}

TEST(ReceiverDetail, EdgesAreNamedByTheFirstFaceThatHasThem) {
  // Two blockers share the edge from (0, -1, 4) to (0, 1, 4): no edge of the
  // contour; their outer edges pass the source's edges.
  const ReceiverDetail detail = Detail({{kSource, kLamp},
                                        {Ceiling(-1, 0, -2, 1, 4)},
                                        {Ceiling(0, 1, -2, 1, 4)}});
  std::set<int> faces;
  for (const MeetingEdges& meeting : detail.meetings) {
    for (const SeenEdge& edge : meeting.edges) {
      faces.insert(edge.face);
      EXPECT_LT(edge.a, edge.b);
    }
  }
  EXPECT_TRUE(faces.contains(1));
  EXPECT_TRUE(faces.contains(2));
  EXPECT_TRUE(faces.contains(3));
}

}  // namespace
}  // namespace truelux
