// SPDX-License-Identifier: GPL-3.0-or-later
// The last stage of evaluation, in Arb, beside its twin in plain MPFR
// [docs/arb.md]: same bits, width of the enclosures, time. Every receiver is
// forced to it.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fmt/format.h>
#include <string>
#include <utility>
#include <vector>

#include "truelux/io.h"

#include "radiometry/evaluate.h"
#include "radiometry/stages/mpfr_stage.h"
#include "radiometry/stages/multiprecision_answer.h"
#include "radiometry/stages/multiprecision_stage.h"
#include "radiometry/stages/rounding.h"
#include "scenes.h"
#include "support/case_files.h"
#include "text/quantile.h"
#include "visibility/edges/contour_engine.h"

namespace truelux::bench {
namespace {

constexpr std::array<mpfr_prec_t, 4> kPrecisions = {128, 256, 1024, 4096};

/// One receiver, ready for the last stage.
struct Prepared {
  testing::MpfrStage mpfr;
  MultiprecisionStage arb;
  Channels lit;
};

/// Receivers that are measured together.
struct Group {
  std::string name;
  std::vector<Prepared> receivers;
};

void Prepare(const Scene& scene, const std::vector<Receiver>& receivers,
             const EvaluationQuery& evaluation, Group& group) {
  const ContourEngine engine(scene);
  for (const Receiver& receiver : receivers) {
    const ContourQuery query{scene, receiver};
    const Contour contour = engine.Build(query);
    std::vector<Rgb> weights;
    FindWeights(query, contour, weights);
    const WeightedContour weighted{ViewOf(query), contour, weights};
    Channels lit{};
    for (const SourceId source : contour.sources.ids()) {
      for (std::size_t c = 0; c < 3; ++c)
        lit[c] = lit[c] || weighted.IsLit(source, c);
    }
    if (!Any(lit)) continue;
    const HorizonPlanes on_horizon = PlanesOnHorizon(weighted);
    ExactSum sum = ExactSumOf(weighted, evaluation, on_horizon);
    ExactSum same = ExactSumOf(weighted, evaluation, on_horizon);
    group.receivers.push_back(
        {testing::MpfrStage(std::move(sum), evaluation.emission),
         MultiprecisionStage(std::move(same), evaluation.emission), lit});
  }
}

Group Cases(const std::string& name, const EvaluationQuery& evaluation) {
  Group group{name, {}};
  for (const std::string& test : testing::CaseNames()) {
    const auto folder = testing::CaseFolder(test);
    const Result<Scene> scene = ReadScene(folder / "scene.obj");
    std::vector<Receiver> receivers;
    for (const auto& r : testing::ReadNumbers(folder / "expected.csv"))
      receivers.push_back({{r[0], r[1], r[2]}, {r[3], r[4], r[5]}, 0});
    Prepare(scene.value.value(), receivers, evaluation, group);
  }
  return group;
}

Group Slab() {
  constexpr int kBlockers = 100;
  constexpr int kReceivers = 64;
  const BenchScene slab = MakeSlab(kBlockers, kReceivers, 1);
  Group group{slab.name, {}};
  Prepare(slab.scene, slab.receivers, {}, group);
  return group;
}

/// 8 * 8 points of the floor of the Cornell box.
Group CornellFloor() {
  constexpr int kSide = 8;
  constexpr double kStep = 68;
  const Result<Scene> scene =
      ReadScene(TRUELUX_EXAMPLES "/scenes/cornell_box.obj");
  std::vector<Receiver> receivers;
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j)
      receivers.push_back(
          {{kStep * (i + 0.5), 0, kStep * (j + 0.5)}, {0, 1, 0}, 1});
  }
  Group group{"cornell_floor", {}};
  Prepare(scene.value.value(), receivers, {}, group);
  return group;
}

/// What AnswerInMultiprecision does, for any stage.
template <class Stage>
Irradiance Answer(const Stage& stage, Channels open) {
  constexpr mpfr_prec_t kTiePrecision = 4096;
  Irradiance result;
  for (mpfr_prec_t p = kPrecisions[0]; Any(open); p *= 2) {
    const std::array<Enclosure, 3> enclosures = stage.Evaluate(p);
    result.statistics.max_precision_bits = static_cast<std::uint64_t>(p);
    for (std::size_t c = 0; c < 3; ++c) {
      if (!open[c]) continue;
      auto value = RoundIfCertain(enclosures[c]);
      if (!value && p >= kTiePrecision) {
        value = RoundTieToEven(enclosures[c]);
        if (value) ++result.statistics.ties;
      }
      if (value) AnswerCertified(*value, c, open, result);
    }
  }
  return result;
}

/// The relative width of an enclosure as a power of two.
double WidthExponent(const Enclosure& enclosure) {
  const Multiprecision width =
      (enclosure.upper - enclosure.lower) / enclosure.upper;
  if (mpfr_zero_p(width.get()) != 0) return -HUGE_VAL;
  Multiprecision exponent(64);
  mpfr_log2(exponent.get(), width.get(), MPFR_RNDN);
  return exponent.ToDouble();
}

/// Prints how many channels differ, and how much narrower Arb's enclosures
/// are.
void CompareResults(const Group& group) {
  std::size_t channels = 0;
  std::size_t differ = 0;
  std::size_t precision_differs = 0;
  std::size_t disjoint = 0;
  std::uint64_t ties = 0;
  std::vector<double> gains;
  for (const Prepared& r : group.receivers) {
    const Irradiance mpfr = Answer(r.mpfr, r.lit);
    const Irradiance arb = Answer(r.arb, r.lit);
    ties += mpfr.statistics.ties;
    if (mpfr.statistics.max_precision_bits != arb.statistics.max_precision_bits)
      ++precision_differs;
    const auto wide = r.mpfr.Evaluate(kPrecisions[0]);
    const auto narrow = r.arb.Evaluate(kPrecisions[0]);
    for (std::size_t c = 0; c < 3; ++c) {
      if (!r.lit[c]) continue;
      ++channels;
      if (mpfr.value[c] != arb.value[c] ||
          mpfr.statistics.ties != arb.statistics.ties)
        ++differ;
      if (mpfr_greater_p(wide[c].lower.get(), narrow[c].upper.get()) != 0 ||
          mpfr_greater_p(narrow[c].lower.get(), wide[c].upper.get()) != 0)
        ++disjoint;
      gains.push_back(WidthExponent(wide[c]) - WidthExponent(narrow[c]));
    }
  }
  fmt::print(
      "{:16} {:5} receivers {:5} channels: {} differ, {} ties, {} receivers "
      "end at another precision, {} disjoint; log2 of MPFR's width by "
      "Arb's: median {:.1f}, least {:.1f}, most {:.1f}\n",
      group.name, group.receivers.size(), channels, differ, ties,
      precision_differs, disjoint, Median(gains),
      *std::ranges::min_element(gains), *std::ranges::max_element(gains));
}

/// Microseconds a receiver.
template <class Run>
double TimeOf(const Group& group, Run run) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  for (const Prepared& r : group.receivers)
    run(r);
  const std::chrono::duration<double, std::micro> time = Clock::now() - start;
  return time.count() / static_cast<double>(group.receivers.size());
}

/// Prints the medians of both and of their ratio over rounds in which they
/// take turns.
template <class Mpfr, class Arb>
void CompareTimes(const Group& group, const std::string& what, int rounds,
                  Mpfr mpfr, Arb arb) {
  std::vector<double> of_mpfr;
  std::vector<double> of_arb;
  std::vector<double> ratios;
  for (int i = 0; i < rounds; ++i) {
    const bool arb_first = i % 2 == 1;
    if (arb_first) of_arb.push_back(TimeOf(group, arb));
    of_mpfr.push_back(TimeOf(group, mpfr));
    if (!arb_first) of_arb.push_back(TimeOf(group, arb));
    ratios.push_back(of_arb.back() / of_mpfr.back());
  }
  fmt::print("{:16} {:10} MPFR {:9.1f} us   Arb {:9.1f} us   ratio {:.2f}\n",
             group.name, what, Median(of_mpfr), Median(of_arb), Median(ratios));
}

void Compare(const Group& group, int rounds) {
  CompareResults(group);
  for (const mpfr_prec_t p : kPrecisions) {
    CompareTimes(
        group, fmt::format("{} bits", p), rounds,
        [p](const Prepared& r) { static_cast<void>(r.mpfr.Evaluate(p)); },
        [p](const Prepared& r) { static_cast<void>(r.arb.Evaluate(p)); });
  }
  CompareTimes(
      group, "answer", rounds,
      [](const Prepared& r) { static_cast<void>(Answer(r.mpfr, r.lit)); },
      [](const Prepared& r) { static_cast<void>(Answer(r.arb, r.lit)); });
}

}  // namespace
}  // namespace truelux::bench

/// last_stage [ROUNDS]
int main(int argc, char** argv) {
  using namespace truelux;
  using namespace truelux::bench;
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 21;
  const EvaluationQuery over_ends{.formula = Formula::kUnified};
  const EvaluationQuery radiance{.emission = Emission::kRadiance};
  Compare(Cases("cases", {}), rounds);
  Compare(Cases("cases, ends", over_ends), rounds);
  Compare(Cases("cases, radiance", radiance), rounds);
  Compare(Slab(), rounds);
  Compare(CornellFloor(), rounds);
  return 0;
}
