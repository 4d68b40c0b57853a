// SPDX-License-Identifier: GPL-3.0-or-later
// Deliberately wrong gradients, made without what compare predicts them by, and
// what the diagnosis calls them.

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "truelux/derivatives.h"
#include "truelux/irradiance.h"

#include "base/vector_math.h"
#include "compare/gradients/compare_gradients.h"
#include "compare/gradients/finite_differences.h"
#include "compare/wrong_programs.h"
#include "support/scenes.h"

namespace truelux {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace)

constexpr std::array kAxes = {&Vector3::x, &Vector3::y, &Vector3::z};
constexpr std::array kPositions = {&Point3::x, &Point3::y, &Point3::z};

/// A lamp with a tilted blocker below it and an upright one beside that.
const Ring kLampRing = Ceiling(-0.5, 0.5, -0.5, 0.5, 1);
const Ring kTriangle = {{-0.3, -0.2, 0.5}, {0.1, -0.35, 0.6}, {0, 0.25, 0.45}};
const Ring kPlate = {
    {0.2, -0.3, 0.35}, {0.2, 0.35, 0.3}, {0.2, 0.4, 0.65}, {0.2, -0.25, 0.7}};

Scene LampAndBlockers() {
  return MakeScene({{kLampRing, {2, 1, 0.5}}, {kTriangle}, {kPlate}});
}

/// Receivers that see the whole lamp above their horizons.
std::vector<Receiver> Receivers() {
  std::vector<Receiver> receivers;
  std::mt19937_64 random(7);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  for (int i = 0; i < 40; ++i) {
    receivers.push_back({{uniform(-0.6, 0.6), uniform(-0.6, 0.6), 0},
                         {uniform(-0.1, 0.1), uniform(-0.1, 0.1), 1},
                         0});
  }
  return receivers;
}

using WrongGradient = std::function<Vector3(const Receiver&)>;

/// The report on a grey candidate that says `gradient`.
GradientReport Report(const Scene& scene,
                      const std::vector<Receiver>& receivers,
                      const WrongGradient& gradient, double tolerance = 1e-6,
                      Emission emission = Emission::kExitance) {
  GradientData data;
  data.value_names = {"grad_r_x", "grad_r_y", "grad_r_z"};
  data.channels = {0};
  data.receivers = receivers;
  data.lines.resize(receivers.size());
  for (const Receiver& receiver : receivers)
    data.values.push_back({gradient(receiver)});
  CompareSettings options;
  options.tolerance = tolerance;
  options.truth.emission = emission;
  return CompareGradientData(scene, std::move(data), options);
}

Vector3 TruthAt(const Oracle& oracle, const Receiver& receiver) {
  return oracle.Derivatives(receiver).channels[0].gradient;
}

/// By central differences of any function of the place.
Vector3 Differences(const std::function<double(const Receiver&)>& value,
                    const Receiver& receiver, double step) {
  Vector3 gradient;
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    Receiver above = receiver;
    Receiver below = receiver;
    above.position.*kPositions[axis] += step;
    below.position.*kPositions[axis] -= step;
    gradient.*kAxes[axis] = (value(above) - value(below)) / (2 * step);
  }
  return gradient;
}

void ExpectMistake(const GradientReport& report, const std::string& mistake,
                   const std::string& words) {
  EXPECT_FALSE(report.passes());
  EXPECT_EQ(report.diagnosis.verdict, Verdict::kMistake)
      << report.diagnosis.text;
  EXPECT_EQ(report.diagnosis.mistake, mistake) << report.diagnosis.text;
  EXPECT_NE(report.diagnosis.text.find(words), std::string::npos)
      << report.diagnosis.text;
  EXPECT_NE(GradientText(report).find(mistake), std::string::npos);
}

class GradientDiagnosis : public ::testing::Test {
 protected:
  Scene scene_ = LampAndBlockers();
  Oracle oracle_{scene_};
  std::vector<Receiver> receivers_ = Receivers();
};

TEST_F(GradientDiagnosis, OfARightCandidateNothingFails) {
  const GradientReport report =
      Report(scene_, receivers_,
             [&](const Receiver& r) { return TruthAt(oracle_, r); });
  EXPECT_TRUE(report.passes());
  EXPECT_EQ(report.summary.sloping_exact, receivers_.size());
  EXPECT_EQ(report.diagnosis.verdict, Verdict::kNothingFails);
}

TEST_F(GradientDiagnosis, NamesFactors) {
  const std::map<double, std::array<std::string, 2>> factors = {
      {-1, {"wrong sign", "opposite sign"}},
      {1000, {"unit of length", "per metre, with a scene in millimetres"}},
      {1e-3, {"unit of length", "per millimetre, with a scene in metres"}},
      {-0.01, {"unit of length", "and have the opposite sign"}},
      {std::acos(-1.0), {"exitance against radiance", "--emission radiance"}},
      {0.7, {"constant factor", "0.7 times"}}};
  for (const auto& [factor, names] : factors) {
    ExpectMistake(Report(scene_, receivers_,
                         [&, f = factor](const Receiver& r) {
                           return Times(f, TruthAt(oracle_, r));
                         }),
                  names[0], names[1]);
  }
}

TEST_F(GradientDiagnosis, NamesWhatIsSaidAtOtherReceivers) {
  ExpectMistake(Report(scene_, receivers_,
                       [&](const Receiver& r) {
                         const Vector3 g = TruthAt(oracle_, r);
                         const Vector3 n = UnitOf(r.normal);
                         return Difference(g, Times(Dot(g, n), n));
                       }),
                "tangential part", "along the normal");
}

TEST_F(GradientDiagnosis, NamesTheUnshadowedGradient) {
  // Lambert's formula of the lamp alone, by a program of its own.
  const Scene lamp = MakeScene({{kLampRing, {2, 1, 0.5}}});
  const Program lambert = LambertWithoutClipping(lamp);
  ExpectMistake(Report(scene_, receivers_,
                       [&](const Receiver& r) {
                         return Differences(
                             [&](const Receiver& q) { return lambert(q)[0]; },
                             r, 1e-4);
                       }),
                "no shadows", "unshadowed");
}

TEST_F(GradientDiagnosis, NamesAConstantShareOfTheLight) {
  // Also where an emitting face without area comes first.
  const TestFace no_area = {{{3, 0, 1}, {4, 0, 1}, {5, 0, 1}}, {1, 1, 1}};
  const Scene more =
      MakeScene({no_area, {kLampRing, {2, 1, 0.5}}, {kTriangle}, {kPlate}});
  const Program lambert =
      LambertWithoutClipping(MakeScene({{kLampRing, {2, 1, 0.5}}}));
  const auto unshadowed = [&](const Receiver& r) { return lambert(r)[0]; };
  for (const Scene& scene : {scene_, more}) {
    ExpectMistake(Report(scene, receivers_,
                         [&](const Receiver& r) {
                           const double share =
                               oracle_.Evaluate(r).value[0] / unshadowed(r);
                           return Times(share,
                                        Differences(unshadowed, r, 1e-4));
                         }),
                  "constant visibility", "visible share");
  }
}

TEST_F(GradientDiagnosis, NamesVisibilityThatStaysInEveryDirection) {
  // If the source moves alone, blockers stay where they are seen.
  ExpectMistake(
      Report(scene_, receivers_,
             [&](const Receiver& r) {
               Vector3 sum;
               for (const VertexDerivative& v :
                    oracle_.VertexDerivatives(r).vertices) {
                 if (v.number > 4) continue;  // not the lamp's
                 const auto& s = v.slopes[0];
                 sum = Difference(sum, {s[0].left, s[1].left, s[2].left});
               }
               return sum;
             }),
      "constant visibility", "edges of blockers do not move");
}

TEST_F(GradientDiagnosis, NamesTheSourcesDepthForABlockersEdge) {
  // The integral over visible points of the gradient of the integrand.
  const auto sees = [](const Point3& from, const Point3& to) {
    const auto hits = [&](const Ring& ring) {
      const auto plane = [&](const Point3& p) {
        const Vector3 n =
            Cross(FromTo(ring[0], ring[1]), FromTo(ring[0], ring[2]));
        return Dot(n, FromTo(ring[0], p));
      };
      const double a = plane(from);
      const double b = plane(to);
      if ((a > 0) == (b > 0)) return false;
      const Vector3 d = Times(a / (a - b), FromTo(from, to));
      const Point3 hit{from.x + d.x, from.y + d.y, from.z + d.z};
      double turn = 0;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vector3 p = FromTo(hit, ring[i]);
        const Vector3 q = FromTo(hit, ring[(i + 1) % ring.size()]);
        turn += std::copysign(
            AngleBetween(p, q),
            Dot(Cross(p, q),
                Cross(FromTo(ring[0], ring[1]), FromTo(ring[0], ring[2]))));
      }
      return std::abs(turn) > 3;
    };
    return !hits(kTriangle) && !hits(kPlate);
  };
  constexpr int kCells = 120;
  const auto gradient = [&](const Receiver& r) {
    const Vector3 n = UnitOf(r.normal);
    Vector3 sum;
    for (int i = 0; i < kCells; ++i) {
      for (int j = 0; j < kCells; ++j) {
        const Point3 y{(i + 0.5) / kCells - 0.5, (j + 0.5) / kCells - 0.5, 1};
        if (!sees(r.position, y)) continue;
        // (n.d) d_z / (pi |d|^4) with d = y - r; its gradient by r.
        const Vector3 d = FromTo(r.position, y);
        const double square = Dot(d, d);
        const double weight =
            2 / (std::acos(-1.0) * square * square * kCells * kCells);
        sum = Sum(sum, Times(-weight * d.z, n));
        sum.z -= weight * Dot(n, d);
        sum = Sum(sum, Times(4 * weight * Dot(n, d) * d.z / square, d));
      }
    }
    return sum;
  };
  ExpectMistake(Report(scene_, receivers_, gradient, 1e-3),
                "source's depth for a blocker's edge", "painted on the source");
}

TEST_F(GradientDiagnosis, NamesDifferencesAcrossAKinkAndFindsTheirStep) {
  std::vector<Receiver> receivers = receivers_;
  for (int i = 0; i < 8; ++i) {
    receivers.push_back(
        {{0.2 + 0.001 * (i - 3.5), 0.05 * i - 0.1, 0}, {0, 0, 1}, 0});
  }
  const auto with = [&](double step) {
    return Report(scene_, receivers, [&](const Receiver& r) {
      return Differences(
          [&](const Receiver& q) { return oracle_.Evaluate(q).value[0]; }, r,
          step);
    });
  };
  ExpectMistake(with(0.02), std::string(kDifferencesAcrossKinks),
                "central differences of E with the step 0.02;");
  ExpectMistake(with(0.003), std::string(kDifferencesAcrossKinks),
                "with the step 0.003;");
}

TEST_F(GradientDiagnosis, TellsKinksFromFacesThatAStepCrosses) {
  // A step below the floor sees nothing of the lamp.
  const Scene scene =
      MakeScene({{kLampRing, {2, 1, 0.5}}, {Floor(-2, 2, -2, 2, 0)}});
  const Oracle oracle(scene);
  std::vector<Receiver> on_floor = receivers_;
  for (Receiver& receiver : on_floor)
    receiver.position.z = 0.001;
  ExpectMistake(Report(scene, on_floor,
                       [&](const Receiver& r) {
                         return Differences(
                             [&](const Receiver& q) {
                               return oracle.Evaluate(q).value[0];
                             },
                             r, 0.01);
                       }),
                std::string(kDifferencesAcrossKinks),
                "crosses a face, where E jumps, at 40");
}

TEST_F(GradientDiagnosis, FindsStepsOfTheSizeOfTheScene) {
  const Scene lamp = MakeScene({{kLampRing, {2, 1, 0.5}}});
  const Oracle oracle(lamp);
  ExpectMistake(Report(lamp, receivers_,
                       [&](const Receiver& r) {
                         return Differences(
                             [&](const Receiver& q) {
                               return oracle.Evaluate(q).value[0];
                             },
                             r, 0.3);
                       }),
                std::string(kLongDifferences),
                "central differences of E with the step 0.3;");
}

TEST_F(GradientDiagnosis, OfNothingNothingIsSaidButThat) {
  ExpectMistake(Report(scene_, receivers_,
                       [](const Receiver& /*r*/) { return Vector3{}; }),
                "no gradient", "are 0");
  // Where nothing can be compared, nothing passes.
  const GradientReport on_plate =
      Report(scene_, {{{0.2, 0.1, 0.5}, {0, 0, 1}, 0}},
             [](const Receiver& /*r*/) { return Vector3{}; });
  EXPECT_EQ(on_plate.summary.discontinuous, 1U);
  EXPECT_FALSE(on_plate.passes());
  EXPECT_NE(GradientText(on_plate).find("nothing was compared"),
            std::string::npos);
}

TEST_F(GradientDiagnosis, NamesALongStepWhereNoKinkIsNear) {
  const Scene lamp = MakeScene({{kLampRing, {2, 1, 0.5}}});
  const Oracle oracle(lamp);
  const auto value = [&](const Receiver& q) {
    return oracle.Evaluate(q).value[0];
  };
  ExpectMistake(Report(lamp, receivers_,
                       [&](const Receiver& r) {
                         Receiver above = r;
                         Vector3 g;
                         for (std::size_t axis = 0; axis < 3; ++axis) {
                           above.position = r.position;
                           above.position.*kPositions[axis] += 0.01;
                           g.*kAxes[axis] = (value(above) - value(r)) / 0.01;
                         }
                         return g;
                       }),
                std::string(kLongDifferences),
                "forward differences of E with the step 0.01;");
}

TEST_F(GradientDiagnosis, TellsReceiversOffTheirFaces) {
  // A floor a little above the receivers hides everything from them.
  const Scene scene = MakeScene({{kLampRing, {2, 1, 0.5}},
                                 {kTriangle},
                                 {kPlate},
                                 {Floor(-1, 1, -1, 1, 1e-17)}});
  std::vector<Receiver> on_floor = receivers_;
  for (Receiver& receiver : on_floor)
    receiver.normal = {0, 0, 1};
  const GradientReport report = Report(
      scene, on_floor, [&](const Receiver& r) { return TruthAt(oracle_, r); });
  EXPECT_EQ(report.diagnosis.verdict, Verdict::kOffFaces)
      << report.diagnosis.text;
}

TEST_F(GradientDiagnosis, AtAKinkEitherSideAndTheMeanPass) {
  // In the plane of the plate.
  const std::vector<Receiver> at_kink = {{{0.2, 0, 0}, {0, 0, 1}, 0}};
  const Derivatives d = oracle_.Derivatives(at_kink[0]);
  ASSERT_EQ(d.smoothness, Smoothness::kKink);
  ASSERT_EQ(d.kinks.size(), 1U);
  const Vector3 jump = Times(d.kinks[0].size[0], d.kinks[0].normal);
  ASSERT_GT(LengthOf(jump), 0.01);
  for (const double side : {-1.0, 0.0, 0.3, 1.0, 1.1}) {
    const GradientReport report =
        Report(scene_, at_kink, [&](const Receiver& /*r*/) {
          return Sum(d.channels[0].gradient, Times(side, jump));
        });
    EXPECT_EQ(report.passes(), side <= 1) << side;
    EXPECT_EQ(report.summary.kinks, 1U);
  }
}

TEST_F(GradientDiagnosis, DoesNotInventAReason) {
  int count = 0;
  const GradientReport report =
      Report(scene_, receivers_, [&](const Receiver& r) {
        ++count;
        return count % 3 == 0 ? Vector3{7.0 + count, -5, 2.5 * (count % 7)}
                              : TruthAt(oracle_, r);
      });
  EXPECT_EQ(report.summary.failing(), receivers_.size() / 3);
  EXPECT_EQ(report.diagnosis.verdict, Verdict::kUnexplained)
      << report.diagnosis.text;
  EXPECT_EQ(report.worst.size(), kMostWorstCandidates);
}

}  // namespace
}  // namespace truelux
