// SPDX-License-Identifier: GPL-3.0-or-later
// Several oracles over one prepared scene.

#include "truelux/prepared_scene.h"

#include <cmath>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/irradiance.h"

#include "support/portable_random.h"
#include "support/random_scene.h"
#include "support/scenes.h"

namespace truelux::testing {
namespace {

/// Options that leave different things in a workspace.
std::vector<OracleOptions> SomeOptions() {
  return {{},
          {.method = Method::kDouble},
          {.method = Method::kDouble, .formula = Formula::kUnified},
          {.engine = Engine::kArrangement},
          {.emission = Emission::kRadiance}};
}

Scene SomeScene() {
  PortableRandom random(7);
  return MakeScene(RandomScene(random, false, 12, 3));
}

std::vector<Receiver> SomeReceivers() {
  PortableRandom random(8);
  std::vector<Receiver> receivers;
  for (int i = 0; i < 10; ++i)
    receivers.push_back(RandomReceiver(random, false, 3));
  return receivers;
}

// Blocks of receivers, single receivers and form factors in turn, so that each
// oracle finds in a workspace what the others left there.
TEST(PreparedScene, OraclesOverItAnswerAsIfEachHadItsOwn) {
  const Scene scene = SomeScene();
  const PreparedScene prepared(scene);
  const std::vector<Receiver> receivers = SomeReceivers();
  int lit = 0;
  for (int round = 0; round < 2; ++round) {
    for (const OracleOptions& options : SomeOptions()) {
      const Oracle shared(prepared, options);
      const Oracle own(scene, options);
      const std::vector<Irradiance> results = shared.Evaluate(receivers);
      for (std::size_t i = 0; i < receivers.size(); ++i) {
        const Irradiance expected = own.Evaluate(receivers[i]);
        ASSERT_EQ(results[i].value, expected.value) << i;
        ASSERT_EQ(results[i].bound, expected.bound) << i;
        const FormFactorTable factors = shared.FormFactors(receivers[i]);
        ASSERT_EQ(shared.Evaluate(receivers[i]).value, expected.value) << i;
        ASSERT_EQ(factors.faces.size(),
                  own.FormFactors(receivers[i]).faces.size());
        if (expected.value[0] > 0) ++lit;
      }
    }
  }
  EXPECT_GT(lit, 10);
}

TEST(PreparedScene, IsWhatAnOracleHasPrepared) {
  const Scene scene = SomeScene();
  const Oracle first(scene);
  const Oracle second(first.prepared(), {.method = Method::kDouble});
  EXPECT_EQ(&first.scene(), &second.scene());
  EXPECT_EQ(second.options().method, Method::kDouble);
  // The arrays are those of the scene that was given: nothing was copied.
  EXPECT_EQ(second.scene().vertices().data(), scene.vertices().data());
}

TEST(PreparedScene, OutlivesTheOracleThatMadeIt) {
  const Receiver receiver{{0, 0, 0}, {0, 0, 1}, 0};
  const auto prepared = [] {
    const Oracle oracle(MakeScene({{Ceiling(-1, 1, -1, 1, 1), kLamp}}));
    return oracle.prepared();
  }();
  EXPECT_GT(Oracle(prepared).Evaluate(receiver).value[0], 0.5);
}

TEST(PreparedScene, ServesOraclesInSeveralThreads) {
  const PreparedScene prepared(SomeScene());
  const std::vector<Receiver> receivers = SomeReceivers();
  std::vector<std::vector<Irradiance>> results(4);
  {
    std::vector<std::jthread> threads;
    for (std::size_t t = 0; t < results.size(); ++t) {
      threads.emplace_back([&, t] {
        const Method method = t % 2 == 0 ? Method::kCertified : Method::kDouble;
        results[t] = Oracle(prepared, {.method = method}).Evaluate(receivers);
      });
    }
  }
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    EXPECT_EQ(results[0][i].value, results[2][i].value);
    EXPECT_EQ(results[1][i].value, results[3][i].value);
  }
}

TEST(Oracle, AHalfSideThatIsNotPositiveIsRefused) {
  for (const double half_side : {0.0, -1.0, std::nan("")}) {
    EXPECT_THROW((void)Oracle(Scene(), {.half_side = half_side}),
                 std::invalid_argument);
  }
}

}  // namespace
}  // namespace truelux::testing
