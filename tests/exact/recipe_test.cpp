// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/recipe.h"

#include <cmath>
#include <type_traits>

#include <gtest/gtest.h>

#include "exact/recipe_evaluator.h"

namespace truelux {
namespace {

template <class A, class B>
constexpr bool kMakesEdge = requires(A a, B b) {
  PlaneRecipe::OfEdge(a, b);
};

template <class A, class B>
constexpr bool kMakesCrossing = requires(A a, B b) {
  DirectionRecipe::Crossing(a, b);
};

// A recipe takes the ids that it is made of, and no others.
static_assert(kMakesEdge<VertexId, VertexId>);
static_assert(!kMakesEdge<TriangleId, TriangleId>);
static_assert(!kMakesEdge<int, int>);
static_assert(kMakesCrossing<PlaneId, PlaneId>);
static_assert(!kMakesCrossing<PlaneId, DirectionId>);

// Contours hold many of them.
static_assert(sizeof(PlaneRecipe) == 12);
static_assert(sizeof(DirectionRecipe) == 16);
static_assert(std::is_trivially_copyable_v<PlaneRecipe>);
static_assert(std::is_trivially_copyable_v<DirectionRecipe>);

TEST(PlaneRecipes, KeepWhatTheyAreMadeOf) {
  const auto edge = PlaneRecipe::OfEdge(VertexId(3), VertexId(5));
  EXPECT_EQ(edge.kind(), PlaneRecipe::Kind::kEdge);
  EXPECT_EQ(edge.from(), VertexId(3));
  EXPECT_EQ(edge.to(), VertexId(5));
  const auto cut = PlaneRecipe::OfCut(TriangleId(1), TriangleId(2));
  EXPECT_EQ(cut.kind(), PlaneRecipe::Kind::kCut);
  EXPECT_EQ(cut.first_triangle(), TriangleId(1));
  EXPECT_EQ(cut.second_triangle(), TriangleId(2));
  EXPECT_EQ(PlaneRecipe::OfHorizon().kind(), PlaneRecipe::Kind::kHorizon);
  const auto given = PlaneRecipe::Explicit(ExplicitId(7));
  EXPECT_EQ(given.kind(), PlaneRecipe::Kind::kExplicit);
  EXPECT_EQ(given.explicit_vector(), ExplicitId(7));
}

TEST(PlaneRecipes, ArePositiveUntilNegated) {
  const auto edge = PlaneRecipe::OfEdge(VertexId(3), VertexId(5));
  EXPECT_FALSE(edge.negated());
  EXPECT_EQ(edge.NegatedIf(false), edge);
  EXPECT_TRUE(edge.NegatedIf(true).negated());
  EXPECT_NE(edge.NegatedIf(true), edge);
  EXPECT_EQ(edge.NegatedIf(true).NegatedIf(true), edge);
}

TEST(PlaneRecipes, AreReversedWithTheirEnds) {
  const auto edge = PlaneRecipe::OfEdge(VertexId(3), VertexId(5));
  const auto back = PlaneRecipe::OfEdge(VertexId(5), VertexId(3));
  EXPECT_TRUE(edge.IsReverseOf(back));
  EXPECT_FALSE(edge.IsReverseOf(edge));
  EXPECT_FALSE(edge.IsReverseOf(back.NegatedIf(true)));
  EXPECT_FALSE(
      edge.IsReverseOf(PlaneRecipe::OfCut(TriangleId(5), TriangleId(3))));
}

TEST(DirectionRecipes, KeepWhatTheyAreMadeOf) {
  EXPECT_EQ(DirectionRecipe::ToVertex(VertexId(4)).vertex(), VertexId(4));
  const auto at_horizon =
      DirectionRecipe::EdgeAtHorizon(VertexId(1), VertexId(2));
  EXPECT_EQ(at_horizon.kind(), DirectionRecipe::Kind::kEdgeAtHorizon);
  EXPECT_EQ(at_horizon.from(), VertexId(1));
  EXPECT_EQ(at_horizon.to(), VertexId(2));
  const auto at_plane =
      DirectionRecipe::EdgeAtPlane(VertexId(1), VertexId(2), TriangleId(8));
  EXPECT_EQ(at_plane.kind(), DirectionRecipe::Kind::kEdgeAtPlane);
  EXPECT_EQ(at_plane.from(), VertexId(1));
  EXPECT_EQ(at_plane.to(), VertexId(2));
  EXPECT_EQ(at_plane.triangle(), TriangleId(8));
  const auto crossing = DirectionRecipe::Crossing(PlaneId(6), PlaneId(9));
  EXPECT_EQ(crossing.kind(), DirectionRecipe::Kind::kCrossing);
  EXPECT_EQ(crossing.first_plane(), PlaneId(6));
  EXPECT_EQ(crossing.second_plane(), PlaneId(9));
  EXPECT_TRUE(crossing.NegatedIf(true).negated());
  EXPECT_EQ(DirectionRecipe::Explicit(ExplicitId(0)).explicit_vector(),
            ExplicitId(0));
}

#ifndef NDEBUG
TEST(PlaneRecipesDeathTest, HaveNoPartsOfAnotherKind) {
  const auto edge = PlaneRecipe::OfEdge(VertexId(3), VertexId(5));
  EXPECT_DEATH(static_cast<void>(edge.first_triangle()), "kCut");
}
#endif

// CGAL's own conversion loses them under upward rounding.
TEST(FromExactToInterval, HoldsTheNumberInEveryRoundingMode) {
  const Exact least(0x1p-1074);
  const Exact tiny = least * least * Exact(3);
  const Exact huge = Exact(0x1p1023) * Exact(0x1p1023);
  for (const Exact& x :
       {tiny, -tiny, least * Exact(5), Exact(0.1), huge, -huge, Exact(0)}) {
    const Interval plain = FromExact<Interval>::Of(x);
    const RoundUpward rounding;
    const Interval upward = FromExact<Interval>::Of(x);
    for (const Interval& interval : {plain, upward}) {
      if (std::isfinite(interval.inf())) {
        EXPECT_LE(Exact(interval.inf()), x);
      } else {
        EXPECT_LT(interval.inf(), 0);
      }
      if (std::isfinite(interval.sup())) {
        EXPECT_GE(Exact(interval.sup()), x);
      } else {
        EXPECT_GT(interval.sup(), 0);
      }
    }
    EXPECT_EQ(upward.inf(), plain.inf());
    EXPECT_EQ(upward.sup(), plain.sup());
  }
}

}  // namespace
}  // namespace truelux
