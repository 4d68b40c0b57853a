// SPDX-License-Identifier: GPL-3.0-or-later
// A bundle of planes says what its planes say one by one.

#include "exact/plane_bundle.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "exact/number.h"
#include "support/portable_random.h"

namespace truelux {
namespace {

using testing::PortableRandom;

TEST(PlaneBundle, AgreesWithEveryPlane) {
  PortableRandom random(1);
  std::array<int, 3> signs{};
  for (int i = 0; i < 20000; ++i) {
    const int range = i % 4 == 0 ? 500 : 3;
    const auto vector = [&]() -> ApproxVector {
      const auto number = [&] {
        return random.OneIn(5) ? 0.0
                               : std::ldexp(random.Uniform(-1, 1),
                                            random.Integer(-range, range));
      };
      return {number(), number(), number(), std::fabs(number()) * 0x1p-50};
    };
    const RoundUpward rounding;
    PlaneBundle bundle;
    std::vector<FilteredPlane> planes;
    const int size = random.Integer(1, 8);
    for (int k = 0; k < size; ++k) {
      planes.push_back(MakeFilteredPlane(vector()));
      bundle.Add(planes.back(), ViewPlaneId(100 + k));
    }
    const FilteredDirection d = MakeFilteredDirection(vector());
    BundleSides sides;
    bundle.Filter<true>(d, sides);
    EXPECT_EQ(bundle.size(), planes.size());
    EXPECT_EQ(bundle.mask(), (1U << size) - 1);
    EXPECT_EQ((sides.positive | sides.negative) & ~bundle.mask(), 0U);
    for (std::size_t k = 0; k < planes.size(); ++k) {
      const BoundedValue value = FilteredDot(planes[k], d);
      const Side side = sides.SideOf(k);
      EXPECT_EQ(bundle.id(k), ViewPlaneId(100 + static_cast<int>(k)));
      EXPECT_EQ(side.value.value, value.value);
      EXPECT_EQ(side.value.error, value.error);
      EXPECT_EQ(side.sign, TrySign(value).value_or(Sign::kZero));
      ++signs[static_cast<std::size_t>(static_cast<int>(side.sign) + 1)];
    }
  }
  for (const int count : signs)
    EXPECT_GT(count, 5000);
}

TEST(PlaneBundle, NaNAndOverflowDecideNothing) {
  const RoundUpward rounding;
  PlaneBundle bundle;
  bundle.Add(MakeFilteredPlane({0x1p600, 0, 0, 0}), ViewPlaneId(0));
  bundle.Add(MakeFilteredPlane({HUGE_VAL, 0, 0, 0}), ViewPlaneId(1));
  bundle.Add(MakeFilteredPlane({1, 0, 0, HUGE_VAL}), ViewPlaneId(2));
  BundleSides sides;
  bundle.Filter<true>(MakeFilteredDirection({-0x1p600, 0, 0, 0}), sides);
  EXPECT_EQ(sides.positive, 0U);
  EXPECT_EQ(sides.negative, 0U);
  bundle.Filter<true>(MakeFilteredDirection({std::nan(""), 0, 0, 0}), sides);
  EXPECT_EQ(sides.positive, 0U);
  EXPECT_EQ(sides.negative, 0U);
}

}  // namespace
}  // namespace truelux
