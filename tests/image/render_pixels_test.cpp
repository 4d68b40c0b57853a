// SPDX-License-Identifier: GPL-3.0-or-later
// A picture has what was wished for, and of each pixel what the oracle says.

#include "image/render_pixels.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/derivatives.h"
#include "truelux/render.h"

#include "explain/shadow_class.h"
#include "image/picture_view.h"
#include "support/scene_text.h"

namespace truelux {
namespace {

constexpr PictureSize kSize = {22, 11};

/// A floor without one corner, a lamp that looks down to it past the rim of a
/// screen, and a ceiling above the lamp, which sees nothing of it.
Scene Room() {
  return SceneFromText(
      "o floor\nv 0 0 0\nv 8 0 0\nv 8 3 0\nv 7 4 0\nv 0 4 0\nf 1 2 3 4 5\n"
      "o lamp\nusemtl lamp\nv 0 0 2\nv 0 1 2\nv 1 1 2\nv 1 0 2\nf 6 7 8 9\n"
      "o screen\nusemtl black\nv 1.5 -9 1\nv 9 -9 1\nv 9 9 1\nv 1.5 9 1\n"
      "f 10 11 12 13\n"
      "o ceiling\nv 0 0 2.5\nv 0 4 2.5\nv 8 4 2.5\nv 8 0 2.5\n"
      "f 14 15 16 17\n",
      "newmtl lamp\nKe 3 2 1\nnewmtl black\nKd 0 0 0\n");
}

RenderedPixels Rendered(const Oracle& oracle, const PixelReceivers& receivers,
                        const PixelWishes& wishes) {
  Progress progress(std::nullopt, "pixels");
  RenderedPixels pixels =
      RenderPixels(oracle, receivers, wishes, 2, nullptr, progress);
  EXPECT_EQ(progress.done(), static_cast<std::uint64_t>(kSize.width) *
                                 static_cast<std::uint64_t>(kSize.height));
  return pixels;
}

std::unique_ptr<PixelReceivers> ReceiversNamed(const Scene& scene,
                                               const char* name) {
  return ReceiversOf(scene, FrameOf(scene, name), kSize);
}

TEST(RenderPixels, WhatIsNotWishedForIsEmpty) {
  const Oracle oracle(Room());
  const auto receivers = ReceiversNamed(oracle.scene(), "floor");
  const RenderedPixels pixels = Rendered(oracle, *receivers, {});
  EXPECT_EQ(pixels.image.values.width(), kSize.width);
  EXPECT_EQ(pixels.image.covered.height(), kSize.height);
  EXPECT_TRUE(pixels.bounds.empty());
  EXPECT_TRUE(pixels.differences.empty());
  EXPECT_TRUE(pixels.arcs.empty());
  EXPECT_TRUE(pixels.classes.empty());
}

/// Compares every pixel with the oracle's answers for it alone.
void ExpectTheOraclesAnswers(const Oracle& oracle,
                             const PixelReceivers& receivers,
                             const RenderedPixels& pixels) {
  OracleOptions options = oracle.options();
  options.method = Method::kDouble;
  const Oracle other(oracle.scene(), options);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      const auto receiver = receivers.At(x, y);
      ASSERT_EQ(pixels.image.covered.At(x, y), receiver ? 1 : 0);
      if (!receiver) {
        EXPECT_EQ(pixels.classes.At(x, y), ShadowClass::kNothing);
        EXPECT_EQ(pixels.arcs.At(x, y), 0);
        continue;
      }
      const Rgb value = oracle.Evaluate(*receiver).value;
      const Rgb rounded = other.Evaluate(*receiver).value;
      const VisibleContour contour = oracle.Contour(*receiver);
      EXPECT_EQ(pixels.image.values.At(x, y), value);
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(pixels.differences.At(x, y)[k],
                  std::fabs(value[k] - rounded[k]));
      }
      EXPECT_EQ(pixels.classes.At(x, y),
                ShadowClassOf(oracle.scene(), *receiver, contour));
      EXPECT_EQ(static_cast<std::size_t>(pixels.arcs.At(x, y)),
                contour.arcs.size());
      const Vector3 g = oracle.Derivatives(*receiver).channels[1].tangential;
      EXPECT_EQ(pixels.gradients.At(x, y)[1], std::hypot(g.x, g.y, g.z));
    }
  }
}

TEST(RenderPixels, EveryPixelHasWhatTheOracleSays) {
  const Oracle oracle(Room());
  PixelWishes wishes;
  for (const ExtraPicture extra : kExtraPictures)
    Wish(extra, wishes);
  std::set<ShadowClass> met;
  for (const char* name : {"floor", "ceiling"}) {
    const auto receivers = ReceiversNamed(oracle.scene(), name);
    const RenderedPixels pixels = Rendered(oracle, *receivers, wishes);
    ExpectTheOraclesAnswers(oracle, *receivers, pixels);
    met.insert(pixels.classes.pixels().begin(), pixels.classes.pixels().end());
  }
  // Among them are dark pixels, whose contours nobody asks for.
  for (const ShadowClass shadow :
       {ShadowClass::kNothing, ShadowClass::kNoSource, ShadowClass::kUmbra,
        ShadowClass::kPenumbra, ShadowClass::kLit})
    EXPECT_TRUE(met.contains(shadow)) << Name(shadow);
}

TEST(RenderPixels, EnginesAgreeOnClasses) {
  const Scene room = Room();
  PixelWishes wishes;
  Wish(ExtraPicture::kClass, wishes);
  const auto receivers = ReceiversNamed(room, "floor");
  const auto classes = [&](Engine engine) {
    OracleOptions options;
    options.engine = engine;
    return Rendered(Oracle(room, options), *receivers, wishes).classes.pixels();
  };
  const std::vector<ShadowClass> expected = classes(Engine::kContour);
  EXPECT_EQ(classes(Engine::kArrangement), expected);
  // This engine counts no arcs, so that a contour has to tell every class.
  EXPECT_EQ(classes(Engine::kAngularSpans), expected);
}

TEST(RenderPixels, BoundsAreThoseOfTheOracle) {
  OracleOptions options;
  options.method = Method::kDouble;
  const Oracle oracle(Room(), options);
  const auto receivers = ReceiversNamed(oracle.scene(), "floor");
  PixelWishes wishes;
  wishes.bounds = true;
  const RenderedPixels pixels = Rendered(oracle, *receivers, wishes);
  const auto receiver = receivers->At(3, 5);
  ASSERT_TRUE(receiver);
  EXPECT_EQ(pixels.bounds.At(3, 5), oracle.Evaluate(*receiver).bound);
  EXPECT_GT(pixels.bounds.At(3, 5)[0], 0);
}

}  // namespace
}  // namespace truelux
