// SPDX-License-Identifier: GPL-3.0-or-later
// Small files as other programs write them, with the irradiance that they have.
// Lamp: side 2 at height 2, M = 10; alone it gives
// 10 (4 / pi) (1 / sqrt 5) atan(1 / sqrt 5) straight below.

#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "truelux/irradiance.h"

#include "support/scene_text.h"

namespace truelux {
namespace {

constexpr const char* kLampOnly =
    "v -1 -1 2\nv -1 1 2\nv 1 1 2\nv 1 -1 2\nusemtl lamp\nf 1 2 3 4\n";
constexpr const char* kLampMaterial = "newmtl lamp\nKe 10 10 10\n";
constexpr double kLampValue = 2.394564704607735;

/// Faces behind the lamp's, whose vertices are 1 to 4.
struct RealFile {
  const char* name;
  const char* more;
  Point3 at;
  double value;
  const char* note;  ///< a part of what is said; "": nothing is
  ReadOptions options{};
};

void PrintTo(const RealFile& file, std::ostream* out) {
  *out << file.name;
}

class RealFiles : public testing::TestWithParam<RealFile> {};

TEST_P(RealFiles, HaveTheirValueInEveryEngine) {
  const RealFile& file = GetParam();
  const Result<Scene> scene =
      ReadSceneText(std::string(kLampOnly) + file.more,
                    std::string(kLampMaterial) +
                        "newmtl cloth\nnewmtl Glass_clear\nd 0.05\nillum 4\n",
                    file.options);
  ASSERT_TRUE(scene.ok()) << TextOf(scene.diagnostics);
  const std::string said = TextOf(scene.diagnostics);
  EXPECT_NE(said.find(file.note), std::string::npos) << said;
  EXPECT_EQ(said.empty(), std::string(file.note).empty()) << said;
  for (const Engine engine :
       {Engine::kContour, Engine::kArrangement, Engine::kAngularSpans}) {
    OracleOptions options;
    options.engine = engine;
    const Oracle oracle(*scene.value, options);
    const double down = file.at.z > 2 ? -1 : 1;
    EXPECT_EQ(oracle.Evaluate({file.at, {0, 0, down}}).value[0], file.value)
        << Name(engine);
  }
}

constexpr const char* kKeyhole =
    "v -3 -3 1\nv 3 -3 1\nv 3 3 1\nv -3 3 1\n"
    "v -0.5 -0.5 1\nv -0.5 0.5 1\nv 0.5 0.5 1\nv 0.5 -0.5 1\n"
    "usemtl cloth\nf 5 6 7 8 5 9 10 11 12 9\n";

/// Two triangles that touch in a point, as one ring.
constexpr const char* kHourglass =
    "v -2 -2 1\nv 2 -2 1\nv 0 0 1\nv 2 2 1\nv -2 2 1\nv 0 0 1\n"
    "usemtl cloth\nf 5 6 7 8 9 10\n";

constexpr const char* kTwisted =
    "usemtl cloth\nv -0.6 -0.5 1\nv 0.6 -0.45 1.05\nv -0.4 -0.35 1.3\n"
    "v 0.7 -0.3 0.8\nf 5 6 7 8\n";

constexpr const char* kFolded =
    "usemtl cloth\nv -0.6 -0.4 1\nv 0.6 -0.5 1\nv 0.5 0.4 1.1\n"
    "v 0.45 -0.55 1.35\nf 5 6 7 8\n";

constexpr const char* kPane =
    "v -3 -3 1\nv 3 -3 1\nv 3 3 1\nv -3 3 1\nusemtl Glass_clear\nf 5 6 7 8\n";

INSTANTIATE_TEST_SUITE_P(
    Files, RealFiles,
    testing::Values(
        RealFile{"Lamp", "", {0, 0, 0}, kLampValue, ""},
        RealFile{"MaterialWithoutName",
                 "v -9 -9 -1\nv 9 -9 -1\nv 0 9 -1\nusemtl\nf 5 6 7\n",
                 {0, 0, 0},
                 kLampValue,
                 "usemtl without a name"},
        RealFile{"NormalsThatAreNoNumbers",
                 "vn nan nan nan\nvt inf 0\n",
                 {0, 0, 0},
                 kLampValue,
                 "data that truelux does not use"},
        RealFile{"TrailingSlashes",
                 "v -9 -9 -1\nf 1// 2// 5//\n",
                 {0, 0, 0},
                 kLampValue,
                 "data that truelux does not use"},
        RealFile{"Keyhole", kKeyhole, {0, 0, 0}, kLampValue, ""},
        RealFile{"KeyholeFromAside",
                 kKeyhole,
                 {0.3, 0.2, 0},
                 1.7699913285059568,
                 ""},
        // The open wedges on the left and on the right are half of the view.
        RealFile{"Hourglass", kHourglass, {0, 0, 0}, kLampValue / 2, ""},
        RealFile{"TwistedQuadrilateral",
                 kTwisted,
                 {0, 0, 0},
                 2.07036606506884,
                 "not planar"},
        RealFile{"FoldedQuadrilateral",
                 kFolded,
                 {0, 0, 0},
                 1.2154519109180697,
                 "not planar"},
        RealFile{"GlassIsOpaque", kPane, {0, 0, 0}, 0, "taken as opaque"},
        RealFile{"GlassLeftOut",
                 kPane,
                 {0, 0, 0},
                 kLampValue,
                 "lets light through",
                 {false, 0.5, false}},
        RealFile{"TwiceWithOppositeWinding",
                 "f 4 3 2 1\n",
                 {0, 0, 0},
                 kLampValue,
                 ""},
        RealFile{"TwiceWithOppositeWindingFromAbove",
                 "f 4 3 2 1\n",
                 {0, 0, 4},
                 kLampValue,
                 ""},
        RealFile{"BackOfALamp", "", {0, 0, 4}, 0, ""},
        RealFile{"BackOfATwoSidedLamp",
                 "",
                 {0, 0, 4},
                 kLampValue,
                 "",
                 {false, {}, true}}),
    [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace truelux
