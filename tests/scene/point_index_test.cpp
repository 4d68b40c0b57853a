// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/point_index.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace truelux {
namespace {

TEST(PointIndex, EqualPointsShareAnIndex) {
  PointIndex index;
  EXPECT_EQ(index.Insert({1, 2, 3}), 0);
  EXPECT_EQ(index.Insert({3, 2, 1}), 1);
  EXPECT_EQ(index.Insert({1, 2, 3}), 0);
  EXPECT_EQ(index.Insert({1, 2, std::nextafter(3.0, 4.0)}), 2);
}

TEST(PointIndex, NegativeZeroIsZero) {
  PointIndex index;
  EXPECT_EQ(index.Insert({-0.0, 1, -0.0}), 0);
  EXPECT_EQ(index.Insert({0.0, 1, 0.0}), 0);
  const std::vector<Point3> points = index.TakePoints();
  ASSERT_EQ(points.size(), 1U);
  EXPECT_FALSE(std::signbit(points[0].x));
  EXPECT_FALSE(std::signbit(points[0].z));
}

TEST(PointIndex, KeepsTheOrderOfManyPoints) {
  PointIndex index;
  const auto point = [](int i) {
    return Point3{i * 0.125, i * -3.0, std::ldexp(i, i % 900)};
  };
  for (int i = 0; i < 10000; ++i)
    ASSERT_EQ(index.Insert(point(i)), i);
  for (int i = 0; i < 10000; ++i)
    ASSERT_EQ(index.Insert(point(i)), i);
  const std::vector<Point3> points = index.TakePoints();
  ASSERT_EQ(points.size(), 10000U);
  EXPECT_EQ(points[4711], point(4711));
}

TEST(PointIndex, IsEmptyAfterItsPointsAreTaken) {
  PointIndex index;
  index.Insert({1, 2, 3});
  index.TakePoints();
  EXPECT_EQ(index.Insert({4, 5, 6}), 0);
}

}  // namespace
}  // namespace truelux
