// SPDX-License-Identifier: GPL-3.0-or-later
// What formulas are given: points in the receiver's frame, their differences,
// planes and determinants.

#include "radiometry/boundary.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "radiometry/formula_runs.h"
#include "radiometry/random_polygons.h"
#include "support/scenes.h"

namespace truelux::testing {
namespace {

using B = Ball<double>;
using Frame = FrameGeometry<Ball<DoubleDouble>>;
using ExactFrame = FrameGeometry<Multiprecision>;

template <class T>
Boundary<T> BoundaryAt(const HandContour& contour, bool with_fan = false) {
  using W = typename WorkingType<T>::Type;
  const WeightedContour weighted = contour.Weighted();
  return BoundaryOf<T>(FrameGeometry<W>(weighted, kRunBits), SourceId(0),
                       with_fan);
}

template <class T>
RealVector ToReal(const Vec3<T>& v) {
  return {testing::ToReal(v.x), testing::ToReal(v.y), testing::ToReal(v.z)};
}

Real Det(const RealVector& a, const RealVector& b, const RealVector& c) {
  return Dot(Cross(a, b), c);
}

/// |x - y| beside |y|.
double Off(const Real& x, const Real& y) {
  return (Abs(x - y) / Abs(y)).ToDouble();
}

struct AxisFrame {
  Vector3 normal;
  /// Where the frame's axes are among the scene's, and their signs.
  std::array<int, 3> axes;
  std::array<int, 3> signs;
};

TEST(Frame, OfAnAxisIsARightHandedPermutationThatRoundsNothing) {
  const std::vector<AxisFrame> frames = {
      {{4, 0, 0}, {1, 2, 0}, {1, 1, 1}},
      {{-4, 0, 0}, {2, 1, 0}, {1, 1, -1}},
      {{0, 0x1p-1070, 0}, {2, 0, 1}, {1, 1, 1}},
      {{0, -3, -0.0}, {0, 2, 1}, {1, 1, -1}},
      {{0, 0, 1e300}, {0, 1, 2}, {1, 1, 1}},
      {{-0.0, 0, -0.1}, {1, 0, 2}, {1, 1, -1}},
  };
  for (const AxisFrame& frame : frames) {
    std::array<double, 3> height{};
    height[static_cast<std::size_t>(frame.axes[2])] = 3.0 * frame.signs[2];
    const Point3 up = {height[0], height[1], height[2]};
    const Ring ring = {{up.x + 0.1, up.y + 0.2, up.z + 0.3},
                       {up.x + 1.1, up.y + 0.5, up.z - 0.7},
                       {up.x - 0.4, up.y + 0.9, up.z + 1.3}};
    const HandContour contour = PolygonContour(ring, {}, frame.normal);
    const auto boundary = BoundaryAt<B>(contour);
    // Each corner as the end of two arcs.
    ASSERT_EQ(boundary.vertices.size(), 6U);
    int found = 0;
    for (const auto& vertex : boundary.vertices) {
      const std::array<B, 3> x = {vertex.point.x, vertex.point.y,
                                  vertex.point.z};
      for (const Point3& p : ring) {
        const std::array<double, 3> y = {p.x, p.y, p.z};
        std::array<double, 3> ratios{};
        for (std::size_t k = 0; k < 3; ++k) {
          ratios[k] = x[k].value / (y[static_cast<std::size_t>(frame.axes[k])] *
                                    frame.signs[k]);
          EXPECT_EQ(x[k].error, 0);
        }
        if (ratios[0] != ratios[1] || ratios[1] != ratios[2]) continue;
        ++found;
        EXPECT_EQ(std::ldexp(1.0, std::ilogb(ratios[0])), ratios[0]);
      }
    }
    EXPECT_EQ(found, 6);
    // Right-handed: an even permutation, or an odd one with a sign.
    const auto& a = frame.axes;
    const bool even = (a[1] == (a[0] + 1) % 3);
    EXPECT_EQ(even ? 1 : -1, frame.signs[2]);
  }
}

TEST(Frame, OfAnyNormalIsARotation) {
  PortableRandom random(81);
  for (int i = 0; i < 200; ++i) {
    RandomView view = Tilted(MakeRandomView(random, 0.5, 0.8, 0));
    if (i % 3 == 0) {
      // Two components only, so that an axis lies in the receiver plane.
      view = MakeRandomView(random, 0.3, 0.9, 0);
      view.normal = i % 2 == 0 ? Vector3{0, 0.3, 2} : Vector3{-0.2, 0, 1.5};
    }
    const std::vector<Point3> ring(view.ring.begin(), view.ring.begin() + 3);
    const HandContour contour =
        PolygonContour(ring, view.position, view.normal);
    const auto boundary = BoundaryAt<Multiprecision>(contour);
    ASSERT_EQ(boundary.arcs.size(), 3U);
    std::array<RealVector, 3> p;
    std::array<RealVector, 3> truth;
    const RealVector n = ToRealVector(view.normal);
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = ToReal(boundary.From(boundary.arcs[k]).point);
      // Which vertex it is, by its height.
      for (const Point3& q : ring) {
        const RealVector d = Relative(q, view.position);
        const Real length = Sqrt(Dot(d, d) / Dot(p[k], p[k]));
        if (Off(p[k][2] * length * Sqrt(Dot(n, n)), Dot(n, d)) < 1e-60) {
          truth[k] = Combine(Real(1) / length, d, Real(0), d);
        }
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      EXPECT_LT(Off(Dot(p[k], p[next]), Dot(truth[k], truth[next])), 1e-60);
    }
    EXPECT_LT(Off(Det(p[0], p[1], p[2]), Det(truth[0], truth[1], truth[2])),
              1e-60);
  }
}

TEST(Boundary, RunsCounterClockwiseAsSeenFromTheReceiver) {
  PortableRandom random(82);
  for (int i = 0; i < 100; ++i) {
    const RandomView view =
        Tilted(MakeRandomView(random, 0.5, i % 2 == 0 ? 0.8 : 0.1, i % 3 * 10));
    const HandContour contour =
        PolygonContour(view.ring, view.position, view.normal,
                       i % 5 == 0 ? Ends::kExplicit : Ends::kNatural);
    const auto boundary = BoundaryAt<Multiprecision>(contour, true);
    RealVector inside = {Real(0), Real(0), Real(0)};
    for (const auto& vertex : boundary.vertices) {
      const RealVector p = ToReal(vertex.point);
      inside = Combine(Real(1), inside, Real(1) / Sqrt(Dot(p, p)), p);
    }
    for (const auto& arc : boundary.arcs) {
      const RealVector from = ToReal(boundary.From(arc).point);
      const RealVector to = ToReal(boundary.To(arc).point);
      const RealVector normal = ToReal(arc.normal);
      const RealVector outwards = Cross(from, to);
      EXPECT_LT(Dot(outwards, inside), Real(0));
      // The normal is a positive multiple of that.
      EXPECT_LT(Off(Dot(normal, outwards) * Dot(normal, outwards),
                    Dot(normal, normal) * Dot(outwards, outwards)),
                1e-60);
      EXPECT_LT(Real(0), Dot(normal, outwards));
      // And the edge runs the same way.
      EXPECT_LT(Real(0), Dot(Cross(from, ToReal(arc.edge)), outwards));
    }
    for (const Multiprecision& determinant : boundary.fan) {
      EXPECT_GE(Leading(determinant), 0);
    }
  }
}

TEST(Boundary, DifferencesAreRoundedOnce) {
  PortableRandom random(83);
  for (int i = 0; i < 100; ++i) {
    const double size = std::pow(10, -random.Uniform(0, 12));
    const RandomView view = MakeRandomView(random, size, 0.9, i % 2 * 100);
    const HandContour contour =
        PolygonContour(view.ring, view.position, {0, 0, 1});
    const auto rounded = BoundaryAt<double>(contour);
    const auto balls = BoundaryAt<B>(contour);
    const auto truth = BoundaryAt<Multiprecision>(contour);
    for (std::size_t k = 0; k < truth.arcs.size(); ++k) {
      const BoundaryVertexId vertex = EndId<BoundaryVertexId>(k);
      const RealVector chord = ToReal(truth.arcs[k].chord);
      const RealVector point = ToReal(truth.From(truth.arcs[k]).point);
      const RealVector from_first = ToReal(truth.vertices[vertex].from_first);
      EXPECT_EQ(rounded.arcs[k].chord.x, chord[0].ToDouble());
      EXPECT_EQ(rounded.arcs[k].chord.y, chord[1].ToDouble());
      EXPECT_EQ(rounded.arcs[k].chord.z, chord[2].ToDouble());
      EXPECT_EQ(rounded.From(rounded.arcs[k]).point.x, point[0].ToDouble());
      EXPECT_EQ(rounded.vertices[vertex].from_first.y,
                from_first[1].ToDouble());
      EXPECT_LE(Abs(Real(balls.arcs[k].chord.x.value) - chord[0]),
                Real(balls.arcs[k].chord.x.error));
      EXPECT_LE(balls.arcs[k].chord.x.error,
                0x1p-53 * Abs(chord[0]).ToDouble());
      // What chords and points say is the same.
      const RealVector to = ToReal(truth.To(truth.arcs[k]).point);
      EXPECT_LE(Abs(to[0] - point[0] - chord[0]),
                Real(1e-85) * (Abs(point[0]) + Abs(to[0])));
    }
  }
}

/// x, y with a x + b y = 1.
void Bezout(long long a, long long b, long long& x, long long& y) {
  if (b == 0) {
    x = 1;
    y = 0;
    return;
  }
  long long u = 0;
  long long v = 0;
  Bezout(b, a % b, u, v);
  x = v;
  y = u - a / b * v;
}

// A height of 2^-146 beside the point's distance is below what double-double
// knows of a generic normal.
TEST(Boundary, HeightsAreNeverNegativeAndOnTheHorizonExactlyZero) {
  PortableRandom random(85);
  int clamped = 0;
  int tried = 0;
  for (int i = 0; i < 200; ++i) {
    const auto n_x = static_cast<long long>(random.Bits() >> 11);
    const auto n_y = static_cast<long long>(random.Bits() >> 11);
    long long x = 0;
    long long y = 0;
    Bezout(n_x, n_y, x, y);
    const Vector3 normal = {static_cast<double>(n_x), static_cast<double>(n_y),
                            1};
    const Point3 low = {static_cast<double>(x), static_cast<double>(y),
                        0x1p-40 - 1};
    const Real height = Real(normal.x) * Real(low.x) +
                        Real(normal.y) * Real(low.y) + Real(low.z);
    if (height.ToDouble() != 0x1p-40) continue;  // a common factor
    ++tried;
    const Ring ring = {low, {0, low.x, 1e40}, {-low.y, 0, 1e40}};
    const HandContour contour = PolygonContour(ring, {}, normal);
    const auto boundary = BoundaryAt<B>(contour);
    const auto truth = BoundaryAt<Multiprecision>(contour);
    ASSERT_EQ(boundary.vertices.size(), truth.vertices.size());
    for (const BoundaryVertexId k : truth.vertices.ids()) {
      const B& z = boundary.vertices[k].point.z;
      ASSERT_GE(z.value, 0);
      EXPECT_LE(Abs(Real(z.value) - testing::ToReal(truth.vertices[k].point.z)),
                Real(z.error));
      EXPECT_FALSE(boundary.vertices[k].on_horizon);
      if (z.value == 0) ++clamped;
    }
  }
  EXPECT_GT(tried, 50);
  EXPECT_GT(clamped, 0);
  const HandContour wall = PolygonContour(
      {{1, -2, -5}, {1, 2, -5}, {1, 2, 3}, {1, -2, 3}}, {}, {0.3, 0, 0.9});
  int on_horizon = 0;
  for (const auto& vertex : BoundaryAt<B>(wall).vertices) {
    if (!vertex.on_horizon) continue;
    ++on_horizon;
    EXPECT_EQ(vertex.point.z.value, 0);
    EXPECT_EQ(vertex.point.z.error, 0);
  }
  EXPECT_EQ(on_horizon, 2);
}

TEST(Boundary, ArcsInTheReceiverPlaneHaveItsNormalAndTheirSense) {
  for (const bool from_below : {false, true}) {
    const Vector3 normal = {0.3, -0.7, from_below ? -0.9 : 0.9};
    const Ring ring = {{1, -9, 0}, {1, 9, 0}, {1, 9, 30}, {1, -9, 30}};
    Ring seen = from_below
                    ? Ring{{1, 9, 0}, {1, -9, 0}, {1, -9, -30}, {1, 9, -30}}
                    : ring;
    const HandContour contour = PolygonContour(seen, {}, normal);
    const auto boundary = BoundaryAt<B>(contour);
    int flat = 0;
    for (const auto& arc : boundary.arcs) {
      if (!arc.on_horizon) continue;
      ++flat;
      EXPECT_TRUE(IsZero(arc.normal.x));
      EXPECT_TRUE(IsZero(arc.normal.y));
      EXPECT_TRUE(HasSign(arc.normal.z));
      // The region is above: outwards is down, as is counter-clockwise.
      EXPECT_TRUE(IsNegative(arc.normal.z));
    }
    EXPECT_EQ(flat, 1);
  }
}

TEST(Boundary, FanIsRelativelyAccurateForASliver) {
  PortableRandom random(84);
  for (int i = 0; i < 50; ++i) {
    const double width = std::pow(10, -random.Uniform(6, 15));
    const Point3 a = {random.Uniform(-1, 1), random.Uniform(-1, 1), 1};
    const Point3 b = {a.x + random.Uniform(0.1, 1), a.y + 0.3, 1};
    const Point3 c = {a.x + (b.x - a.x) / 3, a.y + 0.1 + width, 1};
    const HandContour contour = PolygonContour({a, c, b}, {}, {0, 0, 1});
    const auto fan = BoundaryAt<B>(contour, true).fan;
    const RealVector u = Relative(a, {});
    const RealVector v = Relative(b, {});
    const RealVector w = Relative(c, {});
    const Real truth =
        Abs(Det(u, v, w)) / Sqrt(Dot(u, u) * Dot(v, v) * Dot(w, w));
    int found = 0;
    for (const B& determinant : fan) {
      if (IsZero(determinant)) continue;
      ++found;
      EXPECT_LE(Abs(Abs(Real(determinant.value)) - truth),
                Real(determinant.error));
      EXPECT_LE(determinant.error, 1.2e-16 * truth.ToDouble());
    }
    EXPECT_EQ(found, 1);
  }
}

// Vertices of another source far away must not push this one out of range.
TEST(Boundary, SourcesAreScaledEachByItself) {
  HandContour contour({}, {0, 0, 1});
  contour.AddConvexPolygon(Ceiling(-1, 1, -1, 1, 1), {1, 1, 1});
  contour.AddConvexPolygon(Ceiling(3e30, 4e30, -1e30, 1e30, 1e30), {1, 1, 1});
  for (const Formula formula : {Formula::kLambertEdge, Formula::kCubature}) {
    FormulaEvaluation<float> formulas(contour.Weighted());
    formulas.Prepare(formula);
    EXPECT_NEAR(formulas.Evaluate(formula, 0).value, 0.5541F, 1e-3F);
    EXPECT_GT(formulas.Evaluate(formula, 1).value, 0);
  }
}

}  // namespace
}  // namespace truelux::testing
