// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/failure_classes.h"

#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "explain/receiver_detail.h"
#include "support/scenes.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

TEST(FailureClasses, FindOutThatOnlyConjunctionsAreWrong) {
  // A right candidate except where the board's corner hides the lamp's: at
  // receivers on a lattice, so that it happens exactly.
  const Scene scene = MakeScene(
      {{Ceiling(-2, 2, -2, 2, 4), kLamp}, {Ceiling(-1, 1, -1, 1, 2)}});
  const DetailFinder finder(scene);
  std::vector<ClassifiedReceiver> receivers;
  std::size_t wrong = 0;
  for (int i = -6; i <= 6; ++i) {
    for (int j = -6; j <= 6; ++j) {
      const Receiver receiver{{i * 0.5, j * 0.5, 0}, {0, 0, 1}, 0};
      const ReceiverTraits traits = finder.Find(receiver, false).traits;
      const bool passes = traits.conjunctions == 0;
      wrong += passes ? 0U : 1U;
      receivers.push_back({traits, passes});
    }
  }
  ASSERT_GT(wrong, 0U);
  ASSERT_LT(wrong, receivers.size());
  const std::string where = WhereItFails(receivers);
  EXPECT_NE(where.find("all of them with a conjunction"), std::string::npos)
      << where;
  std::size_t all = 0;
  for (const FailureClass& c : FailureClasses(receivers)) {
    if (c.name != "with a conjunction" && c.name != "near the horizon")
      all += c.receivers;
    if (c.name == "with a conjunction") {
      EXPECT_EQ(c.failing, wrong);
      EXPECT_EQ(c.receivers, wrong);
    }
  }
  EXPECT_EQ(all, receivers.size());
}

TEST(FailureClasses, SayThatItFailsEverywhereOrAsItComes) {
  ClassifiedReceiver lit;
  lit.traits.lighting = Lighting::kFullyLit;
  lit.traits.highest = 1;
  ClassifiedReceiver dark;
  EXPECT_EQ(WhereItFails(std::vector{lit, dark}),
            "all 2 receivers looked at fail");
  dark.passes = true;
  EXPECT_EQ(WhereItFails(std::vector{lit, dark, dark}),
            "1 of 3 receivers looked at fail, all of them fully lit (1 of the "
            "1 such)");
  ClassifiedReceiver umbra;
  umbra.traits.lighting = Lighting::kUmbra;
  EXPECT_EQ(WhereItFails(std::vector{lit, umbra, dark}),
            "2 of 3 receivers looked at fail");
}

}  // namespace
}  // namespace truelux
