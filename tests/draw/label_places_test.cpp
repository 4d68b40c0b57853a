// SPDX-License-Identifier: GPL-3.0-or-later
// Labels in gaps: none on another, none on a line, one for each series.

#include "draw/label_places.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/portable_random.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

constexpr LabelBox kFrame = {0, 0, 800, 600};

/// A bent ring, or a part of one.
PaperPath Ring(double x, double y, double radius, double dent, double turn) {
  PaperPath path;
  constexpr int kSteps = 200;
  for (int i = 0; i <= kSteps; ++i) {
    const double angle = turn * i / kSteps;
    const double r = radius * (1 + dent * std::sin(3 * angle));
    path.push_back({x + r * std::cos(angle), y + r * std::sin(angle)});
  }
  return path;
}

struct Drawing {
  std::vector<LabelledLine> lines;
  std::vector<std::string> texts;
};

Drawing RandomDrawing(PortableRandom& random) {
  Drawing drawing;
  for (std::size_t s = 0; s < 12; ++s) {
    drawing.texts.push_back(s % 3 == 0 ? "0.5" : "12.125");
    for (int i = 0; i < 3; ++i) {
      drawing.lines.push_back(
          {Ring(random.Uniform(200, 600), random.Uniform(200, 400),
                random.Uniform(2, 200), random.Uniform(0, 0.2),
                random.Uniform(1, 2 * std::numbers::pi)),
           s});
    }
  }
  return drawing;
}

/// Whether a point of `a`, of a fine grid, is in `b`.
bool Meet(const GapLabel& a, const GapLabel& b) {
  constexpr int kSteps = 20;
  const auto corners = a.Corners();
  for (int i = 1; i < kSteps; ++i) {
    for (int k = 1; k < kSteps; ++k) {
      const double s = 1.0 * i / kSteps;
      const double t = 1.0 * k / kSteps;
      const PaperPoint p = {corners[0].x + s * (corners[1].x - corners[0].x) +
                                t * (corners[3].x - corners[0].x),
                            corners[0].y + s * (corners[1].y - corners[0].y) +
                                t * (corners[3].y - corners[0].y)};
      if (b.Holds(p)) return true;
    }
  }
  return false;
}

TEST(LabelPlaces, NoTwoOverlapAndNoneLeavesTheFrame) {
  PortableRandom random(5);
  std::size_t labels_in_all = 0;
  for (int round = 0; round < 20; ++round) {
    const Drawing drawing = RandomDrawing(random);
    const auto labels =
        PlaceGapLabels(drawing.lines, drawing.texts, {}, kFrame);
    std::set<std::size_t> series;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      series.insert(labels[i].series);
      EXPECT_LE(std::abs(labels[i].angle), 90);
      for (const PaperPoint& corner : labels[i].Corners()) {
        EXPECT_TRUE(corner.x >= 0 && corner.x <= 800);
        EXPECT_TRUE(corner.y >= 0 && corner.y <= 600);
      }
      for (std::size_t k = 0; k < labels.size(); ++k)
        EXPECT_FALSE(k != i && Meet(labels[i], labels[k])) << i << ' ' << k;
    }
    EXPECT_EQ(series.size(), drawing.texts.size());
    labels_in_all += labels.size();
  }
  EXPECT_GT(labels_in_all, 20U * 12);
}

TEST(LabelPlaces, LinesAreBrokenUnderLabelsAndNowhereElse) {
  PortableRandom random(6);
  std::size_t gaps = 0;
  for (int round = 0; round < 10; ++round) {
    const Drawing drawing = RandomDrawing(random);
    const auto labels =
        PlaceGapLabels(drawing.lines, drawing.texts, {}, kFrame);
    for (const LabelledLine& line : drawing.lines) {
      const auto pieces = OutsideLabels(line.path, labels);
      gaps += pieces.size() - 1;
      double shown = 0;
      for (const PaperPath& piece : pieces) {
        shown += LengthOf(piece);
        for (std::size_t i = 1; i < piece.size(); ++i) {
          for (const double t : {0.01, 0.3, 0.5, 0.8, 0.99}) {
            const PaperPoint p = {
                piece[i - 1].x + t * (piece[i].x - piece[i - 1].x),
                piece[i - 1].y + t * (piece[i].y - piece[i - 1].y)};
            for (GapLabel label : labels) {
              label.half_width -= 1e-6;
              label.half_height -= 1e-6;
              EXPECT_FALSE(label.Holds(p));
            }
          }
        }
      }
      // What is hidden, by small steps.
      double hidden = 0;
      for (std::size_t i = 1; i < line.path.size(); ++i) {
        const PaperPoint& a = line.path[i - 1];
        const PaperPoint& b = line.path[i];
        constexpr int kSteps = 100;
        for (int k = 0; k < kSteps; ++k) {
          const double t = (k + 0.5) / kSteps;
          const PaperPoint p = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
          for (const GapLabel& label : labels) {
            if (label.Holds(p))
              hidden += std::hypot(b.x - a.x, b.y - a.y) / kSteps;
          }
        }
      }
      EXPECT_NEAR(shown + hidden, LengthOf(line.path), 0.5);
    }
  }
  EXPECT_GT(gaps, 50U);
}

TEST(LabelPlaces, AStraightLineGetsItsLabelAlongIt) {
  const std::vector<std::string> texts = {"0.5"};
  const std::vector<LabelledLine> lines = {
      {{{700, 500}, {100, 100}}, 0}};  // drawn from right to left
  const auto labels = PlaceGapLabels(lines, texts, {}, kFrame);
  ASSERT_GE(labels.size(), 1U);
  EXPECT_NEAR(labels[0].angle, std::atan2(4, 6) * 180 / std::numbers::pi, 1e-9);
  EXPECT_NEAR(labels[0].middle.x, 400, 8);
  EXPECT_EQ(OutsideLabels(lines[0].path, {labels.data(), 1}).size(), 2U);
}

TEST(LabelPlaces, ATinyRingHasItsLabelBesideIt) {
  const std::vector<std::string> texts = {"0.5"};
  const std::vector<LabelledLine> lines = {
      {Ring(300, 300, 3, 0, 2 * std::numbers::pi), 0}};
  const auto labels = PlaceGapLabels(lines, texts, {}, kFrame);
  ASSERT_EQ(labels.size(), 1U);
  EXPECT_EQ(labels[0].angle, 0);
  EXPECT_LT(std::abs(labels[0].middle.x - 300), 40);
  const auto pieces = OutsideLabels(lines[0].path, labels);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].size(), lines[0].path.size());
}

TEST(LabelPlaces, RatherNotOnObstacles) {
  const std::vector<std::string> texts = {"0.5"};
  const std::vector<LabelledLine> lines = {{{{100, 300}, {700, 300}}, 0}};
  const std::vector<Obstacle> walls = {{{{400, 0}, {400, 600}}, 1}};
  const auto labels = PlaceGapLabels(lines, texts, walls, kFrame);
  ASSERT_GE(labels.size(), 1U);
  EXPECT_GT(std::abs(labels[0].middle.x - 400), labels[0].half_width);
}

}  // namespace
}  // namespace truelux
