// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/index/plane_region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include "exact/number.h"
#include "support/portable_random.h"

namespace truelux {
namespace {

using testing::PortableRandom;

using Integers = std::array<int, 3>;

/// A plane through a point and boxes, all of small integers, so that the tests
/// decide without rounding.
struct IntegerCase {
  FourBoxes boxes;
  Box region;
  Integers normal{};
  Integers point{};
  int count = 0;  ///< of the boxes
};

Integers RandomIntegers(PortableRandom& random, int most) {
  return {random.Integer(-most, most), random.Integer(-most, most),
          random.Integer(-most, most)};
}

Box RandomBox(PortableRandom& random, int most, int size) {
  Box box;
  const Integers a = RandomIntegers(random, most);
  for (std::size_t k = 0; k < 3; ++k) {
    box.lo[k] = a[k];
    box.hi[k] = a[k] + random.Integer(0, size);
  }
  return box;
}

IntegerCase RandomCase(PortableRandom& random) {
  IntegerCase c;
  while (c.normal == Integers{})
    c.normal = RandomIntegers(random, random.OneIn(2) ? 1 : 9);
  c.point = RandomIntegers(random, 9);
  c.region = RandomBox(random, 9, 9);
  c.count = random.Integer(1, 4);
  for (int i = 0; i < c.count; ++i) {
    const Box box = RandomBox(random, 12, random.OneIn(3) ? 0 : 6);
    c.boxes.Set(static_cast<std::size_t>(i), box);
  }
  return c;
}

/// The least and the greatest N . (p - point) of a box; exact.
std::array<double, 2> Heights(const IntegerCase& c, const Box& box) {
  std::array<double, 2> ends{0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = c.normal[k] * (box.lo[k] - c.point[k]);
    const double b = c.normal[k] * (box.hi[k] - c.point[k]);
    ends[0] += std::min(a, b);
    ends[1] += std::max(a, b);
  }
  return ends;
}

bool Meet(const Box& a, const Box& b) {
  bool meet = true;
  for (std::size_t k = 0; k < 3; ++k)
    meet = meet && a.lo[k] <= b.hi[k] && b.lo[k] <= a.hi[k];
  return meet;
}

Box Scaled(const Box& box, double scale) {
  Box scaled;
  for (std::size_t k = 0; k < 3; ++k) {
    scaled.lo[k] = box.lo[k] * scale;
    scaled.hi[k] = box.hi[k] * scale;
  }
  return scaled;
}

/// What the region keeps if lengths and the normal are scaled, the normal is
/// off by `off`, and its error bound is `error`.
unsigned Kept(const IntegerCase& c, double length, double size,
              const std::array<double, 3>& off, double error) {
  FourBoxes boxes;
  for (std::size_t i = 0; i < static_cast<std::size_t>(c.count); ++i)
    boxes.Set(i, Scaled(c.boxes.Get(i), length));
  const RoundUpward rounding;
  const FilteredPlane normal = MakeFilteredPlane(
      {size * (c.normal[0] + off[0]), size * (c.normal[1] + off[1]),
       size * (c.normal[2] + off[2]), size * error});
  const Point3 point{length * c.point[0], length * c.point[1],
                     length * c.point[2]};
  return PlaneRegion(normal, point, Scaled(c.region, length)).Kept(boxes);
}

bool Has(unsigned bits, int i) {
  return (bits >> static_cast<unsigned>(i) & 1U) != 0;
}

TEST(PlaneRegion, IsExactForIntegers) {
  PortableRandom random(1);
  int kept_count = 0;
  int on_one_side = 0;
  int outside = 0;
  for (int i = 0; i < 100000; ++i) {
    const IntegerCase c = RandomCase(random);
    const unsigned kept = Kept(c, 1, 1, {}, 0);
    for (int k = 0; k < 4; ++k) {
      const Box box = c.boxes.Get(static_cast<std::size_t>(k));
      const auto [least, most] =
          k < c.count ? Heights(c, box) : std::array<double, 2>{0, 0};
      const bool meets = k < c.count && Meet(box, c.region);
      const bool straddles = least <= 0 && most >= 0;
      ASSERT_EQ(Has(kept, k), meets && straddles) << i;
      if (k >= c.count) continue;
      if (meets && straddles) ++kept_count;
      if (meets && !straddles) ++on_one_side;
      if (!meets && straddles) ++outside;
    }
  }
  EXPECT_GT(kept_count, 1000);
  EXPECT_GT(on_one_side, 1000);
  EXPECT_GT(outside, 1000);
}

TEST(PlaneRegion, KeepsABoxAroundAPointOfThePlane) {
  PortableRandom random(2);
  int tested = 0;
  for (int i = 0; i < 100000; ++i) {
    IntegerCase c = RandomCase(random);
    // A point of the plane: two integer vectors at right angles to the normal
    // lead there.
    const Integers& n = c.normal;
    const int s = random.Integer(-2, 2);
    const int t = random.Integer(-2, 2);
    const Integers p{c.point[0] + s * n[1] + t * n[2], c.point[1] - s * n[0],
                     c.point[2] - t * n[0]};
    Box box;
    c.region = RandomBox(random, 30, 30);
    bool is_inside = true;
    for (std::size_t k = 0; k < 3; ++k) {
      is_inside = is_inside && c.region.lo[k] <= p[k] && p[k] <= c.region.hi[k];
      box.lo[k] = p[k] - random.Integer(0, 3);
      box.hi[k] = p[k] + random.Integer(0, 3);
    }
    if (!is_inside) continue;
    c.boxes.Set(0, box);
    ++tested;
    // The error bound is reached, or not, or is much too large.
    const std::array<double, 4> errors{0, 0x1p-30, 0x1p-10, 0x1p10};
    const double error = errors[static_cast<std::size_t>(i % 4)];
    const auto off = [&] { return error * random.Integer(-8, 8) / 8; };
    ASSERT_TRUE(Has(Kept(c, 1, 1, {off(), off(), off()}, error), 0)) << i;
    // Where something under- or overflows nothing is lost.
    const double length = std::ldexp(1, random.Integer(-1070, 1010));
    const double size = std::ldexp(1, random.Integer(-900, 900));
    ASSERT_TRUE(Has(Kept(c, length, size, {off(), off(), off()}, error), 0))
        << i;
  }
  EXPECT_GT(tested, 1000);
}

TEST(PlaneRegion, LeavesOutWhatIsClearlyOnOneSideOrOutside) {
  PortableRandom random(3);
  int on_one_side = 0;
  int outside = 0;
  for (int i = 0; i < 100000; ++i) {
    const IntegerCase c = RandomCase(random);
    // Boxes are at most 27 away along each axis. There the normal's error makes
    // up at most 3 * 27 * 2^-8, and so does the bound: less than 1 in all.
    const double error = 0x1p-8;
    const auto off = [&] { return error * random.Integer(-8, 8) / 8; };
    const double length = std::ldexp(1, random.Integer(-300, 300));
    const double size = std::ldexp(1, random.Integer(-300, 300));
    const unsigned kept = Kept(c, length, size, {off(), off(), off()}, error);
    for (int k = 0; k < c.count; ++k) {
      const Box box = c.boxes.Get(static_cast<std::size_t>(k));
      const auto [least, most] = Heights(c, box);
      const bool is_apart = !Meet(box, c.region);
      if (least < 1 && most > -1 && !is_apart) continue;
      ASSERT_FALSE(Has(kept, k)) << i;
      ++(is_apart ? outside : on_one_side);
    }
  }
  EXPECT_GT(on_one_side, 1000);
  EXPECT_GT(outside, 1000);
}

}  // namespace
}  // namespace truelux
