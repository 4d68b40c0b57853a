// SPDX-License-Identifier: GPL-3.0-or-later
// Objects on a plan: outlines, what is cut off, and what is left out.

#include "plan/object_drawing.h"

#include <cstddef>
#include <limits>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "plan/made_isolux.h"
#include "support/well_formed.h"

namespace truelux {
namespace {

using testing::CountOf;
using testing::MadeFloor;
using testing::MarkupDefect;

using Faces = std::vector<std::vector<Point3>>;

/// Of a floor of 10 by 8 on 1000 by 800 px.
Paper FloorPaper() {
  return {MadeFloor(10, 8), {0, 0, 1000, 1000}};
}

std::vector<Point3> Level(double x, double y, double to_x, double to_y,
                          double z = 2) {
  return {{x, y, z}, {to_x, y, z}, {to_x, to_y, z}, {x, to_y, z}};
}

/// A box with its six faces.
Faces Box(double x, double y, double to_x, double to_y) {
  Faces faces = {Level(x, y, to_x, to_y, 3), Level(x, y, to_x, to_y, 2)};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    faces.push_back({faces[0][i], faces[0][next], faces[1][next], faces[1][i]});
  }
  return faces;
}

ObjectDrawing Draw(const std::vector<PlanObject>& objects) {
  ObjectDrawing drawing = DrawObjects(objects, FloorPaper());
  EXPECT_EQ(MarkupDefect("<svg>" + drawing.elements + "</svg>"), "");
  return drawing;
}

ObjectDrawing Draw(const Faces& faces, bool emits = false) {
  return Draw({{"thing", emits, faces}});
}

/// The data of all paths, each with a blank behind.
std::string PathsOf(const ObjectDrawing& drawing) {
  static const std::regex path("<path d=\"([^\"]*)\"");
  std::string paths;
  const std::string& text = drawing.elements;
  for (std::sregex_iterator i(text.begin(), text.end(), path);
       i != std::sregex_iterator(); ++i)
    paths += (*i)[1].str() + " ";
  return paths;
}

TEST(ObjectDrawing, ProjectsAlongTheNormal) {
  const ObjectDrawing drawing = Draw({{{1, 1, 2}, {2, 1, 5}, {1, 3, 3}}});
  EXPECT_EQ(PathsOf(drawing), "M100 500L200 700 100 700Z ");
  EXPECT_TRUE(drawing.has_objects);
  EXPECT_FALSE(drawing.has_lamps);
  EXPECT_EQ(CountOf(drawing.elements, kObjectStyle), 1U);
  EXPECT_EQ(CountOf(drawing.elements, "<title>thing</title>"), 1U);
}

TEST(ObjectDrawing, FacesOfOneObjectAreOneArea) {
  EXPECT_EQ(PathsOf(Draw({Level(1, 1, 2, 2), Level(2, 1, 3, 2)})),
            "M100 600L200 600 300 600 300 700 200 700 100 700Z ");
  // Both turn the same way, so that what they have in common is filled.
  EXPECT_EQ(PathsOf(Draw({Level(1, 1, 3, 3), Level(2, 4, 4, 2)})),
            "M100 500L300 500 300 700 100 700Z"
            "M200 400L400 400 400 600 200 600Z ");
  const std::string two = PathsOf(Draw(
      {{"a", false, {Level(1, 1, 2, 2)}}, {"b", false, {Level(2, 1, 3, 2)}}}));
  EXPECT_EQ(CountOf(two, "M"), 2U);
}

TEST(ObjectDrawing, WallsAreNotSeenFromAbove) {
  EXPECT_EQ(PathsOf(Draw(Box(1, 1, 2, 3))),
            "M100 500L200 500 200 700 100 700Z"
            "M100 500L200 500 200 700 100 700Z ");
  // As inclined as rounding to hundredths does not show.
  EXPECT_EQ(
      Draw({{{1, 1, 1}, {5, 1, 1}, {5, 1.00003, 9}, {1, 1.00003, 9}}}).elements,
      "");
  EXPECT_NE(
      Draw({{{1, 1, 1}, {5, 1, 1}, {5, 1.001, 9}, {1, 1.001, 9}}}).elements,
      "");
  // 0.008 px^2
  EXPECT_EQ(Draw({Level(1, 1, 1.0008, 1.0010)}).elements, "");
  EXPECT_NE(Draw({Level(1, 1, 1.0012, 1.0010)}).elements, "");
}

TEST(ObjectDrawing, LampsAreOnceAndNotFilled) {
  const ObjectDrawing drawing = Draw(Box(1, 1, 2, 3), true);
  EXPECT_EQ(PathsOf(drawing), "M100 500L200 500 200 700 100 700Z ");
  EXPECT_EQ(CountOf(drawing.elements, kLampStyle), 1U);
  EXPECT_EQ(CountOf(drawing.elements, kObjectStyle), 0U);
  EXPECT_TRUE(drawing.has_lamps);
  EXPECT_FALSE(drawing.has_objects);
}

TEST(ObjectDrawing, LampsLieOverOtherObjects) {
  const std::string text = Draw({{"lamp", true, {Level(1, 1, 2, 2)}},
                                 {"desk", false, {Level(1, 1, 2, 2)}}})
                               .elements;
  EXPECT_LT(text.find("<title>desk"), text.find("<title>lamp"));
}

TEST(ObjectDrawing, WhatWouldHideThePlanIsLeftOut) {
  EXPECT_EQ(Draw({Level(0, 0, 7.6, 8)}).elements, "");
  EXPECT_NE(Draw({Level(0, 0, 7.4, 8)}).elements, "");
  // The box around it counts, within the plan.
  EXPECT_EQ(Draw({Level(0, 0, 1, 1), Level(9, 7, 10, 8)}).elements, "");
  for (const auto& shown :
       {Level(-50, -50, 7.46, 50), Level(2.54, -50, 50, 50),
        Level(-50, -50, 50, 5.96), Level(-50, 2.04, 50, 50)})
    EXPECT_NE(Draw({shown}).elements, "");
  for (const auto& hiding :
       {Level(-50, -50, 7.54, 50), Level(2.46, -50, 50, 50),
        Level(-50, -50, 50, 6.04), Level(-50, 1.96, 50, 50)})
    EXPECT_EQ(Draw({hiding}).elements, "");
  // Nothing is hidden by lamps.
  EXPECT_NE(Draw({Level(0, 0, 1, 1), Level(9, 7, 10, 8)}, true).elements, "");
}

TEST(ObjectDrawing, IsCutOffOutOfSight) {
  EXPECT_EQ(PathsOf(Draw({Level(-5, 2, 5, 4)})),
            "M-8 400L500 400 500 600 -8 600Z ");
  const std::string text = Draw({Level(8, 7, 1e7, 1e9)}).elements;
  EXPECT_EQ(CountOf(text, "M800 -8L1008 -8 1008 100 800 100Z"), 1U) << text;
  EXPECT_EQ(CountOf(text,
                    "<clipPath id=\"plan_area\"><rect x=\"0.00\" "
                    "y=\"0.00\" width=\"1000.00\" height=\"800.00\"/>"),
            1U);
  EXPECT_EQ(CountOf(text, "clip-path=\"url(#plan_area)\""), 1U);
  EXPECT_EQ(PathsOf(Draw({Level(-1e9, -1e8, 1, 1)})),
            "M-8 700L100 700 100 808 -8 808Z ");
  // Beside the plan, and in the margin where nothing is seen.
  EXPECT_EQ(Draw({Level(11, 1, 12, 2)}).elements, "");
  EXPECT_EQ(Draw({Level(10.01, 1, 12, 2)}).elements, "");
  EXPECT_EQ(Draw({Level(1, -2, 2, -0.01)}).elements, "");
}

TEST(ObjectDrawing, AnyCoordinatesAreDrawn) {
  for (const double far : {1e12, 1e300, 1e308}) {
    const std::string text =
        Draw({{{1, 1, 2}, {far, 1, 2}, {1, far, far}}, Level(1, 1, 2, 2)})
            .elements;
    EXPECT_EQ(CountOf(text, "nan"), 0U) << text;
    EXPECT_EQ(CountOf(text, "inf"), 0U) << text;
  }
  // On no paper: a face is missing then.
  EXPECT_EQ(
      PathsOf(Draw({{{4, 4, 2}, {1e308, 4, 2}, {4, 5, 2}}, Level(1, 1, 2, 2)})),
      "M100 600L200 600 200 700 100 700Z ");
  const Faces one = {Level(1, 1, 2, 2)};
  for (const Paper& paper : {Paper(Isolux{}, {0, 0, 1000, 1000}),
                             Paper(MadeFloor(10, 0), {0, 0, 1000, 1000})}) {
    EXPECT_EQ(
        DrawObjects(std::vector<PlanObject>{{"", false, one}}, paper).elements,
        "");
  }
}

TEST(ObjectDrawing, OfTooManyCornersTheBoxIsDrawn) {
  const auto leaves = [](int count) {
    Faces faces;
    for (int i = 0; i < count; ++i) {
      const int row = i / 100;
      const double x = 2 + 0.03 * (i % 100);
      const double y = 1 + 0.03 * row;
      faces.push_back({{x, y, 2}, {x + 0.02, y, 2}, {x, y + 0.02, 3}});
    }
    return faces;
  };
  const auto path = [](const std::string& text) {
    const std::size_t at = text.find(" d=\"") + 4;
    return text.substr(at, text.find('"', at) - at);
  };
  const std::string few =
      DrawObjects(std::vector<PlanObject>{{"tree", false, leaves(6666)}},
                  FloorPaper())
          .elements;
  EXPECT_EQ(CountOf(path(few), "M"), 6666U);
  EXPECT_EQ(CountOf(few, "<title>tree</title>"), 1U);
  const std::string many =
      DrawObjects(std::vector<PlanObject>{{"tree", false, leaves(6667)}},
                  FloorPaper())
          .elements;
  EXPECT_EQ(path(many), "M200.00 500.00H499.00V700.00H200.00Z");
  EXPECT_EQ(CountOf(many, "<title>tree (the box around it, "), 1U);
}

TEST(ObjectDrawing, NamesAreEscapedOrMissing) {
  const Faces one = {Level(1, 1, 2, 2)};
  const std::string text =
      Draw({{"<a&\"\xFF\x01", false, one}, {"", true, one}}).elements;
  EXPECT_EQ(CountOf(text, "<title>&lt;a&amp;"), 1U);
  EXPECT_EQ(CountOf(text, "<title>without a name</title>"), 1U);
}

}  // namespace
}  // namespace truelux
