// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/disjoint_sets.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "base/ids.h"
#include "support/portable_random.h"

namespace truelux {
namespace {

TEST(DisjointSets, AreKnownByTheirLeastIds) {
  testing::PortableRandom random(1);
  for (int round = 0; round < 50; ++round) {
    constexpr int kCount = 40;
    DisjointSets<FacetId> sets(kCount);
    std::vector<int> least(kCount);  // the slow twin: of each id's set
    for (int i = 0; i < kCount; ++i)
      least[static_cast<std::size_t>(i)] = i;
    for (int join = 0; join < 30; ++join) {
      const int a = random.Integer(0, kCount - 1);
      const int b = random.Integer(0, kCount - 1);
      sets.Join(FacetId(a), FacetId(b));
      const int first = least[static_cast<std::size_t>(a)];
      const int second = least[static_cast<std::size_t>(b)];
      std::ranges::replace(least, std::max(first, second),
                           std::min(first, second));
      for (int i = 0; i < kCount; ++i) {
        ASSERT_EQ(sets.LeastOf(FacetId(i)).value(),
                  least[static_cast<std::size_t>(i)]);
      }
    }
  }
}

}  // namespace
}  // namespace truelux
