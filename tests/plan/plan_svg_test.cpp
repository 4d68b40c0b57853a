// SPDX-License-Identifier: GPL-3.0-or-later
// Plans: well-formed, no text off the picture, all that they must show.

#include "plan/plan_svg.h"

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "plan/made_isolux.h"
#include "support/well_formed.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

/// What stands in the picture [px].
struct SeenText {
  std::string text;
  double left = 0;
  double right = 0;
  double top = 0;
  double bottom = 0;
};

std::string AttributeOf(const std::string& tag, const std::string& name) {
  std::smatch found;
  const std::regex attribute("[ ]" + name + "=\"([^\"]*)\"");
  return std::regex_search(tag, found, attribute) ? found[1].str() : "";
}

double NumberOf(const std::string& tag, const std::string& name) {
  return std::strtod(AttributeOf(tag, name).c_str(), nullptr);
}

/// By the mean width of letters, generously.
std::vector<SeenText> TextsOf(const std::string& svg) {
  constexpr double kWide = 0.56;
  static const std::regex entity("&[a-z]+;");
  std::vector<SeenText> texts;
  const std::regex element("<text([^>]*)>([^<]*)</text>");
  for (std::sregex_iterator i(svg.begin(), svg.end(), element);
       i != std::sregex_iterator(); ++i) {
    const std::string tag = (*i)[1];
    SeenText seen{(*i)[2]};
    const double size = NumberOf(tag, "font-size");
    double count = 0;
    for (const char c : std::regex_replace(seen.text, entity, "x")) {
      if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U) ++count;
    }
    const double width = kWide * size * count;
    double x = NumberOf(tag, "x");
    double y = NumberOf(tag, "y");
    double reach = 0;
    const std::string turned = AttributeOf(tag, "transform");
    if (!turned.empty()) {
      std::smatch at;
      EXPECT_TRUE(std::regex_match(
          turned, at,
          std::regex(R"(translate\((\S+) (\S+)\) rotate\((\S+)\))")));
      EXPECT_LE(std::fabs(std::stod(at[3])), 90);
      x = std::stod(at[1]);
      y = std::stod(at[2]);
      reach = std::fabs(std::sin(std::stod(at[3]) * std::numbers::pi / 180)) *
              width / 2;
    }
    const std::string anchor = AttributeOf(tag, "text-anchor");
    seen.left = anchor == "start" ? x : x - width / 2;
    seen.right = seen.left + width;
    seen.top = y - size - reach;
    seen.bottom = y + 0.3 * size + reach;
    texts.push_back(seen);
  }
  return texts;
}

void ExpectAllInside(const std::string& svg) {
  const std::string tag = svg.substr(0, svg.find('>'));
  const double width = NumberOf(tag, "width");
  const double height = NumberOf(tag, "height");
  EXPECT_GT(width, 300);
  EXPECT_LT(width, 1300);
  for (const SeenText& seen : TextsOf(svg)) {
    EXPECT_GE(seen.left, 0) << seen.text;
    EXPECT_LE(seen.right, width) << seen.text;
    EXPECT_GE(seen.top, 0) << seen.text;
    EXPECT_LE(seen.bottom, height) << seen.text;
  }
}

bool HasText(const std::string& svg, const std::string& text) {
  return svg.find(">" + text + "</text>") != std::string::npos;
}

TEST(PlanSvg, ShowsAllThatThereIs) {
  const std::string svg = PlanSvg(MadeIsolux(), MadeSubject());
  EXPECT_EQ(MarkupDefect(svg), "");
  ExpectAllInside(svg);
  EXPECT_EQ(svg, PlanSvg(MadeIsolux(), MadeSubject()));
  for (const char* id : {"kinks", "jumps", "open", "contours", "labels"})
    EXPECT_EQ(CountOf(svg, "id=\"" + std::string(id) + "\""), 1U) << id;
  EXPECT_TRUE(HasText(svg, "Isolux lines on floor"));
  EXPECT_TRUE(HasText(svg, "Irradiance, luminance [W/m²]"));
  EXPECT_TRUE(HasText(svg, "7 (no line)"));
  EXPECT_TRUE(HasText(svg, "0.1"));
  EXPECT_NE(svg.find("<title>irradiance jumps: 1, 2, 3 on the left, 0, 0, 0 on "
                     "the right; faces 3 5</title>"),
            svg.npos);
  EXPECT_NE(svg.find("edges 11-13;cut</title>"), svg.npos);
  EXPECT_NE(svg.find("W/m², closed, 90 vertices; within"), svg.npos);
  EXPECT_NE(svg.find("1 not certified; how far"), svg.npos);
  EXPECT_NE(svg.find("open: irradiance from 0 to 0.75"), svg.npos);
  EXPECT_NE(svg.find("2 (the scene"), svg.npos);  // the scale
}

TEST(PlanSvg, EveryLevelWithALineIsOnALine) {
  const std::string svg = PlanSvg(MadeIsolux(), MadeSubject());
  const std::string labels = svg.substr(svg.find("id=\"labels\""));
  const std::string own = labels.substr(0, labels.find("</g>"));
  for (const char* level : {"0.1", "0.2", "0.3", "0.4", "0.5"})
    EXPECT_GE(CountOf(own, ">" + std::string(level) + "<"), 1U) << level;
  EXPECT_EQ(CountOf(own, ">7<"), 0U);
}

TEST(PlanSvg, OpenTrianglesAreSeenHoweverSmallTheyAre) {
  Isolux isolux = MadeFloor(10, 8);
  for (int i = 0; i < 1000; ++i) {
    const double x = 5 + 1e-6 * i;
    isolux.open.push_back(
        {{{{x, 5, 1}, {x + 1e-6, 5, 1}, {x, 5.1e0, 1}}}, 0, 1});
    isolux.open.push_back(
        {{{{x, 2, 1}, {x + 1e-6, 2, 1}, {x, 2.000001, 1}}}, 0, 1});
  }
  const std::string svg = PlanSvg(isolux, MadeSubject());
  EXPECT_EQ(MarkupDefect(svg), "");
  EXPECT_EQ(CountOf(svg, "<title>open: "), 1000U);
  const std::string rings = svg.substr(svg.find("id=\"open_rings\""));
  EXPECT_EQ(CountOf(rings.substr(0, rings.find("</g>")), "<circle"), 1U);
}

// Up is up and right is right: the corner of the open triangle.
TEST(PlanSvg, LooksFromTheLitSide) {
  Isolux isolux = MadeFloor(10, 8);
  isolux.open.push_back({{{{0, 0, 1}, {10, 0, 1}, {0, 8, 1}}}, 0, 1});
  const auto path = [&isolux] {
    const std::string svg = PlanSvg(isolux, MadeSubject());
    const std::string open = svg.substr(svg.find("id=\"open\""));
    return open.substr(open.find(" d=\"") + 4, 44);
  };
  EXPECT_TRUE(path().starts_with("M24.00 700.00L804.00 700.00 24.00 76.00Z"))
      << path();
  isolux.right = {-1, 0, 0};  // seen from below
  EXPECT_TRUE(path().starts_with("M804.00 700.00L24.00 700.00 804.00 76.00Z"))
      << path();
}

TEST(PlanSvg, WallsAroundTheSurfaceAreItsEdge) {
  Isolux isolux = MadeFloor(10, 8);
  for (std::size_t i = 1; i < 4; ++i) {
    SurfaceLine& wall = isolux.lines.lines.emplace_back();
    wall.kind = SurfaceLineKind::kJump;
    wall.ends = isolux.outline[i];
  }
  isolux.outline.resize(1);
  const std::string svg = PlanSvg(isolux, MadeSubject());
  EXPECT_NE(svg.find("M804.00 76.00L24.00 76.00"), svg.npos);
}

TEST(PlanSvg, ObjectsLieUnderTheLinesAndAreInTheLegend) {
  PlanSubject subject = MadeSubject();
  const std::string without = PlanSvg(MadeIsolux(), subject);
  EXPECT_EQ(CountOf(without, "id=\"objects\""), 0U);
  EXPECT_FALSE(HasText(without, "objects above, from above"));
  EXPECT_FALSE(HasText(without, "lamps"));
  subject.objects = {
      {"desk", false, {{{1, 1, 2}, {2, 1, 2}, {2, 2, 2}, {1, 2, 2}}}}};
  const std::string desk = PlanSvg(MadeIsolux(), subject);
  EXPECT_TRUE(HasText(desk, "objects above, from above"));
  EXPECT_FALSE(HasText(desk, "lamps"));
  subject.objects.push_back(
      {"bulb", true, {{{3, 3, 9}, {4, 3, 9}, {4, 4, 9}}}});
  const std::string both = PlanSvg(MadeIsolux(), subject);
  EXPECT_EQ(MarkupDefect(both), "");
  ExpectAllInside(both);
  EXPECT_TRUE(HasText(both, "objects above, from above"));
  EXPECT_TRUE(HasText(both, "lamps"));
  EXPECT_EQ(CountOf(both, "id=\"objects\""), 1U);
  for (const char* id : {"kinks", "outline", "jumps", "open", "contours"})
    EXPECT_LT(both.find("<title>bulb<"), both.find(id)) << id;
}

TEST(PlanSvg, OddSurfacesAndNamesFit) {
  PlanSubject subject = MadeSubject();
  subject.channel = "r";
  subject.surface = "<&\"\xFF" + std::string(300, 'W');
  subject.scene = std::string(300, 'm') + ".obj";
  for (const double height : {1e-3, 1.0, 1e4}) {
    for (const double scale : {1e-200, 1.0, 1e200}) {
      Isolux isolux = MadeFloor(scale, height * scale);
      isolux.levels = {0.1 + 0.2, 1e300 / 3};
      const std::string svg = PlanSvg(isolux, subject);
      EXPECT_EQ(MarkupDefect(svg), "");
      EXPECT_EQ(CountOf(svg, "nan"), 0U) << scale;
      EXPECT_EQ(CountOf(svg, "inf "), 0U) << scale;
      ExpectAllInside(svg);
    }
  }
  const std::string nothing = PlanSvg(Isolux{}, subject);
  EXPECT_EQ(MarkupDefect(nothing), "");
  EXPECT_TRUE(HasText(nothing, "no levels"));
  ExpectAllInside(nothing);
}

TEST(PlanSvg, ManyLevelsFit) {
  Isolux isolux = MadeFloor(10, 10);
  for (int i = 0; i < 500; ++i) {
    isolux.levels.push_back(1 + i);
    isolux.contours.push_back(
        MadeCircle(1 + i, 5, 5, 4.9 - 0.0097 * i, true, 30));
  }
  const std::string svg = PlanSvg(isolux, MadeSubject());
  EXPECT_EQ(MarkupDefect(svg), "");
  ExpectAllInside(svg);
}

}  // namespace
}  // namespace truelux
