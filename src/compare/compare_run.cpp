// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/compare_run.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "truelux/irradiance.h"

#include "compare/diagnosis.h"
#include "explain/receiver_detail.h"
#include "run/interrupt.h"
#include "run/parallel.h"
#include "run/progress.h"
#include "scene/scene_variants.h"

namespace truelux {
namespace {

void FindWorst(const DetailFinder& finder, int threads,
               CandidateReport& report) {
  for (const std::size_t i : WorstOf(report.errors, kMostWorstCandidates))
    report.worst.push_back({i, {}});
  Progress progress(report.worst.size());
  ForEachInParallel(report.worst.size(), threads, progress, [&](std::size_t k) {
    WorstCandidate& worst = report.worst[k];
    worst.detail = finder.Find(report.data.receivers[worst.receiver], true);
  });
}

/// Looks at receivers as mistakes were tried on; at fewer in large scenes,
/// since what coincides exactly is found slowly.
void Classify(const DetailFinder& finder, int threads,
              CandidateReport& report) {
  constexpr std::size_t kMostWork = 1'000'000;
  constexpr std::size_t kFewest = 8;
  const std::size_t triangles =
      std::max<std::size_t>(report.scene.triangles().size(), 1);
  const std::vector<std::size_t> indices = TrialReceivers(
      report.errors,
      std::clamp(kMostWork / triangles, kFewest, kMostTrialReceivers));
  report.classified.resize(indices.size());
  Progress progress(indices.size());
  ForEachInParallel(indices.size(), threads, progress, [&](std::size_t k) {
    const std::size_t i = indices[k];
    report.classified[k] = {finder.Find(report.data.receivers[i], false).traits,
                            report.errors[i].passes};
  });
}

void FindReasons(const CompareOptions& options, CandidateReport& report) {
  if (WorstOf(report.errors, 1).empty()) {
    report.diagnosis = Diagnose(report.scene, report.data, report.errors,
                                options.tolerance, options.truth, {});
    return;
  }
  const DetailFinder finder(report.scene);
  FindWorst(finder, options.threads, report);
  const SceneEvaluator evaluate = [&](const Scene& variant,
                                      std::span<const Receiver> receivers) {
    StopIfInterrupted();
    const Oracle oracle(
        variant, {.emission = options.truth.emission, .stop = InterruptFlag()});
    return IrradiancesOf(oracle, receivers, options.threads);
  };
  report.diagnosis = Diagnose(report.scene, report.data, report.errors,
                              options.tolerance, options.truth, evaluate);
  if (report.diagnosis.verdict == Verdict::kUnexplained)
    Classify(finder, options.threads, report);
}

}  // namespace

std::vector<Rgb> IrradiancesOf(const Oracle& oracle,
                               std::span<const Receiver> receivers,
                               int threads) {
  std::vector<Rgb> values(receivers.size());
  Progress progress(receivers.size());
  EvaluateInParallel(oracle, receivers, threads, progress,
                     [&](std::size_t i, const Irradiance& irradiance) {
                       values[i] = irradiance.value;
                     });
  return values;
}

CandidateReport CompareCandidate(const Scene& scene, CandidateData data,
                                 const CompareOptions& options) {
  CandidateReport report;
  report.scene = options.truth.quantity == Quantity::kFormFactor
                     ? WithUnitExitance(scene)
                     : scene;
  report.options = options.truth;
  report.tolerance = options.tolerance;
  report.data = std::move(data);
  const Oracle oracle(report.scene, {.emission = options.truth.emission,
                                     .stop = InterruptFlag()});
  for (const Rgb& value :
       IrradiancesOf(oracle, report.data.receivers, options.threads))
    report.data.truth.push_back(report.data.Compared(value));
  report.errors = ErrorsOf(report.data, options.tolerance);
  report.summary = Summarize(report.errors);
  FindReasons(options, report);
  return report;
}

}  // namespace truelux
