// SPDX-License-Identifier: GPL-3.0-or-later
#include "baselines/contender.h"

#include "baselines/scanline.h"
#include "radiometry/evaluate.h"
#include "radiometry/evaluation_workspace.h"
#include "visibility/edges/contour_engine.h"

namespace truelux {
namespace {

/// So many receivers in a row do not share their samples.
constexpr std::size_t kSampleSets = 4;

}  // namespace

Contender OracleContender(const Scene& scene, const std::string& name,
                          OracleOptions options) {
  const auto stop = std::make_shared<StopFlag>(false);
  options.stop = stop.get();
  const auto oracle = std::make_shared<const Oracle>(scene, options);
  const auto run = [oracle, stop](std::span<const Receiver> receivers) {
    std::vector<std::optional<Irradiance>> results(receivers.size());
    oracle->Evaluate(
        receivers, [&](std::size_t i, const Irradiance& e) { results[i] = e; });
    return results;
  };
  Contender contender = {name, name, run};
  contender.stop = stop;
  return contender;
}

Contender UnfilteredContender(const Scene& scene, const std::string& name) {
  /// What one thread needs.
  struct State {
    explicit State(const Scene& s) : engine(s), builder(engine) {}

    ContourEngine engine;
    UnfilteredContourBuilder builder;
    Contour contour;
    EvaluationWorkspace evaluation;
  };

  const auto state = std::make_shared<State>(scene);
  const auto run = [state](std::span<const Receiver> receivers) {
    std::vector<std::optional<Irradiance>> results;
    results.reserve(receivers.size());
    ContourQuery query{state->engine.scene(), {}};
    state->builder.StartBlock({});
    for (const Receiver& receiver : receivers) {
      query.receiver = receiver;
      state->builder.Build(query, state->contour);
      results.emplace_back(EvaluateContour(query, state->contour,
                                           {.method = Method::kDouble},
                                           state->evaluation));
    }
    return results;
  };
  return {name, name, run};
}

Contender SampledContender(const Scene& scene,
                           std::shared_ptr<const ShadowRays> rays,
                           SamplePattern pattern, int count,
                           std::uint64_t seed) {
  const auto sets = std::make_shared<std::vector<EmitterSamples>>();
  for (std::size_t i = 0; i < kSampleSets; ++i)
    sets->push_back(SampleEmitters(scene, pattern, count, seed + i));
  const std::string group = SampledGroup(pattern);
  return EachReceiver(
      group + " " + std::to_string(count), group,
      [rays = std::move(rays), sets](const Receiver& receiver, std::size_t i) {
        return rays->Estimate(receiver, (*sets)[i % kSampleSets]);
      });
}

Contender ScanlineContender(const Scene& scene, int rows) {
  const auto quadrature = std::make_shared<const ScanlineQuadrature>(scene);
  return EachReceiver(
      "scanline " + std::to_string(rows), "scanline",
      [quadrature, rows](const Receiver& receiver, std::size_t /*index*/) {
        return quadrature->Evaluate(receiver, rows);
      });
}

std::string SampledGroup(SamplePattern pattern) {
  switch (pattern) {
    case SamplePattern::kRandom:
      return "Embree random";
    case SamplePattern::kRowOrdered:
      return "Embree streams";
    case SamplePattern::kSobol:
      break;
  }
  return "Embree Sobol";
}

}  // namespace truelux
