// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/compare_run.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "truelux/irradiance.h"

#include "base/stop.h"
#include "compare/diagnosis.h"
#include "explain/receiver_detail.h"
#include "run/parallel.h"
#include "run/progress.h"
#include "scene/scene_variants.h"

namespace truelux {
namespace {

void FindWorst(const DetailFinder& finder, const CompareSettings& settings,
               CandidateReport& report) {
  for (const std::size_t i : WorstOf(report.errors, kMostWorstCandidates))
    report.worst.push_back({i, {}});
  Progress progress(report.worst.size(), kReceivers, settings.watch);
  ForEachInParallel(
      report.worst.size(), settings.threads, progress, [&](std::size_t k) {
        WorstCandidate& worst = report.worst[k];
        worst.detail = finder.Find(report.data.receivers[worst.receiver], true);
      });
}

/// Looks at receivers as mistakes were tried on; at fewer in large scenes,
/// since what coincides exactly is found slowly.
void Classify(const DetailFinder& finder, const CompareSettings& settings,
              CandidateReport& report) {
  constexpr std::size_t kMostWork = 1'000'000;
  constexpr std::size_t kFewest = 8;
  const std::size_t triangles =
      std::max<std::size_t>(report.scene.triangles().size(), 1);
  const std::vector<std::size_t> indices = TrialReceivers(
      report.errors,
      std::clamp(kMostWork / triangles, kFewest, kMostTrialReceivers));
  report.classified.resize(indices.size());
  Progress progress(indices.size(), kReceivers, settings.watch);
  ForEachInParallel(indices.size(), settings.threads, progress,
                    [&](std::size_t k) {
                      const std::size_t i = indices[k];
                      report.classified[k] = {
                          finder.Find(report.data.receivers[i], false).traits,
                          report.errors[i].passes};
                    });
}

void FindReasons(const CompareSettings& settings, CandidateReport& report) {
  if (WorstOf(report.errors, 1).empty()) {
    report.diagnosis = Diagnose(report.scene, report.data, report.errors,
                                settings.tolerance, settings.truth, {});
    return;
  }
  const DetailFinder finder(report.scene);
  FindWorst(finder, settings, report);
  const SceneEvaluator evaluate = [&](const Scene& variant,
                                      std::span<const Receiver> receivers) {
    StopIfAsked(settings.watch.stop);
    const Oracle oracle(variant, {.emission = settings.truth.emission,
                                  .stop = settings.watch.stop});
    return IrradiancesOf(oracle, receivers, settings);
  };
  report.diagnosis = Diagnose(report.scene, report.data, report.errors,
                              settings.tolerance, settings.truth, evaluate);
  if (report.diagnosis.verdict == Verdict::kUnexplained)
    Classify(finder, settings, report);
}

}  // namespace

std::vector<Rgb> IrradiancesOf(const Oracle& oracle,
                               std::span<const Receiver> receivers,
                               const CompareSettings& settings) {
  std::vector<Rgb> values(receivers.size());
  Progress progress(receivers.size(), kReceivers, settings.watch);
  EvaluateInParallel(oracle, receivers, settings.threads, progress,
                     [&](std::size_t i, const Irradiance& irradiance) {
                       values[i] = irradiance.value;
                     });
  return values;
}

CandidateReport CompareCandidate(const Scene& scene, CandidateData data,
                                 const CompareSettings& settings) {
  CandidateReport report;
  report.scene = settings.truth.quantity == Quantity::kFormFactor
                     ? WithUnitExitance(scene)
                     : scene;
  report.options = settings.truth;
  report.tolerance = settings.tolerance;
  report.data = std::move(data);
  const Oracle oracle(report.scene, {.emission = settings.truth.emission,
                                     .stop = settings.watch.stop});
  for (const Rgb& value :
       IrradiancesOf(oracle, report.data.receivers, settings))
    report.data.truth.push_back(report.data.Compared(value));
  report.errors = ErrorsOf(report.data, settings.tolerance);
  report.summary = Summarize(report.errors);
  FindReasons(settings, report);
  return report;
}

}  // namespace truelux
