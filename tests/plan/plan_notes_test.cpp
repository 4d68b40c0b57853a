// SPDX-License-Identifier: GPL-3.0-or-later
// What is proven, in words: nothing is claimed that an Isolux does not say.

#include "plan/plan_notes.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "plan/made_isolux.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

TEST(PlanNotes, SayWhatIsKnownAndWhatIsNot) {
  const std::vector<std::string> expected = {
      "11 contours at 8 levels, 994 vertices: 1 is not certified, the others "
      "certified within 1e-09",
      "1 triangle (0.16 % of the surface) is open: contours that were not "
      "found "
      "lie there",
      "for 1 of 990 chords it is not known how far the contour is; contours "
      "are "
      "within 0.0033 of the other chords",
      "no light reaches 10 % of the surface",
      "irradiance from 0 to 0.8125 W/m^2 was met",
      "1 line where irradiance may jump, 1 line where its gradient does"};
  EXPECT_EQ(PlanNotes(MadeIsolux()), expected);
  EXPECT_EQ(
      WorkNote(MadeIsolux()),
      "irradiance was asked for 1000 times to settle which contours there "
      "are, and 4.0 times a vertex to place them");
}

TEST(PlanNotes, SayIfNothingIsMissing) {
  Isolux isolux = MadeFloor(1, 1);
  isolux.levels = {0.5};
  isolux.contours = {MadeCircle(0.5, 0.5, 0.5, 0.25, true)};
  const std::vector<std::string> notes = PlanNotes(isolux);
  EXPECT_EQ(notes[0],
            "1 contour at 1 level, 90 vertices, all certified within 1e-09");
  EXPECT_EQ(notes[1], "no contour of these levels is missing");
  EXPECT_EQ(notes[2], "contours are within 0.00025 of their chords");
  for (IsoluxVertex& vertex : isolux.contours[0].vertices)
    vertex.is_certified = false;
  EXPECT_EQ(PlanNotes(isolux)[0],
            "1 contour at 1 level, 90 vertices, none of them certified");
  isolux.contours.clear();
  EXPECT_EQ(PlanNotes(isolux)[0], "0 contours at 1 level, no vertices");
}

TEST(PlanNotes, WithoutLevelsClaimNothingAboutContours) {
  for (const std::string& note : PlanNotes(MadeFloor(1, 1)))
    EXPECT_EQ(note.find("contour"), std::string::npos) << note;
}

TEST(PlanNotes, NumbersAreShort) {
  EXPECT_EQ(ShortNumber(0), "0");
  EXPECT_EQ(ShortNumber(6.66e-7), "6.7e-07");
  EXPECT_EQ(ShortNumber(99.7), "100");
  EXPECT_EQ(ShortNumber(1234.5), "1234");
  EXPECT_EQ(ShortNumber(1.25e9), "1.2e+09");
  EXPECT_EQ(ShareText(3, 3), "100 %");
  EXPECT_EQ(ShareText(1, 8), "12 %");
  EXPECT_EQ(ShareText(0, 0), "0 %");
}

TEST(PlanNotes, BoundsAreNotRoundedDown) {
  Isolux isolux = MadeFloor(1, 1);
  isolux.levels = {1};
  isolux.contours.push_back(MadeCircle(1, 0.5, 0.5, 0.25, true));
  for (IsoluxVertex& vertex : isolux.contours[0].vertices) {
    vertex.is_certified = true;
    vertex.half_width = 1.04e-7;
  }
  isolux.contours[0].widths.assign(isolux.contours[0].vertices.size(), 3.333);
  EXPECT_NE(PlanNotes(isolux)[0].find("certified within 1.1e-07"),
            std::string::npos);
  EXPECT_NE(PlanNotes(isolux)[2].find("within 3.4 of their chords"),
            std::string::npos);
}

TEST(PlanNotes, CountExtrema) {
  SurfaceExtrema extrema;
  extrema.least = 0.25;
  extrema.most = 2;
  EXPECT_EQ(ExtremaNotes(extrema),
            (std::vector<std::string>{
                "proven are 0 maxima, 0 minima and 0 saddles",
                "irradiance on the whole surface is proven to be from 0.25 to "
                "2 W/m^2"}));
  extrema.points.resize(2);
  extrema.points[1].kind = ExtremumKind::kSaddle;
  extrema.undecided.resize(3);
  extrema.area = 8;
  extrema.undecided_area = 1;
  EXPECT_EQ(ExtremaNotes(extrema)[0],
            "proven are 1 maximum, 0 minima and 1 saddle");
  EXPECT_EQ(ExtremaNotes(extrema)[1],
            "further ones may be in 3 regions (12 % of the surface)");
}

TEST(PlanNotes, SayIfLinesMayBeMissing) {
  SurfaceLines lines;
  EXPECT_EQ(LineNotes(lines).size(), 1U);
  lines.is_complete = false;
  EXPECT_TRUE(std::ranges::any_of(LineNotes(lines), [](const auto& note) {
    return note.find("may be missing") != std::string::npos;
  }));
}

}  // namespace
}  // namespace truelux
