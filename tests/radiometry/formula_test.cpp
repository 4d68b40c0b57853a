// SPDX-License-Identifier: GPL-3.0-or-later
// Every formula at every number type, on polygons whose form factor is known.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "radiometry/formula_runs.h"
#include "radiometry/formulas/image_plane.h"
#include "radiometry/known_views.h"
#include "radiometry/random_polygons.h"
#include "support/scenes.h"

namespace truelux::testing {
namespace {

/// |value - truth|, less what was left out.
template <class T>
Real ErrorOf(const PartialSum<T>& sum, const Real& truth) {
  return Abs(ToReal(sum.value) - truth) - Real(sum.truncation);
}

class FormulaOnPolygons : public ::testing::TestWithParam<Formula> {
 protected:
  template <class T>
  void ExpectNear(const KnownView& view) {
    // The image plane loses a factor of the half-side.
    constexpr double kHalfSide = 32;
    const PartialSum<T> sum = RunFormula<T>(
        GetParam(), PolygonContour(view.ring, view.position, view.normal),
        kHalfSide);
    if (GetParam() == Formula::kSeries) {
      EXPECT_FALSE(sum.applicable) << view.name;
      return;
    }
    ASSERT_TRUE(sum.applicable) << view.name;
    const Real truth = TruthOf(view);
    EXPECT_LE(ErrorOf(sum, truth), Real(PlainError<T>()) * truth)
        << view.name << " " << sizeof(T);
  }
};

TEST_P(FormulaOnPolygons, GivesTheClosedFormAtEveryType) {
  for (const KnownView& view : KnownViews()) {
    ExpectNear<float>(view);
    ExpectNear<double>(view);
    ExpectNear<DoubleDouble>(view);
    ExpectNear<Multiprecision>(view);
  }
}

TEST_P(FormulaOnPolygons, BallHoldsTheClosedFormAndIsNarrow) {
  if (GetParam() == Formula::kSeries) GTEST_SKIP() << "not applicable";
  for (const KnownView& view : KnownViews()) {
    const auto sum = RunFormula<Ball<double>>(
        GetParam(), PolygonContour(view.ring, view.position, view.normal));
    EXPECT_LE(ErrorOf(sum, TruthOf(view)), Real(sum.value.error)) << view.name;
    EXPECT_LE(sum.value.error, NeedsBoundedRegion(GetParam()) ? 1e-2 : 1e-12)
        << view.name;
  }
}

// The known forms themselves, against the reference.
TEST(KnownViews, AgreeWithTheReference) {
  for (const KnownView& view : KnownViews()) {
    const Real reference = FormFactor(view.ring, view.position, view.normal);
    EXPECT_LE(Abs(TruthOf(view) - reference), Real(1e-300)) << view.name;
    EXPECT_LT(Real(0.01), reference) << view.name;
  }
}

// Only what is left out may have a truncation, and only there.
TEST_P(FormulaOnPolygons, OnlyFormsThatAreNotClosedLeaveSomethingOut) {
  for (const KnownView& view : KnownViews()) {
    const auto sum = RunFormula<double>(
        GetParam(), PolygonContour(view.ring, view.position, view.normal));
    const bool closed =
        !NeedsFan(GetParam()) && !NeedsBoundedRegion(GetParam());
    if (closed) {
      EXPECT_EQ(sum.truncation, 0) << view.name;
    }
    if (GetParam() == Formula::kCubature) {
      EXPECT_LE(sum.truncation, 0x1p-53 * sum.value) << view.name;
    }
  }
}

// Engines may add such pairs. They also bring arcs of the sense that no outline
// has along the horizon.
TEST_P(FormulaOnPolygons, PairsOfOppositeArcsAddNothing) {
  for (const KnownView& view : KnownViews()) {
    HandContour contour = PolygonContour(view.ring, view.position, view.normal);
    Contour& arcs = contour.contour();
    const int count = arcs.sources[SourceId(0)].arc_count;
    for (int i = 0; i < count; ++i) {
      const Arc arc = arcs.arcs[ArcId(i)];
      arcs.arcs.push_back(arc);
      arcs.arcs.push_back({arc.plane, !arc.positive, arc.to, arc.from, {}});
    }
    arcs.sources[SourceId(0)].arc_count = 3 * count;
    const auto sum = RunFormula<Ball<double>>(GetParam(), contour, 32);
    if (!sum.applicable) continue;
    EXPECT_LE(ErrorOf(sum, TruthOf(view)), Real(sum.value.error)) << view.name;
    EXPECT_LE(sum.value.error, 1e-9) << view.name;
  }
}

TEST_P(FormulaOnPolygons, LimitIsTheHemisphere) {
  // A square of half-side 1 closer and closer above the receiver.
  for (const double height : {0x1p-4, 0x1p-10, 0x1p-20}) {
    const Ring ring = Ceiling(-1, 1, -1, 1, height);
    const Real truth = Real(4) * CornerRectangle(1 / height, 1 / height);
    const auto sum = RunFormula<Ball<double>>(
        GetParam(), PolygonContour(ring, {}, {0, 0, 1}));
    if (!sum.applicable) {
      EXPECT_TRUE(NeedsFan(GetParam()));
      continue;
    }
    EXPECT_LE(ErrorOf(sum, truth), Real(sum.value.error)) << height;
    if (!NeedsFan(GetParam())) {
      EXPECT_LE(sum.value.error, 1e-7) << height;
    }
  }
}

TEST_P(FormulaOnPolygons, IsTheSumOfTwoParts) {
  PortableRandom random(71);
  for (int i = 0; i < 50; ++i) {
    const double size = i % 2 == 0 ? 0.05 : 0.8;
    const RandomView view = Tilted(MakeRandomView(random, size, 0.9, 0));
    // The parts share a diagonal of the ring, so that nothing is rounded.
    const std::vector<Point3> first(view.ring.begin(), view.ring.begin() + 3);
    std::vector<Point3> second = view.ring;
    if (second.size() == 3) continue;
    second.erase(second.begin() + 1);
    const auto run = [&](const std::vector<Point3>& ring) {
      return RunFormula<Ball<double>>(
          GetParam(), PolygonContour(ring, view.position, view.normal));
    };
    const auto whole = run(view.ring);
    const auto a = run(first);
    const auto b = run(second);
    // Rings are not exactly planar, so that only contours without a plane of
    // their own may be compared: as seen from r the parts tile the whole.
    if (!whole.applicable || !a.applicable || !b.applicable) continue;
    EXPECT_LE(std::fabs(whole.value.value - (a.value.value + b.value.value)),
              whole.value.error + a.value.error + b.value.error +
                  whole.truncation + a.truncation + b.truncation)
        << i;
  }
}

/// p turned by an integer quaternion (w, x, y, z) and scaled by its square:
/// exact for small integers.
Point3 Turned(const std::array<int, 4>& q, const Point3& p) {
  const double w = q[0];
  const double x = q[1];
  const double y = q[2];
  const double z = q[3];
  return {(w * w + x * x - y * y - z * z) * p.x + 2 * (x * y - w * z) * p.y +
              2 * (x * z + w * y) * p.z,
          2 * (x * y + w * z) * p.x + (w * w - x * x + y * y - z * z) * p.y +
              2 * (y * z - w * x) * p.z,
          2 * (x * z - w * y) * p.x + 2 * (y * z + w * x) * p.y +
              (w * w - x * x - y * y + z * z) * p.z};
}

TEST_P(FormulaOnPolygons, IsTheSameInATurnedFrame) {
  PortableRandom random(72);
  int bounded = 0;
  int applicable = 0;
  for (int i = 0; i < 300; ++i) {
    const bool wall = i % 2 == 0;
    const int d = random.Integer(1, 5);
    const Ring ring = wall ? Ring{{1.0 * d, -2, -3},
                                  {1.0 * d, 4, -3},
                                  {1.0 * d, 3, 5},
                                  {1.0 * d, -2, 6}}
                           : Ceiling(-d, 3, -1, 2, 30);
    const Real truth = FormFactor(ring, {}, {0, 0, 1});
    const std::array<int, 4> q = {random.Integer(-5, 5), random.Integer(-5, 5),
                                  random.Integer(-5, 5), random.Integer(1, 5)};
    Ring turned;
    for (const Point3& p : ring)
      turned.push_back(Turned(q, p));
    const Point3 n = Turned(q, {0, 0, 1});
    const auto sum = RunFormula<Ball<double>>(
        GetParam(), PolygonContour(turned, {}, {n.x, n.y, n.z}));
    if (!sum.applicable) continue;
    ++applicable;
    ASSERT_LE(ErrorOf(sum, truth), Real(sum.value.error)) << i;
    if (sum.value.error < 1e-6) ++bounded;
  }
  // Where an end lies on the positive x axis up to rounding, "sphere" and
  // "projective" have no bound.
  const bool bounds_walls = !NeedsBoundedRegion(GetParam());
  EXPECT_GE(bounded, applicable * (bounds_walls ? 0.9 : 0.4));
  if (!NeedsFan(GetParam())) {
    EXPECT_EQ(applicable, 300);
  }
}

TEST_P(FormulaOnPolygons, HasTheSameBitsAtAnyPowerOfTwo) {
  PortableRandom random(73);
  for (int i = 0; i < 40; ++i) {
    const double elevation = i % 2 == 0 ? 0.9 : 0.1;
    RandomView view =
        Tilted(MakeRandomView(random, i % 4 < 2 ? 0.5 : 0.01, elevation, 0));
    const auto run = [&](double scale, double along) {
      const Vector3& n = view.normal;
      return RunFormula<Ball<double>>(
          GetParam(),
          PolygonContour(Scaled(view.ring, scale),
                         {view.position.x * scale, view.position.y * scale,
                          view.position.z * scale},
                         {n.x * along, n.y * along, n.z * along}));
    };
    const auto usual = run(1, 1);
    for (const double scale : {0x1p-990, 0x1p-300, 2.0, 0x1p400, 0x1p1000}) {
      for (const double along : {1.0, 0x1p-900, 0x1p1000}) {
        const auto scaled = run(scale, along);
        EXPECT_EQ(scaled.applicable, usual.applicable);
        EXPECT_EQ(scaled.value.value, usual.value.value) << scale << along;
        EXPECT_LE(scaled.value.error, usual.value.error * 1.01 + 1e-100);
      }
    }
  }
}

// The receiver is so near the edge in its plane that double does not know on
// which side; taken for the other one, the edge would count by 2 pi less.
TEST_P(FormulaOnPolygons, HoldsTheTruthNextToAnEdgeInTheReceiverPlane) {
  PortableRandom random(74);
  int narrow = 0;
  for (int i = 0; i < 200; ++i) {
    const Point3 p = {-random.Uniform(1, 2), -random.Uniform(1, 2), 0};
    Point3 q = {random.Uniform(1, 2), 0, 0};
    q.y = random.Nudge(p.y / p.x * q.x);
    const Real side = Real(p.x) * Real(q.y) - Real(p.y) * Real(q.x);
    if (side <= Real(0) && Real(0) <= side) continue;
    const Point3 up = {q.x, q.y, 1};
    const Point3 back = {p.x, p.y, 1};
    const Ring wall =
        side < Real(0) ? Ring{p, q, up, back} : Ring{q, p, back, up};
    const auto sum = RunFormula<Ball<double>>(
        GetParam(), PolygonContour(wall, {}, {0, 0, 1}));
    if (!sum.applicable) continue;
    ASSERT_LE(ErrorOf(sum, FormFactor(wall, {}, {0, 0, 1})),
              Real(sum.value.error))
        << i;
    if (sum.value.error < 1e-12) ++narrow;
  }
  // One term is +-pi / 2 by the edge's sense, which is known exactly.
  const bool knows =
      GetParam() == Formula::kUnified || GetParam() == Formula::kHomogeneous;
  if (knows) {
    EXPECT_GT(narrow, 100);
  }
}

// Far out, an edge along x adds nearly as much as an edge of its run can.
TEST(ImagePlane, BoundOfAnUnknownSlopeHoldsTheWorstEdge) {
  const Multiprecision far(kRunBits, 1e9);
  const Multiprecision level(kRunBits, 0.0);
  const Multiprecision start(kRunBits, 0.0);
  for (const double run : {1e-9, 1e-3, 0.1}) {
    const Multiprecision end(kRunBits, run);
    const double added =
        Leading(SlopeTerm(end, far, level) - SlopeTerm(start, far, level));
    const Ball<double> bound =
        BoundedByRun(Unbounded<double>(), Ball<double>{0, run});
    EXPECT_EQ(bound.value, 0);
    EXPECT_LE(std::fabs(added), bound.error);
    EXPECT_GE(std::fabs(added), 0.97 * bound.error);
  }
}

INSTANTIATE_TEST_SUITE_P(All, FormulaOnPolygons,
                         ::testing::ValuesIn(AllFormulas().subspan(1)),
                         TestNameOf);

}  // namespace
}  // namespace truelux::testing
