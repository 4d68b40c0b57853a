// SPDX-License-Identifier: GPL-3.0-or-later
// The four pictures of docs/gallery.md, small: every engine gives every pixel
// the same bits, and no kind of pixel is missing.
//
// The arrangement engine takes 10 ms to 4 s a pixel, so that only some pixels
// are asked for, more of them under the label slow (support/sweep.h);
// TRUELUX_LONG_TEST=1 asks for all.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/truelux.h"

#include "explain/shadow_class.h"
#include "image/camera_frame.h"
#include "image/camera_pixels.h"
#include "image/surface_pixels.h"
#include "scene/group_selection.h"
#include "support/sweep.h"
#include "surface/surface_frame.h"

namespace truelux {
namespace {

/// One picture of the gallery, with the view of tools/figure7.sh.
struct Picture {
  char name = 'a';
  std::optional<Camera> camera;  ///< nothing: the surface "floor"
  int size = 0;                  ///< pixels a side
  int step = 1;                  ///< every step-th pixel under the label slow
  int spans_step = 0;            ///< the same for angular spans; 0: none
};

std::ostream& operator<<(std::ostream& out, const Picture& picture) {
  return out << "figure7_" << picture.name;
}

const std::array<Picture, 4>& Pictures() {
  static const std::array<Picture, 4> pictures = {
      Picture{'a', Camera{{3, -14, 7.5}, {0.2, -0.3, 0.7}, {0, 0, 1}, 36}, 64,
              37, 0},
      Picture{'b', std::nullopt, 16, 19, 0},
      Picture{'c', Camera{{4, -15, 7.5}, {0, -0.2, 0.9}, {0, 0, 1}, 38}, 64, 1,
              17},
      Picture{'d', Camera{{3, -12, 7}, {0.3, -0.2, 2}, {0, 0, 1}, 40}, 64, 1,
              17}};
  return pictures;
}

Scene SceneOf(const Picture& picture) {
  const auto scene = ReadScene(std::string(TRUELUX_EXAMPLES) +
                               "/scenes/figure7_" + picture.name + ".obj");
  if (!scene.ok()) throw std::runtime_error("the scene cannot be read");
  return *scene.value;
}

/// What the command render makes of the same view.
std::unique_ptr<PixelReceivers> PixelsOf(const Picture& picture,
                                         const Scene& scene) {
  std::string defect;
  if (picture.camera) {
    const auto frame = CameraFrameOf(*picture.camera, defect);
    if (!frame) throw std::runtime_error(defect);
    return std::make_unique<CameraPixels>(scene, *frame, picture.size,
                                          picture.size);
  }
  const auto faces = FacesOf(scene, GroupsNamed(scene, "floor"));
  const auto frame = SurfaceFrameOf(scene, faces, defect);
  if (!frame) throw std::runtime_error(defect);
  return std::make_unique<SurfacePixels>(scene, *frame, picture.size,
                                         picture.size);
}

/// The receivers of every step-th pixel of some rows, in picture order.
std::vector<Receiver> ReceiversOf(const Picture& picture,
                                  const PixelReceivers& pixels, int first_row,
                                  int rows, int step) {
  std::vector<Receiver> receivers;
  for (int y = first_row; y < first_row + rows; ++y) {
    for (int x = 0; x < picture.size; ++x) {
      if ((y * picture.size + x) % step != 0) continue;
      const auto receiver = pixels.At(x, y);
      if (receiver) receivers.push_back(*receiver);
    }
  }
  return receivers;
}

/// Every how-manieth pixel a run asks for, where the label slow asks for every
/// step-th.
int StepOf(int step) {
  return testing::SweepSize(5 * step, step);
}

constexpr int kStrips = 8;

/// Some rows of a picture, so that strips run beside each other.
class Figure7Strips
    : public ::testing::TestWithParam<std::tuple<std::size_t, int>> {
 protected:
  [[nodiscard]] static const Picture& OwnPicture() {
    return Pictures()[std::get<0>(GetParam())];
  }

  /// Compares an engine with the contour engine.
  static void Compare(Engine engine, int step) {
    const Picture& picture = OwnPicture();
    const Scene scene = SceneOf(picture);
    const auto pixels = PixelsOf(picture, scene);
    const int rows = picture.size / kStrips;
    const auto receivers = ReceiversOf(
        picture, *pixels, rows * std::get<1>(GetParam()), rows, step);
    OracleOptions options;
    options.engine = engine;
    const Oracle other(scene, options);
    const auto expected = Oracle(scene).Evaluate(receivers);
    for (std::size_t i = 0; i < receivers.size(); ++i) {
      const Irradiance e = other.Evaluate(receivers[i]);
      EXPECT_EQ(e.value, expected[i].value)
          << picture << ", receiver " << i << " of the strip";
    }
  }
};

TEST_P(Figure7Strips, ArrangementEngineAgrees) {
  Compare(Engine::kArrangement, StepOf(OwnPicture().step));
}

TEST_P(Figure7Strips, AngularSpansAgree) {
  const int step = OwnPicture().spans_step;
  if (step == 0) GTEST_SKIP() << "too slow for this scene";
  Compare(Engine::kAngularSpans, StepOf(step));
}

INSTANTIATE_TEST_SUITE_P(
    All, Figure7Strips,
    ::testing::Combine(::testing::Range<std::size_t>(0, 4),
                       ::testing::Range(0, kStrips)),
    [](const auto& strip) {
      return std::string(1, Pictures()[std::get<0>(strip.param)].name) +
             std::to_string(std::get<1>(strip.param));
    });

/// How many pixels of each class a picture has, of every second in every
/// second row.
std::array<int, kShadowClassCount> CountClasses(const Picture& picture) {
  const Scene scene = SceneOf(picture);
  const auto pixels = PixelsOf(picture, scene);
  const Oracle oracle(scene);
  std::array<int, kShadowClassCount> counts{};
  for (int y = 0; y < picture.size; y += 2) {
    for (int x = 0; x < picture.size; x += 2) {
      const auto receiver = pixels->At(x, y);
      const auto shadow =
          receiver ? ShadowClassOf(scene, *receiver, oracle.Contour(*receiver))
                   : ShadowClass::kNothing;
      ++counts[static_cast<std::size_t>(shadow)];
    }
  }
  return counts;
}

int Count(const std::array<int, kShadowClassCount>& counts,
          ShadowClass shadow) {
  return counts[static_cast<std::size_t>(shadow)];
}

TEST(Figure7, CamerasSeeEveryKindOfPixel) {
  for (const std::size_t index : {0U, 2U, 3U}) {
    const Picture& picture = Pictures()[index];
    const auto counts = CountClasses(picture);
    for (const auto shadow : {ShadowClass::kNothing, ShadowClass::kUmbra,
                              ShadowClass::kPenumbra, ShadowClass::kLit}) {
      EXPECT_GE(Count(counts, shadow), 25) << picture << ", " << Name(shadow);
    }
  }
}

TEST(Figure7, FloorOfTheCrescentIsAlmostAllPenumbra) {
  const auto counts = CountClasses(Pictures()[1]);
  EXPECT_EQ(Count(counts, ShadowClass::kNothing), 0);
  EXPECT_EQ(Count(counts, ShadowClass::kNoSource), 0);
  EXPECT_GE(Count(counts, ShadowClass::kLit), 3);
  EXPECT_GE(Count(counts, ShadowClass::kPenumbra), 45);
}

TEST(Figure7, ThinTrianglesAreAThousandAndThin) {
  const Scene scene = SceneOf(Pictures()[1]);
  const auto faces = FacesOf(scene, GroupsNamed(scene, "triangles"));
  EXPECT_EQ(faces.size(), 1000U);
  for (const int f : faces) {
    const Face& face = scene.faces()[static_cast<std::size_t>(f)];
    ASSERT_EQ(face.facet_count, 1);
    ASSERT_EQ(face.corner_count, 3);
    for (int k = 0; k < 3; ++k) {
      const int corner =
          scene.corners()[static_cast<std::size_t>(face.first_corner) +
                          static_cast<std::size_t>(k)];
      const Point3& p = scene.vertices()[static_cast<std::size_t>(corner)];
      // Above the pictured floor, but for tips that reach over its rim.
      EXPECT_LE(std::max(std::abs(p.x), std::abs(p.y)), 4.5);
      EXPECT_GE(p.z, 0.15);
    }
  }
  const auto lamp = FacesOf(scene, GroupsNamed(scene, "lamp"));
  ASSERT_EQ(lamp.size(), 1U);
  EXPECT_EQ(scene.faces()[static_cast<std::size_t>(lamp[0])].corner_count, 24);
}

}  // namespace
}  // namespace truelux
