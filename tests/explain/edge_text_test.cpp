// SPDX-License-Identifier: GPL-3.0-or-later
// Faces and edges in words.

#include "explain/edge_text.h"

#include <gtest/gtest.h>

#include "support/scene_text.h"

namespace truelux {
namespace {

TEST(EdgeText, NamesWhatIsKnown) {
  const Scene scene = SceneFromText(
      "v 0 0 0.1\nv 1e300 0 0\nv -1 1 0\n"
      "f 1 2 3\no Lamp\ng rim\nf 3 2 1\n");
  EXPECT_EQ(TextOfFace(scene, 1), "face 1 (line 4)");
  EXPECT_EQ(TextOfFace(scene, 2), "face 2 (line 7, Lamp/rim)");
  EXPECT_EQ(TextOf(scene, SeenEdge{1, 0, 1}),
            "face 1 (line 4), edge (0, 0, 0.1) to (1e+300, 0, 0)");
  EXPECT_EQ(TextOf(scene, SeenEdge{2, -1, -1, 1}),
            "face 2 (line 7, Lamp/rim) where it meets the plane of face 1 "
            "(line 4)");
}

TEST(EdgeText, FacesMadeInCodeHaveNoLine) {
  SceneBuilder builder;
  builder.AddFace({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const Result<Scene> scene = builder.Build();
  EXPECT_EQ(TextOfFace(*scene.value, 1), "face 1");
}

}  // namespace
}  // namespace truelux
