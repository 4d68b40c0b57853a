// SPDX-License-Identifier: GPL-3.0-or-later
// Deliberately wrong programs, each with a classic mistake, and programs
// without one: what the diagnosis calls them.

#include "compare/diagnosis.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/irradiance.h"

#include "compare/mistakes.h"
#include "compare/stages.h"
#include "compare/wrong_programs.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

constexpr double kPi = std::numbers::pi;

CandidateData Candidate(const Stage& stage, const OracleOptions& options) {
  CandidateData data;
  data.value_names = {"E_r", "E_g", "E_b"};
  data.channels = {0, 1, 2};
  data.receivers = stage.receivers;
  data.lines.resize(stage.receivers.size());
  for (const Irradiance& e :
       Oracle(stage.scene, options).Evaluate(stage.receivers))
    data.truth.push_back(e.value);
  data.values = data.truth;
  return data;
}

Diagnosis Of(const Stage& stage, const CandidateData& data,
             const OracleOptions& options = {}, double tolerance = 1e-6) {
  const SceneEvaluator evaluate = [&](const Scene& scene,
                                      std::span<const Receiver> receivers) {
    std::vector<Rgb> values;
    for (const Irradiance& e : Oracle(scene, options).Evaluate(receivers))
      values.push_back(e.value);
    return values;
  };
  return Diagnose(stage.scene, data, ErrorsOf(data, tolerance), tolerance,
                  {Quantity::kIrradiance, options.emission}, evaluate);
}

Diagnosis OfProgram(const Stage& stage, const Program& program,
                    const OracleOptions& options = {},
                    double tolerance = 1e-6) {
  CandidateData data = Candidate(stage, options);
  for (std::size_t i = 0; i < data.values.size(); ++i)
    data.values[i] = program(data.receivers[i]);
  return Of(stage, data, options, tolerance);
}

constexpr int kSamples = 128;

/// A stage, a program, and what the diagnosis has to say.
struct WrongProgram {
  std::string name;
  Stage (*stage)();
  Wrong wrong;
  std::string mistake;  ///< "": none
  std::string words;    ///< in the text
};

void PrintTo(const WrongProgram& program, std::ostream* out) {
  *out << program.name;
}

class ProgramWithMistake : public ::testing::TestWithParam<WrongProgram> {};

TEST_P(ProgramWithMistake, IsNamed) {
  const WrongProgram& p = GetParam();
  const Stage stage = p.stage();
  const Diagnosis d =
      OfProgram(stage, MonteCarlo(stage.scene, kSamples, p.wrong));
  EXPECT_EQ(d.verdict, p.mistake.empty() ? Verdict::kNoise : Verdict::kMistake)
      << d.text;
  EXPECT_EQ(d.mistake, p.mistake) << d.text;
  EXPECT_NE(d.text.find(p.words), std::string::npos) << d.text;
  EXPECT_EQ(d.equally, std::vector<std::string>{});
  EXPECT_EQ(d.tried.size(), Mistakes().size());
}

INSTANTIATE_TEST_SUITE_P(
    MonteCarlo, ProgramWithMistake,
    ::testing::Values(WrongProgram{"honest, Cornell box",
                                   CornellBox,
                                   {},
                                   "",
                                   "look like unbiased noise"},
                      WrongProgram{"honest, horizon",
                                   AcrossTheHorizon,
                                   {},
                                   "",
                                   "look like unbiased noise"},
                      WrongProgram{"honest, backs and blockers",
                                   WithBacksAndBlockers,
                                   {},
                                   "",
                                   "look like unbiased noise"},
                      WrongProgram{"twice, Cornell box",
                                   CornellBox,
                                   {.factor = 2},
                                   "constant factor",
                                   "2 (2) times"},
                      WrongProgram{"half, horizon",
                                   AcrossTheHorizon,
                                   {.factor = 0.5},
                                   "constant factor",
                                   "1/2 (0.5) times"},
                      WrongProgram{"1/pi, Cornell box",
                                   CornellBox,
                                   {.factor = 1 / kPi},
                                   "constant factor",
                                   "1/pi (0.31831) times"},
                      WrongProgram{"radiance, Cornell box",
                                   CornellBox,
                                   {.factor = kPi},
                                   "exitance against radiance",
                                   "--emission radiance would agree"},
                      WrongProgram{"flipped normal",
                                   WithBacksAndBlockers,
                                   {.flips_normal = true},
                                   "flipped normal",
                                   "E at -n"},
                      WrongProgram{"two-sided",
                                   WithBacksAndBlockers,
                                   {.emits_twice = true},
                                   "two-sided emission",
                                   "both sides"},
                      WrongProgram{"no short block",
                                   CornellBox,
                                   {.left_out = "short_block"},
                                   "left-out object",
                                   "leaves out 'short_block', a blocker"},
                      WrongProgram{"no board",
                                   WithBacksAndBlockers,
                                   {.left_out = "board"},
                                   "left-out object",
                                   "leaves out 'board', a blocker"},
                      WrongProgram{"no lid",
                                   WithBacksAndBlockers,
                                   {.left_out = "lid"},
                                   "left-out object",
                                   "leaves out 'lid' as a source"},
                      WrongProgram{"no shadows, Cornell box",
                                   CornellBox,
                                   {.has_no_shadows = true},
                                   "no shadows",
                                   "no shadows at all"}));

TEST(Diagnosis, NamesAMissingHorizonClip) {
  const Stage stage = AcrossTheHorizon();
  const Program lambert = LambertWithoutClipping(stage.scene);
  const Diagnosis d = OfProgram(stage, lambert);
  EXPECT_EQ(d.mistake, "missing horizon clip") << d.text;
  EXPECT_EQ(d.equally, std::vector<std::string>{});
  ASSERT_TRUE(d.fit.has_value());
  EXPECT_LT(d.fit->median_after, 1e-13);
  EXPECT_EQ(d.fit->passing_after, stage.receivers.size());
  // Clamped at 0, which happens to some of them.
  int clamped = 0;
  const Diagnosis e = OfProgram(stage, [&](const Receiver& receiver) {
    Rgb value = lambert(receiver);
    for (double& channel : value) {
      clamped += channel < 0 ? 1 : 0;
      channel = std::max(channel, 0.0);
    }
    return value;
  });
  EXPECT_EQ(e.mistake, "missing horizon clip") << e.text;
  EXPECT_GT(clamped, 0);
  EXPECT_NE(e.text.find("and 0 where that is negative"), std::string::npos)
      << e.text;
  EXPECT_EQ(e.fit->passing_after, stage.receivers.size());
}

TEST(Diagnosis, NamesClampingSourceBySource) {
  const Stage stage = AcrossTheHorizon();
  std::vector<Program> each;
  for (int face = 0; face < 3; ++face) {
    SceneBuilder builder;
    const Face& f = stage.scene.faces()[static_cast<std::size_t>(face)];
    Ring ring;
    for (const int v : stage.scene.corners().subspan(
             static_cast<std::size_t>(f.first_corner), 4))
      ring.push_back(stage.scene.vertices()[static_cast<std::size_t>(v)]);
    builder.AddFace(ring, f.emission);
    each.push_back(LambertWithoutClipping(*builder.Build().value));
  }
  const Diagnosis d = OfProgram(stage, [&](const Receiver& receiver) {
    Rgb sum{};
    for (const Program& program : each) {
      const Rgb one = program(receiver);
      for (std::size_t c = 0; c < sum.size(); ++c)
        sum[c] += std::max(one[c], 0.0);
    }
    return sum;
  });
  EXPECT_EQ(d.mistake, "missing horizon clip") << d.text;
  EXPECT_NE(d.text.find("0 for every source"), std::string::npos) << d.text;
}

TEST(Diagnosis, TellsWhichEmissionWouldAgree) {
  const Stage stage = CornellBox();
  const OracleOptions radiance{.emission = Emission::kRadiance};
  const Program honest = MonteCarlo(stage.scene, kSamples);
  const Diagnosis d = OfProgram(stage, honest, radiance);
  EXPECT_EQ(d.mistake, "exitance against radiance") << d.text;
  EXPECT_NE(d.text.find("--emission exitance would agree"), std::string::npos);
  // pi too many although Ke is radiance: no --emission helps.
  const Diagnosis e =
      OfProgram(stage, MonteCarlo(stage.scene, kSamples, {.factor = kPi * kPi}),
                radiance);
  EXPECT_EQ(e.mistake, "constant factor") << e.text;
}

TEST(Diagnosis, FindsAnyOtherFactorWithItsValue) {
  const Stage stage = CornellBox();
  CandidateData data = Candidate(stage, {});
  for (Rgb& value : data.values) {
    for (double& channel : value)
      channel *= 1.25;
  }
  const Diagnosis d = Of(stage, data);
  EXPECT_EQ(d.mistake, "constant factor");
  EXPECT_DOUBLE_EQ(d.factor.value(), 1.25);
  EXPECT_EQ(d.fit->passing_after, 144U);
  EXPECT_EQ(d.fit->passing_before, 54U);
}

TEST(Diagnosis, NamesEmissionFromTheWrongSide) {
  const Stage stage = WithBacksAndBlockers();
  SceneBuilder builder;
  for (const PlainPolygon& p : PolygonsOf(stage.scene)) {
    Ring ring;
    for (const Vec& v : p.ring)
      ring.push_back({v.x, v.y, v.z});
    builder.SetGroup(p.group);
    builder.AddFace(Reversed(ring), p.emission);
  }
  const Scene reversed = *builder.Build().value;
  const Diagnosis d = OfProgram(stage, MonteCarlo(reversed, kSamples));
  EXPECT_EQ(d.mistake, "emission from the wrong side") << d.text;
}

TEST(Diagnosis, SaysNothingOfAnExactCandidate) {
  const Stage stage = CornellBox();
  const Diagnosis d = Of(stage, Candidate(stage, {}));
  EXPECT_EQ(d.verdict, Verdict::kNothingFails);
  EXPECT_EQ(d.mistake, "");
  EXPECT_TRUE(d.tried.empty());
}

TEST(Diagnosis, NamesNothingForRandomGarbage) {
  for (Stage (*make)() : {CornellBox, AcrossTheHorizon, WithBacksAndBlockers}) {
    const Stage stage = make();
    std::mt19937 random(7);
    for (const double size : {0.01, 1.0, 100.0}) {
      std::uniform_real_distribution<double> uniform(0, size);
      const Diagnosis d = OfProgram(stage, [&](const Receiver&) {
        return Rgb{uniform(random), uniform(random), uniform(random)};
      });
      EXPECT_EQ(d.verdict, Verdict::kUnexplained) << d.text;
    }
  }
}

TEST(Diagnosis, NamesNothingIfAFewReceiversAreWrong) {
  for (Stage (*make)() : {CornellBox, WithBacksAndBlockers}) {
    const Stage stage = make();
    CandidateData data = Candidate(stage, {});
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(0.8, 1.2);
    for (std::size_t i = 0; i < data.values.size(); i += 9) {
      for (double& channel : data.values[i])
        channel *= uniform(random);
    }
    const Diagnosis d = Of(stage, data);
    EXPECT_EQ(d.verdict, Verdict::kUnexplained) << d.text;
  }
}

TEST(Diagnosis, NumbersThatAreNoneDoNotConfuseIt) {
  const Stage stage = CornellBox();
  CandidateData data = Candidate(stage, {});
  for (Rgb& value : data.values) {
    for (double& channel : value)
      channel *= 2;
  }
  data.values[0] = {std::numeric_limits<double>::quiet_NaN(), 0, 0};
  data.values[1] = {std::numeric_limits<double>::infinity(), 0, 0};
  EXPECT_EQ(Of(stage, data).mistake, "constant factor");
  for (Rgb& value : data.values)
    value.fill(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(Of(stage, data).verdict, Verdict::kUnexplained);
}

TEST(Diagnosis, TellsOfOthersThatPredictTheSame) {
  // One blocker only: without it there are no shadows.
  SceneBuilder builder;
  builder.SetGroup("lid");
  builder.AddFace(Ceiling(-1, 1, -1, 1, 2.5), {2, 2, 2});
  builder.SetGroup("board");
  builder.AddFace(Ceiling(-0.7, 0.2, -0.5, 0.9, 1.25));
  const Stage stage{*builder.Build().value, TiltedReceivers()};
  const Diagnosis d = OfProgram(
      stage, MonteCarlo(stage.scene, kSamples, {.left_out = "board"}));
  EXPECT_EQ(d.mistake, "left-out object") << d.text;
  ASSERT_EQ(d.equally.size(), 1U);
  EXPECT_NE(d.equally[0].find("no shadows"), std::string::npos);
}

TEST(Diagnosis, SaysHowManyOfManyGroupsItTried) {
  SceneBuilder builder;
  builder.SetGroup("lid");
  builder.AddFace(Ceiling(-1, 1, -1, 1, 2.5), {2, 2, 2});
  for (int i = 0; i < 80; ++i) {
    builder.SetGroup("tile" + std::to_string(i));
    const int row = i / 10;
    const int column = i % 10;
    builder.AddFace(Ceiling(-1 + 0.1 * column, -0.95 + 0.1 * column,
                            -1 + 0.1 * row, -0.95 + 0.1 * row, 1));
  }
  const Stage stage{*builder.Build().value, TiltedReceivers()};
  const OracleOptions options;
  CandidateData data = Candidate(stage, options);
  SceneBuilder other;
  for (const PlainPolygon& p : PolygonsOf(stage.scene)) {
    if (p.group == "tile33") continue;
    Ring ring;
    for (const Vec& v : p.ring)
      ring.push_back({v.x, v.y, v.z});
    other.AddFace(ring, p.emission);
  }
  const Oracle oracle(*other.Build().value);
  for (std::size_t i = 0; i < data.values.size(); ++i)
    data.values[i] = oracle.Evaluate(data.receivers[i]).value;
  const Diagnosis d = Of(stage, data);
  EXPECT_NE(d.text.find("leaves out 'tile33', a blocker"), std::string::npos)
      << d.text;
  ASSERT_EQ(d.notes.size(), 1U);
  EXPECT_EQ(d.notes[0],
            "left-out object: 64 of 81 objects and groups were tried");
}

}  // namespace
}  // namespace truelux
