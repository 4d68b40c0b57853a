// SPDX-License-Identifier: GPL-3.0-or-later
// Where pictures of a floor have kinks: there and nowhere else, as high as the
// exact kinks of the oracle.

#include "image/kink_jumps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/derivatives.h"

#include "image/picture_view.h"
#include "support/scene_text.h"

namespace truelux {
namespace {

constexpr int kSize = 64;
constexpr const char* kLamp = "newmtl lamp\nKe 3 2 1\nnewmtl black\nKd 0 0 0\n";

/// A floor of 8 x 8 and a lamp of 2 x 2, 4 above its middle.
const std::string kRoom =
    "o floor\nusemtl black\nv -4 -4 0\nv 4 -4 0\nv 4 4 0\nv -4 4 0\n"
    "f -4 -3 -2 -1\n"
    "o lamp\nusemtl lamp\nv -1 -1 4\nv -1 1 4\nv 1 1 4\nv 1 -1 4\n"
    "f -4 -3 -2 -1\no blocker\nusemtl black\n";

/// An upright plate in the plane x = 1/2.
const std::string kPlate =
    "v 0.5 -0.5 1\nv 0.5 0.5 1\nv 0.5 0.5 2\nv 0.5 -0.5 2\nf -4 -3 -2 -1\n";

/// A triangle that no edge of the lamp is parallel to.
const std::string kTriangle =
    "v 0.3 -0.7 1.1\nv -0.4 0.9 1.4\nv 0.2 0.6 2.3\nf -3 -2 -1\n";

struct Floor {
  explicit Floor(const std::string& blockers, int size = kSize)
      : oracle(SceneFromText(kRoom + blockers, kLamp)),
        frame(FrameOf(oracle.scene(), "floor")),
        receivers(ReceiversOf(oracle.scene(), frame, {size, size})) {}

  [[nodiscard]] KinkJumps Find(int threads = 1) const {
    return FindKinkJumps(oracle, std::get<SurfaceFrame>(frame.frame),
                         *receivers, threads, {});
  }

  [[nodiscard]] Vector3 GradientAt(double x, double y) const {
    const DerivativeOptions options{.sphere = false, .jacobian = false};
    return oracle.Derivatives({{x, y, 0}, {0, 0, 1}, 1}, options)
        .channels[0]
        .tangential;
  }

  Oracle oracle;
  PictureFrame frame;
  std::unique_ptr<PixelReceivers> receivers;
};

double Distance(const Vector3& a, const Vector3& b) {
  return std::hypot(b.x - a.x, b.y - a.y, b.z - a.z);
}

/// The middle of a pixel.
double MiddleOf(int x) {
  return (x + 0.5) * 8 / kSize - 4;
}

/// Columns with a jump of at least a size.
std::set<int> ColumnsOf(const Raster<Rgb>& jumps, double least) {
  std::set<int> columns;
  for (int y = 0; y < jumps.height(); ++y) {
    for (int x = 0; x < jumps.width(); ++x) {
      if (jumps.At(x, y)[0] >= least) columns.insert(x);
    }
  }
  return columns;
}

TEST(KinkJumps, NoneWithoutABlocker) {
  // The lamp's edges are level: their planes meet the floor nowhere.
  const KinkJumps found = Floor("").Find();
  EXPECT_FALSE(found.is_left_out);
  EXPECT_FALSE(found.is_partial);
  EXPECT_TRUE(ColumnsOf(found.lengths, 1e-300).empty());
}

TEST(KinkJumps, APlateHasTheTraceOfItsPlaneAndOfEdgesParallelToTheLamps) {
  const KinkJumps found = Floor(kPlate).Find();
  // Its plane is x = 1/2. Its lower edge covers an edge of the lamp from x =
  // 1/3 and 1, its upper one from 0 and 2; of two pixels the right one.
  EXPECT_EQ(ColumnsOf(found.lengths, 1e-4),
            (std::set<int>{32, 34, 36, 40, 48}));
}

TEST(KinkJumps, ThePlatesPlaneKinksWhereItCutsTheLampOnly) {
  // From (1/2, t) the lamp ends at the direction (1 - t) / 4 upwards, and the
  // plate begins at (1/2 - t) / 2 and goes on to the other side: they overlap
  // for |t| < 2.
  const KinkJumps found = Floor(kPlate).Find();
  for (int row = 0; row < kSize; ++row) {
    const double t = -MiddleOf(row);
    EXPECT_EQ(found.lengths.At(36, row)[0] > 1e-6, std::fabs(t) < 2) << t;
  }
}

TEST(KinkJumps, JumpsAreTwiceTheOraclesKinks) {
  const Floor floor(kPlate);
  const KinkJumps found = floor.Find();
  int compared = 0;
  for (int row = 0; row < kSize; ++row) {
    for (const auto& [column, x] : {std::pair{36, 0.5}, {40, 1.0}, {48, 2.0}}) {
      const double y = -MiddleOf(row);
      const Derivatives exact =
          floor.oracle.Derivatives({{x, y, 0}, {0, 0, 1}, 1});
      const Rgb& jump = found.lengths.At(column, row);
      if (exact.kinks.empty()) {
        EXPECT_LT(jump[0], 1e-6) << x << " " << y;
        continue;
      }
      ASSERT_EQ(exact.kinks.size(), 1U);
      const Kink& kink = exact.kinks.front();
      const double level = std::hypot(kink.normal.x, kink.normal.y);
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(jump[k], 2 * std::fabs(kink.size[k]) * level, 1e-5)
            << x << " " << y;
      }
      ++compared;
    }
  }
  EXPECT_GT(compared, 60);
}

TEST(KinkJumps, ATriangleKinksInItsPlaneOnly) {
  const Floor floor(kTriangle);
  const Raster<Rgb> jumps = floor.Find().lengths;
  int met = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      if (jumps.At(x, y)[0] < 1e-4) continue;
      ++met;
      const Vector3 u = {-0.7, 1.6, 0.3};
      const Vector3 v = {-0.1, 1.3, 1.2};
      const Vector3 n = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z,
                         u.x * v.y - u.y * v.x};
      const double height = n.x * (MiddleOf(x) - 0.3) +
                            n.y * (-MiddleOf(y) + 0.7) + n.z * (0 - 1.1);
      EXPECT_LT(std::fabs(height) / std::hypot(n.x, n.y), 8.0 / kSize);
    }
  }
  EXPECT_GT(met, 5);
}

/// Places between two points of a row where the gradient changes by `least`
/// over next to nothing: halves that change less are left.
void FindJumps(const Floor& floor, double y, double left, double right,
               double least, std::vector<double>& found) {
  if (Distance(floor.GradientAt(left, y), floor.GradientAt(right, y)) < least)
    return;
  if (right - left < 0x1p-24) {
    found.push_back(left);
    return;
  }
  const double middle = (left + right) / 2;
  FindJumps(floor, y, left, middle, least, found);
  FindJumps(floor, y, middle, right, least, found);
}

TEST(KinkJumps, NothingIsMissed) {
  constexpr double kLeast = 2e-3;
  const std::string oblique =
      "v -1.25 -0.5 0.5\nv -0.25 0.75 0.75\nv -0.5 1 2\nv -1.5 -0.25 1.75\n"
      "f -4 -3 -2 -1\n";
  const Floor floor(kPlate + kTriangle + oblique);
  const Raster<Rgb> jumps = floor.Find().lengths;
  std::size_t met = 0;
  for (int row = 3; row < kSize; row += 8) {
    for (int x = 0; x + 1 < kSize; ++x) {
      std::vector<double> found;
      FindJumps(floor, -MiddleOf(row), MiddleOf(x), MiddleOf(x + 1), kLeast,
                found);
      met += found.size();
      for (const double at : found) {
        // A trace is looked at once a column, or once a row.
        double largest = 0;
        for (int dy = -1; dy <= 1; ++dy) {
          for (int dx = -1; dx <= 2; ++dx) {
            if (jumps.Contains(x + dx, row + dy))
              largest = std::max(largest, jumps.At(x + dx, row + dy)[0]);
          }
        }
        EXPECT_GT(largest, kLeast / 4) << at << " " << -MiddleOf(row);
      }
    }
  }
  EXPECT_GT(met, 8U);
}

TEST(KinkJumps, AWallsFootIsNoKink) {
  // It stands on the floor: E itself jumps from its one side to the other.
  const KinkJumps found =
      Floor("v 0.5 -1 0\nv 0.5 1 0\nv 0.5 1 1\nv 0.5 -1 1\nf -4 -3 -2 -1\n")
          .Find();
  for (int row = 0; row < kSize; ++row) {
    // At y = 1 and -1 its ends stand before edges of the lamp.
    if (std::fabs(MiddleOf(row)) > 0.9) continue;
    EXPECT_EQ(found.lengths.At(36, row)[0], 0) << MiddleOf(row);
  }
}

TEST(KinkJumps, ThreadsDoNotMatter) {
  const Floor floor(kPlate + kTriangle);
  EXPECT_EQ(floor.Find(1).lengths.pixels(), floor.Find(3).lengths.pixels());
}

TEST(KinkJumps, MoreCrossingsThanPixelsAreLeftOut) {
  // A fan of plates through one upright line has a trace for each of them.
  std::string fan;
  for (int k = 0; k < 12; ++k) {
    const std::string end = std::to_string(k - 5.5) + " 1 ";
    fan += "v 0 0 1\nv " + end + "1\nv " + end + "2\nv 0 0 2\nf -4 -3 -2 -1\n";
  }
  const Floor floor(fan, 2);
  const KinkJumps found = floor.Find();
  EXPECT_TRUE(found.is_left_out);
  EXPECT_TRUE(ColumnsOf(found.lengths, 1e-300).empty());
  EXPECT_FALSE(Floor(fan, 256).Find().is_left_out);
}

}  // namespace
}  // namespace truelux
