// SPDX-License-Identifier: GPL-3.0-or-later
// truelux inspect from outside: what it writes, and what it refuses.

#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/program.h"
#include "support/well_formed.h"

namespace truelux::test {
namespace {

using Json = nlohmann::json;
using testing::CountOf;
using Words = std::vector<std::string>;

Words Inspect(const std::string& scene, const Words& more) {
  Words words = {"inspect", scene, "--at", "0,0,0", "--normal", "0,0,2"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(Inspect, WritesPictureAndNumbers) {
  const TemporaryFolder folder;
  const std::string scene = WriteSquare(folder);
  const Outcome outcome = RunTruelux(
      Inspect(scene, {"-o", folder / "v.svg", "--json", folder / "v.json"}));
  ASSERT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_EQ(outcome.out + outcome.err, "");
  const std::string svg = ReadFile(folder / "v.svg");
  EXPECT_EQ(testing::MarkupDefect(svg), "");
  EXPECT_NE(svg.find("0.554126"), svg.npos);
  EXPECT_NE(svg.find("square.obj"), svg.npos);

  const Json json = Json::parse(ReadFile(folder / "v.json"));
  EXPECT_EQ(json["scene"], "square.obj");
  EXPECT_EQ(json["receiver"]["normal"], (Json{0, 0, 2}));
  EXPECT_TRUE(json["receiver"]["on_face"].is_null());
  ASSERT_EQ(json["sources"].size(), 1U);
  const double form_factor = json["sources"][0]["form_factor"];
  EXPECT_NEAR(form_factor,
              4 / (std::numbers::pi * std::numbers::sqrt2) *
                  std::atan(1 / std::numbers::sqrt2),
              1e-15);
  // 4 asin(1/2), and exactly a third of the hemisphere.
  EXPECT_NEAR(json["sources"][0]["solid_angle"], 2 * std::numbers::pi / 3,
              1e-14);
  EXPECT_EQ(json["irradiance"][0], form_factor);
  EXPECT_EQ(json["derivatives"]["status"], "C1");
  EXPECT_EQ(json["derivatives"]["vector_irradiance"].size(), 3U);
  EXPECT_EQ(json["derivatives"]["gradient"][0].size(), 3U);
  EXPECT_EQ(CountOf(svg, "25 % of dE/dr: r "), 8U);  // arcs and their bands
  double share = 0;
  for (const Json& arc : json["arcs"]) {
    const bool is_horizon = arc["kind"] == "horizon";
    EXPECT_EQ(arc["gradient"].size(), 3U);
    EXPECT_EQ(arc["gradient"][0] == (Json{0.0, 0.0, 0.0}), is_horizon);
    share += arc["gradient_share"][0].get<double>();
  }
  EXPECT_NEAR(share, 1, 1e-14);
  ASSERT_EQ(json["regions"].size(), 2U);
  ASSERT_EQ(json["arcs"].size(), 5U);
  ASSERT_EQ(json["vertices"].size(), 4U);
  for (const Json& vertex : json["vertices"]) {
    EXPECT_EQ(vertex["kind"], "intrinsic");
    EXPECT_EQ(vertex["coinciding_edges"], 2);
    EXPECT_EQ(vertex["edges"].size(), 2U);
    EXPECT_EQ(vertex["position"], vertex["direction"]);
  }
}

TEST(Inspect, NumbersFitTogether) {
  const Outcome outcome = RunTruelux(
      {"inspect", std::string(TRUELUX_EXAMPLES) + "/scenes/cornell_box.obj",
       "--at", "231,0,288", "--normal", "0,1,0", "--on-face", "1", "--json",
       "-"});
  ASSERT_EQ(outcome.exit_status, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  double solid_angle = 0;
  for (std::size_t r = 0; r < json["regions"].size(); ++r) {
    const Json& region = json["regions"][r];
    solid_angle += region["solid_angle"].get<double>();
    for (const Json& loop : region["loops"]) {
      const std::size_t size = loop["arcs"].size();
      ASSERT_EQ(loop["vertices"].size(), size);
      for (std::size_t i = 0; i < size; ++i) {
        const Json& arc = json["arcs"][loop["arcs"][i].get<std::size_t>()];
        const bool forward = arc["left"] == r;
        EXPECT_TRUE(forward || arc["right"] == r);
        EXPECT_EQ(arc[forward ? "from" : "to"], loop["vertices"][i]);
        EXPECT_EQ(arc[forward ? "to" : "from"],
                  loop["vertices"][(i + 1) % size]);
      }
    }
  }
  EXPECT_NEAR(solid_angle, 2 * std::numbers::pi, 1e-13);
  EXPECT_EQ(json["sources"][0]["group"], "light");
}

TEST(Inspect, BothProjectionsAndSizesAreWellFormed) {
  const TemporaryFolder folder;
  const std::string scene = WriteSquare(folder);
  for (const char* projection : {"nusselt", "gnomonic"}) {
    for (const char* size : {"640", "2000"}) {
      const Outcome outcome = RunTruelux(Inspect(
          scene, {"-o", "-", "--projection", projection, "--size", size}));
      ASSERT_EQ(outcome.exit_status, 0) << outcome.err;
      EXPECT_EQ(testing::MarkupDefect(outcome.out), "");
      EXPECT_NE(outcome.out.find(std::string("width=\"") + size),
                outcome.out.npos);
    }
  }
}

TEST(Inspect, EmissionAsRadianceMultipliesByPi) {
  const TemporaryFolder folder;
  const std::string scene = WriteSquare(folder);
  const auto red = [&](const char* emission) {
    const Outcome outcome =
        RunTruelux(Inspect(scene, {"--json", "-", "--emission", emission}));
    return Json::parse(outcome.out)["irradiance"][0].get<double>();
  };
  EXPECT_DOUBLE_EQ(red("radiance"), std::numbers::pi * red("exitance"));
}

TEST(Inspect, RefusesWhatSaysNothing) {
  const TemporaryFolder folder;
  const std::string scene = WriteSquare(folder);
  const auto expect_error = [&](const Words& words, const char* what) {
    const Outcome outcome = RunTruelux(words);
    EXPECT_EQ(outcome.exit_status, 2);
    EXPECT_NE(outcome.err.find(what), outcome.err.npos) << outcome.err;
    EXPECT_EQ(folder.Names(), (Words{"square.mtl", "square.obj"}));
  };
  const std::string svg = folder / "v.svg";
  expect_error(Inspect(scene, {}), "nothing to write");
  expect_error(Inspect(scene, {"-o", "-", "--json", "-"}), "--json");
  expect_error(Inspect(scene, {"-o", svg, "--json", svg}), "--json");
  expect_error(Inspect(scene, {"-o", scene}), "square.obj");
  expect_error(Inspect(scene, {"-o", svg, "--on-face", "2"}), "--on-face");
  expect_error(Inspect(scene, {"-o", svg, "--size", "20"}), "--size");
  expect_error(Inspect(scene, {"-o", svg, "--projection", "flat"}),
               "--projection");
  expect_error(
      {"inspect", scene, "--at", "0,0", "--normal", "0,0,1", "-o", svg},
      "--at");
  expect_error(
      {"inspect", scene, "--at", "0,0,0", "--normal", "0,0,0", "-o", svg},
      "--normal");
  expect_error({"inspect", folder / "none.obj", "--at", "0,0,0", "--normal",
                "0,0,1", "-o", svg},
               "none.obj");
}

}  // namespace
}  // namespace truelux::test
