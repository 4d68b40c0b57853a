// SPDX-License-Identifier: GPL-3.0-or-later
// Regions cut to a square on the image plane.

#include "radiometry/square_clip.h"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "radiometry/formula_runs.h"
#include "radiometry/random_polygons.h"
#include "support/random_scene.h"
#include "support/scenes.h"
#include "visibility/edges/contour_engine.h"

namespace truelux::testing {
namespace {

/// The first source of a contour, cut to a square, by a formula that needs no
/// square itself.
Real CutFormFactor(const WeightedContour& contour, double half_side) {
  const BoundedContour cut = CutToSquare(contour, half_side);
  const WeightedContour bounded = {contour.view, cut.contour, contour.weights};
  if (cut.contour.sources[SourceId(0)].arc_count == 0) return {0};
  return ToReal(
      RunFormula<Multiprecision>(Formula::kLambertEdge, bounded).value);
}

/// A ring clipped to the square |x|, |y| <= R of the normal z, independently.
Real ClippedFormFactor(const std::vector<Point3>& ring, double half_side) {
  std::vector<RealVector> directions;
  for (const Point3& p : ring)
    directions.push_back(Relative(p, {}));
  const Real r(half_side);
  const RealVector normal = {Real(0), Real(0), Real(1)};
  for (const RealVector& side :
       {RealVector{Real(1), Real(0), r}, RealVector{Real(-1), Real(0), r},
        RealVector{Real(0), Real(1), r}, RealVector{Real(0), Real(-1), r}}) {
    directions = Clip(directions, side);
  }
  return FormFactorOfRing(directions, normal);
}

/// The exterior of the square: 1 - (4 / pi) s atan s, s = R / sqrt(1 + R^2).
Real BeyondSquare(double half_side) {
  const Real r(half_side);
  const Real s = r / Sqrt(Real(1) + r * r);
  return Real(1) - Real(4) / Real::Pi() * s * Atan2(s, Real(1));
}

TEST(CutToSquare, LeavesWhatIsInsideAsItIs) {
  const HandContour contour =
      PolygonContour(Ceiling(-1, 1, -2, 2, 1), {0.1, 0, 0}, {0, 0, 3});
  const WeightedContour weighted = contour.Weighted();
  const BoundedContour cut = CutToSquare(weighted, 2.5);
  EXPECT_FALSE(cut.is_cut[SourceId(0)]);
  EXPECT_EQ(cut.contour.planes, weighted.contour.planes);
  EXPECT_EQ(cut.contour.directions, weighted.contour.directions);
  ASSERT_EQ(cut.contour.arcs.size(), weighted.contour.arcs.size());
  for (const ArcId i : cut.contour.arcs.ids()) {
    EXPECT_EQ(cut.contour.arcs[i].from, weighted.contour.arcs[i].from);
    EXPECT_EQ(cut.contour.arcs[i].to, weighted.contour.arcs[i].to);
    EXPECT_EQ(cut.contour.arcs[i].plane, weighted.contour.arcs[i].plane);
    EXPECT_EQ(cut.contour.arcs[i].positive, weighted.contour.arcs[i].positive);
  }
}

TEST(CutToSquare, TouchingTheSquareIsInside) {
  const HandContour contour =
      PolygonContour(Ceiling(-1, 1, -1, 1, 1), {}, {0, 0, 1});
  EXPECT_FALSE(CutToSquare(contour.Weighted(), 1).is_cut[SourceId(0)]);
  EXPECT_TRUE(CutToSquare(contour.Weighted(), 1 - 0x1p-53).is_cut[SourceId(0)]);
}

struct Cut {
  std::string name;
  Ring ring;
};

std::vector<Cut> Cuts() {
  return {
      {"through_one_side", Ceiling(-1, 9, -1, 1, 1)},
      {"through_a_corner", Ceiling(-1, 9, -1, 9, 1)},
      {"through_two_sides", Ceiling(-9, 9, -1, 1, 1)},
      {"all_four_corners", Ceiling(-9, 9, -9, 9, 1)},
      {"diamond_past_four_corners",
       {{4, 0, 1}, {0, -4, 1}, {-4, 0, 1}, {0, 4, 1}}},
      {"triangle_round_two_corners", {{-7, 0, 1}, {1, 6, 1}, {1, -6, 1}}},
      {"wall_to_the_horizon", {{1, -2, 0}, {1, 2, 0}, {1, 2, 3}, {1, -2, 3}}},
      {"wall_through_the_horizon",
       {{1, -2, -5}, {1, 2, -5}, {1, 2, 3}, {1, -2, 3}}},
      {"wall_with_horizon_ends_on_axes",
       {{3, 0, 0}, {0, 3, 0}, {0, 3, 3}, {3, 0, 3}}},
      {"corner_on_the_square", {{3, 3, 1}, {0, -1, 1}, {-1, 0, 1}}},
      {"side_along_the_square", Ceiling(-1, 3, -1, 3, 1)},
      {"cut_off_whole", Ceiling(5, 6, 5, 6, 1)},
      {"cut_off_whole_behind_a_corner", {{5, 3, 1}, {4, 4, 1}, {5, 5, 1}}},
      {"outside_touching_the_square", Ceiling(3, 6, -1, 1, 1)},
  };
}

TEST(CutToSquare, IsTheRegionWithinTheSquare) {
  for (const Cut& cut : Cuts()) {
    for (const Ends ends : {Ends::kNatural, Ends::kExplicit}) {
      const HandContour contour = PolygonContour(cut.ring, {}, {0, 0, 2}, ends);
      for (const double half_side : {3.0, 0.3, 7.1, 1e-3, 1e6, 1e-200, 1e200}) {
        const Real truth = ClippedFormFactor(cut.ring, half_side);
        const Real found = CutFormFactor(contour.Weighted(), half_side);
        // Rounded axes turn the square by a few u; here they are exact, but
        // for rounding at 300 bits and cancelling pairs of arcs.
        EXPECT_LE(Abs(found - truth), Real(1e-80))
            << cut.name << " " << half_side;
      }
    }
  }
}

TEST(CutToSquare, KnowsWhatIsCutOffWhole) {
  const HandContour contour =
      PolygonContour(Ceiling(5, 6, 5, 6, 1), {}, {0, 0, 1});
  const BoundedContour cut = CutToSquare(contour.Weighted(), 3);
  EXPECT_TRUE(cut.is_cut[SourceId(0)]);
  const auto sum = RunFormula<Ball<double>>(Formula::kDirections, contour, 3);
  EXPECT_TRUE(sum.applicable);
  EXPECT_NEAR(sum.value.value, 0, sum.value.error);
  EXPECT_EQ(sum.truncation, FormFactorBeyond(3));
}

TEST(CutToSquare, MissesAtMostWhatIsBeyondAndNearlyThat) {
  // A square that fills all but 2^-60 of the hemisphere.
  const Ring ring = Ceiling(-0x1p40, 0x1p40, -0x1p40, 0x1p40, 1);
  const Real whole = FormFactor(ring, {}, {0, 0, 1});
  const HandContour contour = PolygonContour(ring, {}, {0, 0, 1});
  for (const double half_side : {3.0, 100.0, 0x1p20}) {
    const Real missing = whole - CutFormFactor(contour.Weighted(), half_side);
    EXPECT_LT(Abs(missing - BeyondSquare(half_side)).ToDouble(), 1e-24);
    const Real bound(FormFactorBeyond(half_side));
    EXPECT_LE(missing, bound);
    EXPECT_LE(Real(0.8) * bound, missing);
  }
}

TEST(CutToSquare, BoundOfWhatIsBeyondIsPositiveAndAtLeastLemma1) {
  for (const double half_side :
       {1e-300, 1e-20, 0.1, 1.0, 3.0, 1e8, 1e100, 1e160, 1e300}) {
    const Real r(half_side);
    EXPECT_LT(Real(1) / (Real(1) + r * r), Real(FormFactorBeyond(half_side)));
    EXPECT_LE(FormFactorBeyond(half_side), 1 + 0x1p-30);
  }
}

// Square and region turned: what is missing is between nothing and the bound.
TEST(CutToSquare, HoldsItsBoundForAnyNormal) {
  PortableRandom random(91);
  int cut_count = 0;
  for (int i = 0; i < 200; ++i) {
    RandomView view =
        Tilted(MakeRandomView(random, 1, random.Uniform(0, 0.5), i % 2 * 10));
    const double length = std::ldexp(1.0, random.Integer(-1000, 1000));
    view.normal = {view.normal.x * length, view.normal.y * length,
                   view.normal.z * length};
    const HandContour contour =
        PolygonContour(view.ring, view.position, view.normal,
                       i % 3 == 0 ? Ends::kCrossings : Ends::kNatural);
    const Real whole = FormFactor(view.ring, view.position, view.normal);
    for (const double half_side : {0.7, 3.0, 1e9}) {
      const Real missing = whole - CutFormFactor(contour.Weighted(), half_side);
      EXPECT_LE(Real(-1e-80), missing);
      EXPECT_LE(missing, Real(FormFactorBeyond(half_side)));
      const bool is_cut =
          CutToSquare(contour.Weighted(), half_side).is_cut[SourceId(0)];
      if (!is_cut) {
        EXPECT_LE(Abs(missing), Real(1e-80));
      }
      cut_count += is_cut ? 1 : 0;
    }
  }
  EXPECT_GT(cut_count, 200);
}

// Non-convex regions and regions with holes: a square that is inside of
// nothing but the source must give what two cuts give, S = (S in Q) + (S in
// the four quarters of the rest), which only closed contours do.
TEST(CutToSquare, CutsWhatOtherFacesHideAsWell) {
  PortableRandom random(92);
  int compared = 0;
  int with_cut = 0;
  for (int i = 0; i < 150; ++i) {
    std::vector<TestFace> faces = {{Ceiling(-6, 6, -6, 6, 3), {1, 1, 1}}};
    // Blockers that leave holes, notches and islands.
    for (int k = random.Integer(1, 4); k > 0; --k) {
      const double x = random.Integer(-4, 3);
      const double y = random.Integer(-4, 3);
      const double size = random.Integer(1, 4);
      faces.push_back({Ceiling(x / 2, (x + size) / 2, y / 2, (y + size) / 2,
                               random.OneIn(2) ? 1.0 : 1.5),
                       kBlack});
    }
    const ContourQuery query{MakeScene(faces), {{0, 0, 0}, {0, 0, 1}, 0}};
    Contour contour;
    const ContourEngine engine(query.scene);
    ContourBuilder(engine).Build(query, contour);
    if (contour.sources.empty()) continue;
    const std::vector<Rgb> weights(contour.sources.size(), {1, 1, 1});
    const WeightedContour weighted{ViewOf(query), contour, weights};
    for (const double half_side : {0.25, 0.75, 1.25}) {
      // The same blockers, and a source that is the square itself.
      std::vector<TestFace> small = faces;
      const double h = 3 * half_side;
      small[0].ring = Ceiling(-h, h, -h, h, 3);
      const ContourQuery inner{MakeScene(small), query.receiver};
      Contour truth;
      const ContourEngine inner_engine(inner.scene);
      ContourBuilder(inner_engine).Build(inner, truth);
      Real expected;
      if (!truth.sources.empty()) {
        const std::vector<Rgb> ones(truth.sources.size(), {1, 1, 1});
        expected = ToReal(RunFormula<Multiprecision>(
                              Formula::kLambertEdge,
                              WeightedContour{ViewOf(inner), truth, ones})
                              .value);
      }
      EXPECT_LE(Abs(CutFormFactor(weighted, half_side) - expected), Real(1e-80))
          << i << " " << half_side;
      ++compared;
      if (CutToSquare(weighted, half_side).is_cut[SourceId(0)]) ++with_cut;
    }
  }
  EXPECT_GT(compared, 300);
  EXPECT_GT(with_cut, 200);
}

}  // namespace
}  // namespace truelux::testing
