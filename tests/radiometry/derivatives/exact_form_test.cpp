// SPDX-License-Identifier: GPL-3.0-or-later
// Zero or not, of numbers that are known to be one or the other.

#include "radiometry/derivatives/exact_form.h"

#include <vector>

#include <gtest/gtest.h>

namespace truelux {
namespace {

Vec3<Exact> V(double x, double y, double z) {
  return {Exact(x), Exact(y), Exact(z)};
}

/// An arc from d1 to d2 of the line through d1 and d2.
RationalArc ArcBetween(const Vec3<Exact>& d1, const Vec3<Exact>& d2) {
  MovingArc arc;
  arc.kind = ArcLine::kEdge;
  arc.normal = Cross(d1, d2);
  arc.line = d2 - d1;
  arc.first = d1;
  arc.last = d2;
  return RationalArc(arc);
}

// Twice 45 degrees is 90 degrees: the ends of both need not be alike.
TEST(ExactForm, AnglesOfOneClassAdd) {
  const std::vector<RationalArc> arcs = {ArcBetween(V(1, 0, 0), V(1, 1, 0)),
                                         ArcBetween(V(1, 1, 0), V(0, 3, 0)),
                                         ArcBetween(V(0, 0, 1), V(0, 7, 0))};
  // |N| is 1, 3 and 7.
  const auto sum = [&](long first, long second, long third) {
    ExactForm form(arcs);
    form.AddAngle(0, mpq_class(first));
    form.AddAngle(1, mpq_class(3 * second));
    form.AddAngle(2, mpq_class(7 * third));
    return form.IsZero();
  };
  EXPECT_TRUE(sum(1, 1, -1));
  EXPECT_TRUE(sum(1, -1, 0));
  EXPECT_TRUE(sum(-2, -2, 2));
  EXPECT_FALSE(sum(1, 1, 1));
  EXPECT_FALSE(sum(1, 1, -2));
  EXPECT_TRUE(sum(0, 0, 0));
}

// sqrt(2) and 1 are of different classes: equal angles do not cancel.
TEST(ExactForm, ClassesAreIndependent) {
  const std::vector<RationalArc> arcs = {ArcBetween(V(1, 0, 0), V(0, 1, 0)),
                                         ArcBetween(V(1, 1, 0), V(0, 0, 1))};
  ExactForm form(arcs);
  form.AddAngle(0, 1);
  form.AddAngle(1, -1);
  EXPECT_FALSE(form.IsZero());
}

// The angle of (2, 1) doubled is that of (3, 4), by products of unit numbers;
// coefficients 1 and 1 against 1 are one group.
TEST(ExactForm, MultiplesAreFoundByProducts) {
  const std::vector<RationalArc> arcs = {
      ArcBetween(V(1, 0, 0), V(2, 1, 0)),   // |N| = 1
      ArcBetween(V(0, 1, 0), V(-1, 2, 0)),  // the same angle, |N| = 1
      ArcBetween(V(1, 0, 0), V(3, 4, 0))};  // |N| = 4
  ExactForm form(arcs);
  form.AddAngle(0, 1);
  form.AddAngle(1, 1);
  form.AddAngle(2, -4);
  EXPECT_TRUE(form.IsZero());
}

// x . W y of an arc and its mirror image.
TEST(ExactForm, MomentsOfMirroredArcsCancel) {
  const std::vector<RationalArc> arcs = {ArcBetween(V(1, 2, 3), V(2, 5, 1)),
                                         ArcBetween(V(1, -2, 3), V(2, -5, 1))};
  const RationalVector x = RationalVectorOf(V(0, 0, 1));
  const RationalVector y = RationalVectorOf(V(1, 1, 0));
  const RationalVector mirrored = RationalVectorOf(V(1, -1, 0));
  ExactForm same(arcs);
  same.AddMoment(0, 1, x, y);
  same.AddMoment(1, -1, x, mirrored);
  EXPECT_TRUE(same.IsZero());
  ExactForm other(arcs);
  other.AddMoment(0, 1, x, y);
  other.AddMoment(1, -1, x, y);
  EXPECT_FALSE(other.IsZero());
}

}  // namespace
}  // namespace truelux
