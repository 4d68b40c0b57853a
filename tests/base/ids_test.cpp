// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ids.h"

#include <type_traits>
#include <unordered_set>

#include <gtest/gtest.h>

namespace truelux {
namespace {

template <class A, class B>
constexpr bool kComparable = requires(A a, B b) {
  a == b;
};

template <class A, class B>
constexpr bool kOrdered = requires(A a, B b) {
  a < b;
};

// Nothing turns into an id, or an id into anything, without being asked to.
static_assert(!std::is_convertible_v<int, VertexId>);
static_assert(!std::is_convertible_v<VertexId, int>);
static_assert(!std::is_constructible_v<VertexId, PlaneId>);
static_assert(!std::is_assignable_v<VertexId&, PlaneId>);
static_assert(!std::is_assignable_v<VertexId&, int>);
static_assert(!kComparable<VertexId, PlaneId>);
static_assert(!kComparable<VertexId, int>);
static_assert(!kOrdered<VertexId, PlaneId>);
static_assert(kComparable<VertexId, VertexId>);
static_assert(kOrdered<VertexId, VertexId>);

// Face numbers and face indices meet in NumberOf and IndexOf only.
static_assert(!std::is_constructible_v<FaceNumber, FaceId>);
static_assert(!std::is_constructible_v<FaceId, FaceNumber>);
static_assert(!std::is_convertible_v<int, FaceNumber>);
static_assert(!std::is_convertible_v<FaceNumber, int>);
static_assert(!kComparable<FaceNumber, FaceId>);
static_assert(!kComparable<FaceNumber, int>);

// An id costs what an int costs.
static_assert(sizeof(VertexId) == sizeof(int));
static_assert(sizeof(FaceNumber) == sizeof(int));
static_assert(std::is_trivially_copyable_v<VertexId>);
static_assert(std::is_trivially_copyable_v<FaceNumber>);

TEST(Ids, StartAsNone) {
  EXPECT_FALSE(VertexId().valid());
  EXPECT_FALSE(VertexId(-2).valid());
  EXPECT_TRUE(VertexId(0).valid());
  EXPECT_FALSE(FaceNumber().valid());
  EXPECT_EQ(FaceNumber().value(), 0);
  EXPECT_TRUE(FaceNumber(1).valid());
}

TEST(Ids, KeepTheirIndex) {
  EXPECT_EQ(VertexId(7).value(), 7);
  EXPECT_EQ(VertexId(7).index(), 7U);
}

TEST(Ids, AreInTheOrderOfTheirIndices) {
  EXPECT_LT(VertexId(2), VertexId(3));
  EXPECT_LT(VertexId(), VertexId(0));
  EXPECT_EQ(VertexId(3), VertexId(3));
  VertexId next(3);
  EXPECT_EQ(++next, VertexId(4));
}

TEST(Ids, AreKeysOfUnorderedContainers) {
  const std::unordered_set<PlaneId> planes = {PlaneId(1), PlaneId(2),
                                              PlaneId(1)};
  EXPECT_EQ(planes.size(), 2U);
  EXPECT_TRUE(planes.contains(PlaneId(2)));
  EXPECT_FALSE(planes.contains(PlaneId(3)));
}

TEST(FaceNumbers, CountFromOne) {
  EXPECT_EQ(NumberOf(FaceId(0)), FaceNumber(1));
  EXPECT_EQ(IndexOf(FaceNumber(1)), FaceId(0));
  for (const int index : {0, 1, 41}) {
    EXPECT_EQ(IndexOf(NumberOf(FaceId(index))), FaceId(index));
  }
}

TEST(FaceNumbers, NoneIsNoneOnBothSides) {
  EXPECT_FALSE(NumberOf(FaceId()).valid());
  EXPECT_FALSE(IndexOf(FaceNumber()).valid());
}

#ifndef NDEBUG
TEST(IdsDeathTest, NoneIsNoSubscript) {
  EXPECT_DEATH(static_cast<void>(VertexId().index()), "valid");
}
#endif

}  // namespace
}  // namespace truelux
