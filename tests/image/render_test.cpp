// SPDX-License-Identifier: GPL-3.0-or-later
// The public function, which renders into arrays.
#include "truelux/render.h"

#include <cstdint>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "truelux/irradiance.h"
#include "truelux/stop.h"

#include "support/scene_text.h"

namespace truelux {
namespace {

/// A lamp past the rim of a screen, over a floor that lacks a corner.
Scene Room() {
  return SceneFromText(
      "o floor\nv 0 0 0\nv 8 0 0\nv 8 3 0\nv 7 4 0\nv 0 4 0\nf 1 2 3 4 5\n"
      "o lamp\nusemtl lamp\nv 0 0 2\nv 0 1 2\nv 1 1 2\nv 1 0 2\nf 6 7 8 9\n"
      "o screen\nusemtl black\nv 1.5 -9 1\nv 9 -9 1\nv 9 9 1\nv 1.5 9 1\n"
      "f 10 11 12 13\n",
      "newmtl lamp\nKe 3 2 1\nnewmtl black\nKd 0 0 0\n");
}

TEST(Render, PixelsAreTheOraclesAnswersForTheirReceivers) {
  const Oracle oracle(Room());
  const Rendering found = Render(oracle, "floor", {16, 0}, {.threads = 2});
  EXPECT_EQ(found.receivers.height(), 8);
  int uncovered = 0;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 16; ++x) {
      if (found.pixels.image.covered.At(x, y) == 0) {
        ++uncovered;
        continue;
      }
      const Receiver& receiver = found.receivers.At(x, y);
      EXPECT_EQ(receiver.on_face, 1);
      EXPECT_EQ(found.pixels.image.values.At(x, y),
                oracle.Evaluate(receiver).value);
    }
  }
  EXPECT_GT(uncovered, 0);
  EXPECT_LT(uncovered, 16);
}

TEST(Render, BringsWhatIsWishedFor) {
  const Oracle oracle(Room());
  RenderOptions options;
  options.wishes = {.bounds = true,
                    .differences = true,
                    .arcs = true,
                    .classes = true,
                    .gradients = true};
  const RenderedPixels pixels =
      Render(oracle, "floor", {16, 8}, options).pixels;
  EXPECT_FALSE(pixels.bounds.empty() || pixels.differences.empty() ||
               pixels.arcs.empty() || pixels.gradients.empty());
  const std::set<ShadowClass> classes(pixels.classes.pixels().begin(),
                                      pixels.classes.pixels().end());
  EXPECT_GE(classes.size(), 4U);
  EXPECT_TRUE(pixels.kinks.has_value());
  // A camera sees no surface to follow kinks on.
  const Camera camera{{4, -5, 5}, {4, 2, 0}, {0, 0, 1}, 40};
  const Rendering seen = Render(oracle, camera, {8, 0}, options);
  EXPECT_EQ(seen.receivers.height(), 8);
  EXPECT_FALSE(seen.pixels.kinks.has_value());
}

TEST(Render, TakesOtherFacesAndSaysHowTheyWereFound) {
  const Oracle oracle(Room());
  const Rendering found = Render(oracle, "floor", {4, 2}, {.on_face = "lamp"});
  EXPECT_EQ(found.receivers.At(0, 1).on_face, 2);
  EXPECT_NE(TextOf(found.notes).find("on_face: "), std::string::npos);
}

TEST(Render, RefusesWhatDoesNotFit) {
  const Oracle spans(Room(), {.engine = Engine::kAngularSpans});
  const auto defect = [&](const PictureSubject& subject,
                          const PictureSize& size,
                          const RenderOptions& options) -> std::string {
    try {
      (void)Render(spans, subject, size, options);
    } catch (const std::invalid_argument& error) {
      const std::string text = error.what();
      return text.substr(0, text.find(':'));
    }
    return "";
  };
  EXPECT_EQ(defect("floor", {2, 0}, {}), "");
  EXPECT_EQ(defect("roof", {2, 0}, {}), "surface");
  EXPECT_EQ(defect("floor", {0, 2}, {}), "size");
  EXPECT_EQ(defect("floor", {2, -1}, {}), "size");
  EXPECT_EQ(defect("floor", {65536, 65536}, {}), "size");
  EXPECT_EQ(defect("floor", {1 << 30, 0}, {}), "size");
  EXPECT_EQ(defect(Camera{}, {2, 2}, {}), "camera");
  EXPECT_EQ(defect("floor", {2, 0}, {.threads = 0}), "threads");
  EXPECT_EQ(defect("floor", {2, 0}, {.on_face = "roof"}), "on_face");
  EXPECT_EQ(defect("floor", {2, 0}, {.on_face = ""}), "on_face");
  EXPECT_EQ(defect("floor", {2, 0}, {.wishes = {.differences = true}}),
            "differences");
}

TEST(Render, TellsHowFarItIsAndStops) {
  StopFlag stop = false;
  const Oracle oracle(Room(), {.stop = &stop});
  std::uint64_t most = 0;
  RenderOptions options;
  options.progress = [&](const ProgressState& state) {
    if (state.things == "pixels") most = std::max(most, state.done);
  };
  (void)Render(oracle, "floor", {20, 10}, options);
  EXPECT_EQ(most, 200U);
  stop = true;
  EXPECT_THROW((void)Render(oracle, "floor", {20, 10}, options), Stopped);
}

}  // namespace
}  // namespace truelux
