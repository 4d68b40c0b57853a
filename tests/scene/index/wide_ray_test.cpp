// SPDX-License-Identifier: GPL-3.0-or-later
// RayBoxes of rays whose direction is known up to an error.

#include <array>
#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include "exact/number.h"
#include "scene/index/ray_boxes.h"
#include "support/portable_random.h"

namespace truelux {
namespace {

using testing::PortableRandom;

using Numbers = std::array<double, 3>;

/// A true ray and what is known of it. All numbers are integers of some bits
/// over a power of two, so that points of the ray are exact.
struct WideRay {
  Numbers origin{};
  Numbers direction{};
  Numbers known{};  ///< the direction, off by at most `error`
  double error = 0;
  double end = HUGE_VAL;
};

double Dyadic(PortableRandom& random, int most, int bits) {
  return std::ldexp(random.Integer(-(most << bits), most << bits), -bits);
}

/// Components of the direction are about 1, some of them 0 or far smaller than
/// the error.
WideRay RandomRay(PortableRandom& random, double error) {
  WideRay ray;
  ray.error = error;
  const auto longest = static_cast<std::size_t>(random.Integer(0, 2));
  for (std::size_t k = 0; k < 3; ++k) {
    ray.origin[k] = Dyadic(random, 8, 8);
    const int kind = k == longest ? 3 : random.Integer(0, 4);
    if (kind == 1) {
      ray.direction[k] = error * Dyadic(random, 1, 4);
    } else if (kind > 1) {
      const double size = std::ldexp(random.Integer(64, 1024), -10);
      ray.direction[k] = random.OneIn(2) ? size : -size;
    }
    ray.known[k] = ray.direction[k] + error * Dyadic(random, 1, 3);
  }
  if (random.OneIn(4)) ray.known = ray.direction;
  if (!random.OneIn(4)) ray.end = std::ldexp(random.Integer(0, 512), -5);
  return ray;
}

/// 0, or so large that all products of the tests fit in 53 bits.
double RandomError(PortableRandom& random) {
  constexpr std::array<double, 4> kErrors{0, 0x1p-20, 0x1p-16, 0x1p-12};
  return kErrors[static_cast<std::size_t>(random.Integer(0, 3))];
}

/// A parameter up to the end.
double RandomParameter(PortableRandom& random, const WideRay& ray) {
  const double t = std::ldexp(random.Integer(0, 512), -5);
  return random.OneIn(4) && ray.end < HUGE_VAL ? ray.end
                                               : std::fmin(t, ray.end);
}

Numbers PointAt(const WideRay& ray, double t) {
  Numbers p{};
  for (std::size_t k = 0; k < 3; ++k)
    p[k] = ray.origin[k] + t * ray.direction[k];
  return p;
}

/// Whether the rays keep a box, lengths and directions scaled by powers of two.
bool Keeps(const WideRay& ray, const Box& box, double length = 1,
           double speed = 1) {
  FourBoxes boxes;
  Box scaled;
  for (std::size_t k = 0; k < 3; ++k) {
    scaled.lo[k] = length * box.lo[k];
    scaled.hi[k] = length * box.hi[k];
  }
  boxes.Set(2, scaled);
  const auto [x, y, z] = ray.origin;
  const auto [u, v, w] = ray.known;
  const RoundUpward rounding;
  const RayBoxes rays(
      {length * x, length * y, length * z},
      ApproxVector{speed * u, speed * v, speed * w, speed * ray.error},
      ray.end * (length / speed));
  const unsigned kept = rays.Kept(boxes);
  EXPECT_EQ(kept & ~4U, 0U);  // the other boxes are empty
  return kept != 0;
}

/// A box with a corner or more of its faces at the point, or one of no size.
Box BoxAround(PortableRandom& random, const Numbers& p) {
  Box box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.lo[k] = p[k] - (random.OneIn(2) ? 0 : Dyadic(random, 1, 4) + 1);
    box.hi[k] = p[k] + (random.OneIn(2) ? 0 : Dyadic(random, 1, 4) + 1);
  }
  return box;
}

TEST(WideRay, KeepsWhatHoldsAPointOfARay) {
  PortableRandom random(1);
  for (int i = 0; i < 50000; ++i) {
    const WideRay ray = RandomRay(random, RandomError(random));
    const Numbers p = PointAt(ray, RandomParameter(random, ray));
    const Box box = BoxAround(random, p);
    ASSERT_TRUE(Keeps(ray, box)) << i;
    const double length = std::ldexp(1, random.Integer(-400, 400));
    const double speed = std::ldexp(1, random.Integer(-400, 400));
    ASSERT_TRUE(Keeps(ray, box, length, speed)) << i;
  }
}

/// A vector at right angles to a direction; its largest component is 1.
Numbers Across(PortableRandom& random, const Numbers& d) {
  Numbers across{};
  double size = 0;
  while (!(size > 0.01)) {
    const Numbers a{random.Uniform(-1, 1), random.Uniform(-1, 1),
                    random.Uniform(-1, 1)};
    across = {d[1] * a[2] - d[2] * a[1], d[2] * a[0] - d[0] * a[2],
              d[0] * a[1] - d[1] * a[0]};
    size = std::fmax(std::fabs(across[0]),
                     std::fmax(std::fabs(across[1]), std::fabs(across[2])));
  }
  for (double& x : across)
    x /= size;
  return across;
}

/// At a distance of 2, where no ray is off by more than 2^-12 * 16.
TEST(WideRay, LeavesOutWhatIsFarFromAllRays) {
  PortableRandom random(2);
  int beside = 0;
  int beyond = 0;
  int behind = 0;
  for (int i = 0; i < 50000; ++i) {
    WideRay ray = RandomRay(random, RandomError(random));
    // Across a component of the size of the error the rays spread without end.
    if (!(ray.end < HUGE_VAL)) ray.end = 16;
    const double t = RandomParameter(random, ray);
    Numbers p = PointAt(ray, t);
    switch (random.Integer(0, 2)) {
      case 0: {
        const Numbers across = Across(random, ray.direction);
        for (std::size_t k = 0; k < 3; ++k)
          p[k] += 2 * across[k];
        ++beside;
        break;
      }
      case 1:
        p = PointAt(ray, ray.end + 2);
        ++beyond;
        break;
      default:
        p = PointAt(ray, -2);
        ++behind;
        break;
    }
    Box box;
    for (std::size_t k = 0; k < 3; ++k) {
      box.lo[k] = p[k] - 0.01;
      box.hi[k] = p[k] + 0.01;
    }
    const double length = std::ldexp(1, random.Integer(-400, 400));
    const double speed = std::ldexp(1, random.Integer(-400, 400));
    ASSERT_FALSE(Keeps(ray, box)) << i;
    ASSERT_FALSE(Keeps(ray, box, length, speed)) << i;
  }
  EXPECT_GT(beside, 1000);
  EXPECT_GT(beyond, 1000);
  EXPECT_GT(behind, 1000);
}

/// A ray along an axis with an error far below what moves it, up to an end.
TEST(WideRay, AlongAnAxisIsAsThinAsItsErrorUpToItsEnd) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      WideRay ray;
      ray.known[axis] = sign;
      ray.error = 0x1p-40;
      ray.end = 4;
      const std::size_t side = axis == 2 ? 0 : axis + 1;
      const auto box_at = [&](double along, double across) {
        Numbers p{};
        p[axis] = sign * along;
        p[side] = across;
        return Box{p, p};
      };
      for (const double t : {0.0, 1.0, 4.0}) {
        EXPECT_TRUE(Keeps(ray, box_at(t, 0)));
        // A ray of the bundle goes through here.
        EXPECT_TRUE(Keeps(ray, box_at(t, t * 0x1p-40)));
        EXPECT_TRUE(Keeps(ray, box_at(t, -t * 0x1p-40)));
        EXPECT_FALSE(Keeps(ray, box_at(t, 0x1p-37)));
        EXPECT_FALSE(Keeps(ray, box_at(t, -0x1p-37)));
      }
      EXPECT_FALSE(Keeps(ray, box_at(4.001, 0)));
      EXPECT_FALSE(Keeps(ray, box_at(-0.001, 0)));
      // Without an end it may get anywhere.
      ray.end = HUGE_VAL;
      EXPECT_TRUE(Keeps(ray, box_at(0x1p60, 0x1p20)));
      EXPECT_FALSE(Keeps(ray, box_at(-0.001, 0)));
    }
  }
}

TEST(WideRay, EndsWhereItIsToldTo) {
  FourBoxes boxes;
  boxes.Set(0, {{2, 0, 0}, {2, 0, 0}});
  const RoundUpward rounding;
  RayBoxes rays({0, 0, 0}, ApproxVector{1, 0, 0, 0x1p-30}, 3);
  EXPECT_EQ(rays.Kept(boxes), 1U);
  rays.EndAt(1.5);
  EXPECT_EQ(rays.Kept(boxes), 0U);
}

}  // namespace
}  // namespace truelux
