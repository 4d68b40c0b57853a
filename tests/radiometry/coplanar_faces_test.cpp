// SPDX-License-Identifier: GPL-3.0-or-later
// Faces that overlap in one plane: a stack of rectangles on a grid sheds the
// light of the cells of the grid, each with what the rule says is seen there.

#include <array>
#include <cstddef>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/irradiance.h"
#include "truelux/scene.h"

#include "scene/scene_variants.h"
#include "visibility/first_hit.h"

namespace truelux {
namespace {

constexpr int kCells = 5;  // along a side of the grid
constexpr double kHeight = 2;

/// A rectangle of cells in the plane z = kHeight.
struct Sheet {
  int left = 0;
  int right = 0;
  int low = 0;
  int high = 0;
  bool faces_up = false;
  Rgb emission{};

  [[nodiscard]] bool Covers(int x, int y) const {
    return left <= x && x < right && low <= y && y < high;
  }
};

/// Corners of a rectangle in the plane, counter-clockwise from above, or from
/// below.
std::vector<Point3> Rectangle(double left, double right, double low,
                              double high, bool faces_up) {
  if (faces_up) {
    return {{left, low, kHeight},
            {right, low, kHeight},
            {right, high, kHeight},
            {left, high, kHeight}};
  }
  return {{left, low, kHeight},
          {left, high, kHeight},
          {right, high, kHeight},
          {right, low, kHeight}};
}

std::vector<Sheet> RandomSheets(std::mt19937& random) {
  const auto below = [&](int n) {
    return static_cast<int>(random() % static_cast<unsigned>(n));
  };
  std::vector<Sheet> sheets(2 + random() % 5);
  for (Sheet& sheet : sheets) {
    sheet.left = below(kCells - 1);
    sheet.right = sheet.left + 1 + below(kCells - sheet.left);
    sheet.low = below(kCells - 1);
    sheet.high = sheet.low + 1 + below(kCells - sheet.low);
    sheet.faces_up = random() % 2 == 0;
    if (random() % 3 != 0) {
      sheet.emission = {1.0 + below(3), 1.0 + below(3), 2};
    }
  }
  return sheets;
}

bool Emits(const Sheet& sheet) {
  return sheet.emission != Rgb{};
}

/// The rule, word for word: who is seen in a cell from above or from below.
const Sheet* SeenIn(const std::vector<Sheet>& sheets, int x, int y,
                    bool from_above, bool two_sided) {
  for (const int rank : {0, 1, 2, 3}) {
    for (const Sheet& sheet : sheets) {
      if (!sheet.Covers(x, y)) continue;
      const bool front = sheet.faces_up == from_above;
      int own = front ? 2 : 3;
      if (Emits(sheet) && front) own = 0;
      if (Emits(sheet) && !front && two_sided) own = 1;
      if (own == rank) return &sheet;
    }
  }
  return nullptr;
}

Scene Stack(const std::vector<Sheet>& sheets, bool two_sided) {
  SceneBuilder builder;
  builder.SetTwoSided(two_sided);
  for (const Sheet& s : sheets)
    builder.AddFace(Rectangle(s.left, s.right, s.low, s.high, s.faces_up),
                    s.emission);
  return *builder.Build().value;
}

/// One square for each cell, which nothing overlaps.
Scene Cells(const std::vector<Sheet>& sheets, bool from_above, bool two_sided) {
  SceneBuilder builder;
  for (int x = 0; x < kCells; ++x) {
    for (int y = 0; y < kCells; ++y) {
      const Sheet* seen = SeenIn(sheets, x, y, from_above, two_sided);
      if (seen == nullptr) continue;
      const bool lights = two_sided || seen->faces_up == from_above;
      builder.AddFace(Rectangle(x, x + 1, y, y + 1, from_above),
                      lights ? seen->emission : Rgb{});
    }
  }
  return *builder.Build().value;
}

Receiver RandomReceiver(std::mt19937& random, bool from_above) {
  std::uniform_real_distribution<double> place(-1, kCells + 1);
  std::uniform_real_distribution<double> tilt(-0.5, 0.5);
  return {{place(random), place(random), from_above ? 4.0 : 0.5},
          {tilt(random), tilt(random), from_above ? -1.0 : 1.0}};
}

Rgb ValueOf(const Scene& scene, const Receiver& receiver, Engine engine) {
  OracleOptions options;
  options.engine = engine;
  return Oracle(scene, options).Evaluate(receiver).value;
}

class CoplanarFaces : public testing::TestWithParam<bool> {};

TEST_P(CoplanarFaces, ShedTheLightOfTheCells) {
  const bool two_sided = GetParam();
  std::mt19937 random(37);
  int lit = 0;
  for (int i = 0; i < 60; ++i) {
    const std::vector<Sheet> sheets = RandomSheets(random);
    const Scene stack = Stack(sheets, two_sided);
    for (const bool from_above : {false, true}) {
      const Scene cells = Cells(sheets, from_above, two_sided);
      const Receiver receiver = RandomReceiver(random, from_above);
      const Rgb expected = ValueOf(cells, receiver, Engine::kContour);
      if (expected[2] > 0) ++lit;
      for (const Engine engine :
           {Engine::kContour, Engine::kArrangement, Engine::kAngularSpans}) {
        EXPECT_EQ(ValueOf(stack, receiver, engine), expected)
            << Name(engine) << " case " << i;
      }
    }
  }
  EXPECT_GT(lit, 60);
}

TEST_P(CoplanarFaces, AreHitWhereTheRuleSaysTheyAre) {
  const bool two_sided = GetParam();
  std::mt19937 random(41);
  std::array<int, 4> hits{};
  for (int i = 0; i < 60; ++i) {
    const std::vector<Sheet> sheets = RandomSheets(random);
    const Scene stack = Stack(sheets, two_sided);
    const FirstHitFinder finder(stack);
    for (int cell = 0; cell < kCells * kCells; ++cell) {
      const int x = cell % kCells;
      const int y = cell / kCells;
      for (const bool from_above : {false, true}) {
        // Off the diagonals of every rectangle.
        const Ray ray{{x + 0.375, y + 0.53125, from_above ? 3.0 : 1.0},
                      {0, 0, from_above ? -1.0 : 1.0}};
        const std::optional<FirstHit> hit = finder.Find(ray);
        const Sheet* seen = SeenIn(sheets, x, y, from_above, two_sided);
        ASSERT_EQ(hit.has_value(), seen != nullptr);
        if (!hit) continue;
        const Triangle& triangle =
            stack.triangles()[static_cast<std::size_t>(hit->triangle)];
        const Facet& facet =
            stack.facets()[static_cast<std::size_t>(triangle.facet)];
        EXPECT_EQ(static_cast<std::size_t>(facet.face),
                  static_cast<std::size_t>(seen - sheets.data()));
        ++hits[(Emits(*seen) ? 2U : 0U) + (facet.is_back ? 1U : 0U)];
      }
    }
  }
  EXPECT_GT(hits[0], 100);
  EXPECT_GT(hits[2], 100);
  EXPECT_EQ(hits[3] > 100, two_sided);
}

TEST_P(CoplanarFaces, AddUpSourceBySource) {
  const bool two_sided = GetParam();
  std::mt19937 random(43);
  for (int i = 0; i < 40; ++i) {
    std::vector<Sheet> sheets = RandomSheets(random);
    // A power of two, so that products and sums are exact enough to compare.
    for (Sheet& sheet : sheets) {
      if (Emits(sheet)) sheet.emission = {1, 2, 4};
    }
    const Scene stack = Stack(sheets, two_sided);
    const Receiver receiver = RandomReceiver(random, i % 2 == 0);
    const Oracle oracle(stack);
    double sum = 0;
    double of_variants = 0;
    for (std::size_t k = 0; k < sheets.size(); ++k) {
      if (!Emits(sheets[k])) continue;
      const auto face = static_cast<int>(k);
      sum += oracle.FormFactor(receiver, face + 1).value[0];
      of_variants +=
          Oracle(WithOneEmitter(stack, face)).Evaluate(receiver).value[0];
    }
    const double all = oracle.Evaluate(receiver).value[0];
    EXPECT_NEAR(sum, all, 1e-14 * all);
    EXPECT_NEAR(of_variants, all, 1e-14 * all);
  }
}

TEST(CoplanarLamp, ALampDrawnIntoACeilingShines) {
  const std::vector<Point3> ceiling = Rectangle(-5, 5, -5, 5, false);
  const std::vector<Point3> lamp = Rectangle(-1, 1, -1, 1, false);
  const Receiver receiver{{0, 0, 0}, {0, 0, 1}};
  for (const bool lamp_first : {false, true}) {
    SceneBuilder builder;
    if (lamp_first) builder.AddFace(lamp, {10, 10, 10});
    builder.AddFace(ceiling);
    if (!lamp_first) builder.AddFace(lamp, {10, 10, 10});
    // 10 (4 / pi) (1 / sqrt 5) atan(1 / sqrt 5)
    EXPECT_EQ(Oracle(*builder.Build().value).Evaluate(receiver).value[0],
              2.394564704607735);
  }
}

INSTANTIATE_TEST_SUITE_P(Sides, CoplanarFaces, testing::Bool(),
                         [](const auto& row) {
                           return row.param ? "Two" : "One";
                         });

}  // namespace
}  // namespace truelux
