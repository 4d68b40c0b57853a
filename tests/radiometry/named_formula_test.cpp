// SPDX-License-Identifier: GPL-3.0-or-later
// --method double by any formula, through the oracle: bounds hold on scenes
// with occlusion, horizon and several emitters, and auto is never worse.

#include "radiometry/named_formula.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/irradiance.h"

#include "support/random_scene.h"
#include "support/real.h"
#include "support/scenes.h"

namespace truelux::testing {
namespace {

OracleOptions InDouble(Formula formula, Engine engine = Engine::kContour,
                       Emission emission = Emission::kExitance) {
  OracleOptions options;
  options.engine = engine;
  options.method = Method::kDouble;
  options.emission = emission;
  options.formula = formula;
  return options;
}

OracleOptions Certified(Emission emission = Emission::kExitance) {
  OracleOptions options;
  options.emission = emission;
  return options;
}

/// |value - certified| <= bound + the certified bound, for every channel.
::testing::AssertionResult Holds(const Irradiance& found,
                                 const Irradiance& certified) {
  for (std::size_t channel = 0; channel < 3; ++channel) {
    if (std::isinf(found.bound[channel])) continue;
    if (Abs(Real(found.value[channel]) - Real(certified.value[channel])) <=
        Real(found.bound[channel]) + Real(certified.bound[channel])) {
      continue;
    }
    return ::testing::AssertionFailure()
           << "channel " << channel << ": " << found.value[channel] << " +- "
           << found.bound[channel] << ", certified "
           << certified.value[channel];
  }
  return ::testing::AssertionSuccess();
}

class NamedFormula : public ::testing::TestWithParam<Formula> {
 protected:
  static bool NeedsCut() {
    return GetParam() == Formula::kImagePlane ||
           GetParam() == Formula::kDirections;
  }
};

TEST_P(NamedFormula, BoundHoldsInRandomSoups) {
  int lit = 0;
  int bounded = 0;
  for (const bool lattice : {true, false}) {
    PortableRandom random(lattice ? 101 : 102);
    for (int i = 0; i < 60; ++i) {
      const Scene scene =
          MakeScene(RandomScene(random, lattice, random.Integer(1, 12)));
      const Emission emission =
          i % 3 == 0 ? Emission::kRadiance : Emission::kExitance;
      const Engine engine =
          i % 10 == 0 ? Engine::kArrangement : Engine::kContour;
      const Oracle certified(scene, Certified(emission));
      const Oracle oracle(scene, InDouble(GetParam(), engine, emission));
      for (int k = 0; k < 6; ++k) {
        const Receiver receiver = RandomReceiver(random, lattice);
        const Irradiance truth = certified.Evaluate(receiver);
        const Irradiance found = oracle.Evaluate(receiver);
        ASSERT_TRUE(Holds(found, truth))
            << Name(GetParam()) << (lattice ? " lattice " : " general ") << i
            << " " << k;
        const bool is_lit = truth.statistics.evaluated_zero == 0;
        ASSERT_EQ(found.statistics.evaluated_zero == 0, is_lit);
        ASSERT_EQ(found.statistics.evaluated_double, is_lit ? 1U : 0U);
        if (!is_lit) continue;
        ++lit;
        const double wide = NeedsCut() ? 1e-3 : 1e-9;
        if (found.bound[0] <= wide * truth.value[0]) ++bounded;
      }
    }
  }
  EXPECT_GT(lit, 200);
  const bool is_narrow_formula = GetParam() != Formula::kSeries;
  EXPECT_GE(bounded, is_narrow_formula ? lit * 0.8 : 0);
}

TEST_P(NamedFormula, GivesNoNumberExactlyWhereItHasNoBound) {
  PortableRandom random(103);
  for (int i = 0; i < 60; ++i) {
    const Scene scene = MakeScene(RandomScene(random, true, 5));
    const Irradiance found = Oracle(scene, InDouble(GetParam()))
                                 .Evaluate(RandomReceiver(random, true));
    for (std::size_t channel = 0; channel < 3; ++channel) {
      EXPECT_EQ(std::isnan(found.value[channel]),
                std::isinf(found.bound[channel]));
      EXPECT_FALSE(found.value[channel] < 0);
    }
  }
}

TEST_P(NamedFormula, WeightsSourcesPerChannel) {
  // Small sources, so that every formula applies.
  const std::vector<TestFace> faces = {
      {Ceiling(1, 1.1, 1, 1.1, 4), {3, 0, 1e-200}},
      {Ceiling(-1, -0.9, 1, 1.2, 5), {0, 7, 1e200}},
      {Ceiling(-1, -0.9, -1, -0.9, 6), {5, 0, 0}}};
  const Receiver receiver{{0, 0, 0}, {0.1, 0.2, 1}, 0};
  const Scene scene = MakeScene(faces);
  const Irradiance truth = Oracle(scene).Evaluate(receiver);
  const Irradiance found =
      Oracle(scene, InDouble(GetParam())).Evaluate(receiver);
  EXPECT_TRUE(Holds(found, truth));
  for (std::size_t channel = 0; channel < 3; ++channel) {
    EXPECT_LE(found.bound[channel], 1e-7 * truth.value[channel]);
  }
}

TEST_P(NamedFormula, FormFactorIsOfOneFace) {
  const std::vector<TestFace> faces = {{Ceiling(1, 1.1, 1, 1.1, 4), kLamp},
                                       {Ceiling(-1, 0, 1, 1.2, 9), kBlack}};
  const Receiver receiver{{0, 0, 0}, {0, 0, 1}, 0};
  const Scene scene = MakeScene(faces);
  const Irradiance truth = Oracle(scene).FormFactor(receiver, 1);
  const Irradiance found =
      Oracle(scene, InDouble(GetParam(), Engine::kContour, Emission::kRadiance))
          .FormFactor(receiver, 1);
  EXPECT_TRUE(Holds(found, truth));
  EXPECT_LE(found.bound[0], 1e-7 * truth.value[0]);
}

std::string TestNameOf(const ::testing::TestParamInfo<Formula>& test) {
  std::string name(Name(test.param));
  std::erase(name, '-');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, NamedFormula, ::testing::ValuesIn(AllFormulas()),
                         TestNameOf);

// Auto ------------------------------------------------------------------------

TEST(Auto, IsNeverWorseThanTheFormulasItChoosesFrom) {
  int better = 0;
  for (const bool lattice : {true, false}) {
    PortableRandom random(lattice ? 104 : 105);
    for (int i = 0; i < 80; ++i) {
      const Scene scene =
          MakeScene(RandomScene(random, lattice, random.Integer(1, 10)));
      const Oracle best(scene, InDouble(Formula::kAuto));
      const Oracle edge(scene, InDouble(Formula::kLambertEdge));
      for (int k = 0; k < 5; ++k) {
        const Receiver receiver = RandomReceiver(random, lattice);
        const Irradiance a = best.Evaluate(receiver);
        const Irradiance b = edge.Evaluate(receiver);
        for (std::size_t c = 0; c < 3; ++c) {
          ASSERT_LE(a.bound[c], b.bound[c] + 1e-9 * a.value[c]);
          if (a.bound[c] < 0.5 * b.bound[c]) ++better;
        }
      }
    }
  }
  EXPECT_GT(better, 30);
}

/// A triangle whose angular size, aspect and elevation are given.
Ring FaintTriangle(double size, double aspect, double elevation) {
  return {{1, -size, elevation},
          {1, size, elevation},
          {1, size / 3, elevation + size * aspect}};
}

TEST(Auto, KnowsFaintSourcesToTwelveDigitsWhereLambertDoesNot) {
  struct Faint {
    std::string name;
    Ring ring;
  };

  const std::vector<Faint> sources = {
      {"tiny", FaintTriangle(1e-7, 1, 0.5)},
      {"tiny_and_low", FaintTriangle(1e-9, 1, 1e-6)},
      {"sliver", FaintTriangle(1e-3, 1e-9, 0.5)},
      {"low", FaintTriangle(1e-6, 1, 1e-8)},
      {"tiny_quad",
       {{1, -1e-7, 0.5},
        {1, 1e-7, 0.5},
        {1, 1e-7, 0.5 + 1e-7},
        {1, -1e-7, 0.5 + 1e-7}}}};
  for (const Faint& source : sources) {
    const Receiver receiver{{0, 0, 0}, {0, 0, 1}, 0};
    const Scene scene = MakeScene({{Reversed(source.ring), {1, 0.5, 2}}});
    const Irradiance truth = Oracle(scene).Evaluate(receiver);
    ASSERT_GT(truth.value[0], 0) << source.name;
    const Irradiance found =
        Oracle(scene, InDouble(Formula::kAuto)).Evaluate(receiver);
    const Irradiance lambert =
        Oracle(scene, InDouble(Formula::kLambertEdge)).Evaluate(receiver);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_LE(found.bound[c], 1e-12 * truth.value[c]) << source.name;
      EXPECT_GT(lambert.bound[c], 1e-12 * truth.value[c]) << source.name;
    }
    EXPECT_TRUE(Holds(found, truth)) << source.name;
    EXPECT_TRUE(Holds(lambert, truth)) << source.name;
  }
}

// A mesh of emitters is joined for lambert-edge; a tiny one must come back to
// its parts.
TEST(Auto, TakesAJoinedContourApartWhereItsBoundIsWide) {
  std::vector<TestFace> faces;
  const double s = 1e-7;
  for (int i = 0; i < 3; ++i) {
    faces.push_back({Ceiling(1 + i * s, 1 + (i + 1) * s, 1, 1 + s, 2), kLamp});
  }
  const Scene scene = MakeScene(faces);
  const Receiver receiver{{0, 0, 0}, {0, 0, 1}, 0};
  const Irradiance truth = Oracle(scene).Evaluate(receiver);
  const Irradiance found =
      Oracle(scene, InDouble(Formula::kAuto)).Evaluate(receiver);
  EXPECT_TRUE(Holds(found, truth));
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_LE(found.bound[c], 1e-12 * truth.value[c]);
  }
  EXPECT_EQ(found.statistics.evaluated_double, 1U);
}

TEST(HalfSide, CutsImagePlaneAndDirectionsOnly) {
  const Scene scene = MakeScene({{Ceiling(-9, 9, -9, 9, 1), {1, 1, 1}}});
  const Receiver receiver{{0, 0, 0}, {0, 0, 1}, 0};
  const double truth = Oracle(scene).Evaluate(receiver).value[0];
  for (const Formula formula : AllFormulas()) {
    OracleOptions options = InDouble(formula);
    options.half_side = 2;
    const Irradiance found = Oracle(scene, options).Evaluate(receiver);
    if (std::isnan(found.value[0])) continue;
    const bool is_cut =
        formula == Formula::kImagePlane || formula == Formula::kDirections;
    if (is_cut) {
      EXPECT_LT(found.value[0], truth - 0.1);
      EXPECT_GT(found.bound[0], 0.2);
      EXPECT_LT(found.bound[0], 0.21);
    } else {
      EXPECT_NEAR(found.value[0], truth, 1e-12);
    }
  }
}

}  // namespace
}  // namespace truelux::testing
