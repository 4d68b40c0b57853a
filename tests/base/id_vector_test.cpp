// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/id_vector.h"

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace truelux {
namespace {

using Lengths = IdVector<VertexId, double>;
using LengthSpan = IdSpan<VertexId, const double>;

template <class Array, class Key>
constexpr bool kSubscripted = requires(Array a, Key key) {
  a[key];
};

// Only ids of the right kind are subscripts.
static_assert(kSubscripted<Lengths, VertexId>);
static_assert(!kSubscripted<Lengths, PlaneId>);
static_assert(!kSubscripted<Lengths, int>);
static_assert(!kSubscripted<Lengths, std::size_t>);
static_assert(kSubscripted<LengthSpan, VertexId>);
static_assert(!kSubscripted<LengthSpan, PlaneId>);
static_assert(!kSubscripted<LengthSpan, int>);

// An array of another kind does not slip in as a span.
static_assert(std::is_convertible_v<Lengths, LengthSpan>);
static_assert(!std::is_convertible_v<IdVector<PlaneId, double>, LengthSpan>);
static_assert(!std::is_convertible_v<std::vector<double>, LengthSpan>);
static_assert(!std::is_convertible_v<const Lengths, IdSpan<VertexId, double>>);
static_assert(std::is_convertible_v<IdSpan<VertexId, double>, LengthSpan>);

template <class Range>
std::vector<int> ValuesOf(const Range& ids) {
  std::vector<int> values;
  for (const auto id : ids)
    values.push_back(id.value());
  return values;
}

TEST(IdVectorTest, AppendsAndTellsTheId) {
  Lengths lengths;
  EXPECT_TRUE(lengths.empty());
  EXPECT_EQ(lengths.end_id(), VertexId(0));
  const VertexId a = lengths.push_back(2.5);
  const VertexId b = lengths.push_back(4);
  EXPECT_EQ(a, VertexId(0));
  EXPECT_EQ(b, VertexId(1));
  EXPECT_EQ(lengths.size(), 2U);
  EXPECT_EQ(lengths[a], 2.5);
  lengths[b] = 5;
  EXPECT_EQ(lengths.back(), 5);
}

TEST(IdVectorTest, WalksOverItsIds) {
  EXPECT_EQ(ValuesOf(Lengths().ids()), std::vector<int>{});
  EXPECT_EQ(ValuesOf(Lengths(3).ids()), (std::vector<int>{0, 1, 2}));
}

TEST(IdVectorTest, HoldsBitsAsWell) {
  IdVector<PlaneId, bool> flags(2, false);
  flags[PlaneId(1)] = true;
  flags.push_back(true);
  EXPECT_FALSE(std::as_const(flags)[PlaneId(0)]);
  EXPECT_TRUE(std::as_const(flags)[PlaneId(1)]);
  EXPECT_TRUE(flags[PlaneId(2)]);
}

TEST(IdVectorTest, IsEqualEntryByEntry) {
  EXPECT_EQ((Lengths{1, 2}), (Lengths{1, 2}));
  EXPECT_NE((Lengths{1, 2}), (Lengths{1, 3}));
}

TEST(IdSpanTest, RefersToTheVector) {
  Lengths lengths{1, 2, 3};
  const IdSpan<VertexId, double> span = lengths;
  span[VertexId(1)] = 7;
  EXPECT_EQ(lengths[VertexId(1)], 7);
  EXPECT_EQ(ValuesOf(span.ids()), (std::vector<int>{0, 1, 2}));
}

TEST(IdSpanTest, GivesAPart) {
  const Lengths lengths{1, 2, 3, 4};
  const auto part = lengths.Part(VertexId(1), 2);
  EXPECT_EQ(std::vector(part.begin(), part.end()), (std::vector<double>{2, 3}));
  EXPECT_TRUE(lengths.Part(VertexId(4), 0).empty());
}

TEST(IdRangeTest, HoldsConsecutiveIds) {
  const IdRange<TriangleId> range(TriangleId(3), 2);
  EXPECT_EQ(ValuesOf(range), (std::vector<int>{3, 4}));
  EXPECT_FALSE(range.contains(TriangleId(2)));
  EXPECT_TRUE(range.contains(TriangleId(3)));
  EXPECT_TRUE(range.contains(TriangleId(4)));
  EXPECT_FALSE(range.contains(TriangleId(5)));
  EXPECT_TRUE(ValuesOf(IdRange<TriangleId>(TriangleId(3), 0)).empty());
}

}  // namespace
}  // namespace truelux
