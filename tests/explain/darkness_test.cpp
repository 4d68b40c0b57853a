// SPDX-License-Identifier: GPL-3.0-or-later
#include "explain/darkness.h"

#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/irradiance.h"

#include "text/receiver_sample.h"

namespace truelux {
namespace {

/// A square of side 2 around (x, 0, z).
std::vector<Point3> Square(double x, double z, bool faces_down) {
  std::vector<Point3> ring{
      {x - 1, -1, z}, {x + 1, -1, z}, {x + 1, 1, z}, {x - 1, 1, z}};
  if (faces_down) ring = {ring[0], ring[3], ring[2], ring[1]};
  return ring;
}

const Receiver kUp{{0, 0, 0}, {0, 0, 1}};

TEST(Darkness, CountsEveryEmitterByTheBestThatIsHadOfIt) {
  SceneBuilder builder;
  builder.AddFace(Square(0, 9, false), {1, 1, 1});   // its back
  builder.AddFace(Square(3, 9, false), {1, 1, 1});   // its back
  builder.AddFace(Square(0, -2, false), {1, 1, 1});  // below, its front
  builder.AddFace(Square(0, 5, true), {1, 1, 1});    // hidden
  builder.AddFace(Square(0, 4, true));
  builder.AddFace(Square(5, 0, true), {1, 1, 1});  // edge-on
  const Scene scene = *builder.Build().value;
  ASSERT_EQ(Oracle(scene).Evaluate(kUp).value, Rgb{});
  const Darkness darkness = DarknessOf(scene, {&kUp, 1});
  EXPECT_EQ(darkness.emitters, 5U);
  EXPECT_EQ(darkness.backs, 2U);
  EXPECT_EQ(darkness.below_horizon, 1U);
  EXPECT_EQ(darkness.hidden, 1U);
  EXPECT_EQ(darkness.edge_on, 1U);
  EXPECT_EQ(DarknessText(darkness),
            "everything is 0 although faces emit: 2 of 5 emitters show their "
            "backs, 1 of 5 emitters is below the horizon, 1 of 5 emitters is "
            "hidden, 1 of 5 emitters is seen edge-on (wound the wrong way? "
            "--two-sided lets faces emit to both sides)");
  // From another receiver the last is behind, which is nearer to light.
  const std::vector<Receiver> two{kUp, {{0, 0, 1}, {0, 0, 1}}};
  EXPECT_EQ(DarknessOf(scene, two).edge_on, 0U);
  EXPECT_EQ(DarknessText({}), "");
}

TEST(ReceiverSample, IsSpreadEvenlyOverARowOfAnyLength) {
  for (const std::size_t n : {1U, 15U, 16U, 17U, 100U, 1000U, 12345U}) {
    ReceiverSample sample;
    for (std::size_t i = 0; i < n; ++i)
      sample.Take({{static_cast<double>(i), 0, 0}, {0, 0, 1}});
    const auto kept = sample.kept();
    ASSERT_FALSE(kept.empty());
    ASSERT_LE(kept.size(), ReceiverSample::kMost);
    if (n >= ReceiverSample::kMost) {
      EXPECT_GE(kept.size(), ReceiverSample::kMost / 2);
    }
    EXPECT_EQ(kept.front().position.x, 0);
    const double step =
        kept.size() > 1 ? kept[1].position.x - kept[0].position.x : 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      EXPECT_EQ(kept[i].position.x, step * static_cast<double>(i));
    }
    EXPECT_GT(kept.back().position.x + step + 0.5, static_cast<double>(n) - 1);
  }
}

}  // namespace
}  // namespace truelux
