// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes in a source's plane contain what they stand for, and bins lose none.

#include "visibility/edges/image_box.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "exact/number.h"
#include "support/portable_random.h"
#include "visibility/edges/part_bins.h"
#include "visibility/edges/part_grid.h"

namespace truelux {
namespace {

using testing::PortableRandom;

TEST(ImageChart, BoxContainsTheTrueImage) {
  PortableRandom random(1);
  int bounded = 0;
  int missed = 0;
  double widest = 0;
  for (int i = 0; i < 50000; ++i) {
    const int range = i % 3 == 0 ? 200 : 2;
    const auto number = [&] {
      return std::ldexp(random.Uniform(-1, 1), random.Integer(-range, range));
    };
    const std::array<double, 3> n{number(), number(), number()};
    const std::array<double, 3> d{number(), number(), number()};
    const RoundUpward rounding;
    const auto error = [&](const std::array<double, 3>& v) {
      const double max = MakeFilteredDirection({v[0], v[1], v[2], 0}).max;
      return max * std::ldexp(1.0, random.Integer(-56, -8));
    };
    const double n_error = error(n);
    const double d_error = error(d);
    const ImageChart chart(MakeFilteredPlane({n[0], n[1], n[2], n_error}));
    bool misses = false;
    const ImageBox box =
        chart.Of(MakeFilteredDirection({d[0], d[1], d[2], d_error}), misses);
    // Any true vectors within the errors: D = -n.d, and two of d / D.
    std::array<Exact, 3> p;
    Exact depth(0);
    for (std::size_t k = 0; k < 3; ++k) {
      const Exact true_n =
          Exact(n[k]) + Exact(n_error) * Exact(random.Integer(-1, 1));
      p[k] = Exact(d[k]) + Exact(d_error) * Exact(random.Integer(-1, 1));
      depth = depth - true_n * p[k];
    }
    if (misses) {
      ++missed;
      EXPECT_TRUE(depth < Exact(0));
    }
    if (!std::isfinite(box.x_min())) continue;
    ++bounded;
    ASSERT_TRUE(Exact(0) < depth);
    // The dropped coordinate is the normal's longest.
    std::size_t dropped = 2;
    if (!(std::fabs(n[2]) >= std::fabs(n[0]) &&
          std::fabs(n[2]) >= std::fabs(n[1]))) {
      dropped = std::fabs(n[1]) >= std::fabs(n[0]) ? 1 : 0;
    }
    const Exact& x = dropped == 0 ? p[1] : p[0];
    const Exact& y = dropped == 2 ? p[1] : p[2];
    ASSERT_TRUE(Exact(box.x_min()) * depth <= x) << "sample " << i;
    ASSERT_TRUE(x <= Exact(box.x_max()) * depth) << "sample " << i;
    ASSERT_TRUE(Exact(box.y_min()) * depth <= y) << "sample " << i;
    ASSERT_TRUE(y <= Exact(box.y_max()) * depth) << "sample " << i;
    // The diagonal bounds, too: the box meets that of the true point alone.
    const ImageBox point(box.x_max(), box.x_max(), box.y_min(), box.y_min());
    ASSERT_TRUE(box.Meets(point)) << "sample " << i;
    widest = std::max(widest, box.x_max() - box.x_min());
  }
  EXPECT_GT(bounded, 5000);
  EXPECT_GT(missed, 5000);
  EXPECT_GT(widest, 0);
}

TEST(PartBins, FindsEveryBoxThatMeetsInsideTheFrame) {
  PortableRandom random(2);
  constexpr double kInfinity = HUGE_VAL;
  std::size_t found_boxes = 0;
  std::size_t all_boxes = 0;
  PartBins bins;
  for (int i = 0; i < 400; ++i) {
    const RoundUpward rounding;
    const auto box = [&](double size) {
      double x_min = random.Uniform(-2, 2);
      const double x_max = x_min + random.Uniform(0, size);
      const double y_min = random.Uniform(-2, 2);
      double y_max = y_min + random.Uniform(0, size);
      if (random.OneIn(20)) x_min = -kInfinity;
      if (random.OneIn(20)) y_max = kInfinity;
      if (random.OneIn(50)) return ImageBox();
      return ImageBox(x_min, x_max, y_min, y_max);
    };
    ImageBox frame{-1, 1, -1, 1};
    if (i % 10 == 1) frame = {};
    if (i % 10 == 2) frame = {0.5, 0.5, -1, 1};
    if (i % 10 == 3) frame = {-kInfinity, 1, -1, kInfinity};
    std::vector<ImageBox> boxes;
    const int count = random.Integer(0, 300);
    for (int k = 0; k < count; ++k)
      boxes.push_back(box(0.5));
    bins.Build(boxes, frame);
    const ImageBox query = box(0.3);
    std::vector<bool> found(boxes.size(), false);
    std::size_t last = 0;
    bool in_order = true;
    bins.ForEach(query, [&](std::size_t k) {
      in_order = in_order && (!found[k]) && k >= last;
      last = k;
      found[k] = true;
      ++found_boxes;
      return true;
    });
    EXPECT_TRUE(in_order);
    all_boxes += boxes.size();
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      EXPECT_TRUE(found[k] || !boxes[k].Meets(query)) << "scene " << i;
    }
    std::size_t calls = 0;
    const bool whole = bins.ForEach(query, [&](std::size_t) {
      ++calls;
      return false;
    });
    EXPECT_EQ(whole, calls == 0);
    EXPECT_LE(calls, 1U);
  }
  EXPECT_LT(found_boxes * 2, all_boxes);
}

/// Many small boxes, a few large ones.
std::vector<ImageBox> ManyBoxes(PortableRandom& random, int count) {
  std::vector<ImageBox> boxes;
  for (int k = 0; k < count; ++k) {
    const double size = random.OneIn(200) ? 1.5 : 0.05;
    const double x = random.Uniform(-1.5, 1.5);
    const double y = random.Uniform(-1.5, 1.5);
    boxes.emplace_back(x, x + random.Uniform(0, size), y,
                       y + random.Uniform(0, size));
  }
  boxes.emplace_back();
  return boxes;
}

TEST(PartGrid, FindsWhatContainsABoxInsideTheFrame) {
  PortableRandom random(3);
  std::size_t around_boxes = 0;
  std::size_t all_boxes = 0;
  PartGrid grid;
  for (int i = 0; i < 60; ++i) {
    const RoundUpward rounding;
    const ImageBox frame{-1, 1, -1, 1};
    const std::vector<ImageBox> boxes =
        ManyBoxes(random, random.Integer(1100, 4000));
    ASSERT_TRUE(grid.Build(boxes, frame));
    for (int q = 0; q < 20; ++q) {
      const double x = random.Uniform(-1, 0.9);
      const double y = random.Uniform(-1, 0.9);
      const ImageBox query(x, x + random.Uniform(0, 0.1), y,
                           y + random.Uniform(0, 0.1));
      std::vector<bool> around(boxes.size(), false);
      EXPECT_TRUE(grid.ForEachAround(query, [&](std::size_t k) {
        EXPECT_FALSE(around[k]);
        around[k] = true;
        ++around_boxes;
        return true;
      }));
      all_boxes += boxes.size();
      for (std::size_t k = 0; k < boxes.size(); ++k) {
        EXPECT_TRUE(around[k] || !boxes[k].Contains(query));
      }
      std::size_t calls = 0;
      EXPECT_FALSE(grid.ForEachAround(query, [&](std::size_t) {
        ++calls;
        return false;
      }));
      EXPECT_EQ(calls, 1U);
    }
  }
  EXPECT_LT(around_boxes * 40, all_boxes);
}

TEST(PartGrid, DeclinesWhereSetsOfBitsAreBetter) {
  PortableRandom random(4);
  const RoundUpward rounding;
  PartGrid grid;
  const ImageBox frame{-1, 1, -1, 1};
  EXPECT_FALSE(grid.Build(ManyBoxes(random, 500), frame));
  EXPECT_FALSE(grid.Build(std::vector<ImageBox>(2000), frame));
  const std::vector<ImageBox> many = ManyBoxes(random, 2000);
  EXPECT_TRUE(grid.Build(many, frame));
  EXPECT_FALSE(grid.Build(many, {}));
  EXPECT_FALSE(grid.Build(many, {0.5, 0.5, -1, 1}));
}

}  // namespace
}  // namespace truelux
