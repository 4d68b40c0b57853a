#include "methods.h"

#include <memory>
#include <utility>

#include "baselines/scanline.h"
#include "polygon_set.h"
#include "radiometry/evaluate.h"
#include "radiometry/evaluation_workspace.h"
#include "visibility/contour_engine.h"

namespace truelux::bench {
namespace {

/// So many receivers in a row do not share their samples.
constexpr std::size_t kSampleSets = 4;

Contender OracleMethod(const BenchScene& scene, const std::string& name,
                       const OracleOptions& options) {
  const auto oracle = std::make_shared<const Oracle>(scene.scene, options);
  const auto run = [oracle](std::span<const Receiver> receivers) {
    return oracle->Evaluate(receivers);
  };
  return {name, name, run};
}

/// A method that takes the receivers one by one.
template <class OneReceiver>
Contender EachReceiver(std::string name, std::string family, OneReceiver one) {
  const auto run = [one](std::span<const Receiver> receivers) {
    std::vector<Irradiance> results;
    results.reserve(receivers.size());
    for (const Receiver& receiver : receivers)
      results.push_back({one(receiver, results.size()), {}, {}});
    return results;
  };
  return {std::move(name), std::move(family), run};
}

std::string SampledFamily(SamplePattern pattern) {
  return pattern == SamplePattern::kSobol ? "Embree Sobol" : "Embree streams";
}

}  // namespace

Contender CertifiedMethod(const BenchScene& scene) {
  return OracleMethod(scene, kCertifiedName, {});
}

Contender DoubleMethod(const BenchScene& scene) {
  return OracleMethod(scene, kDoubleName, {.method = Method::kDouble});
}

Contender UnfilteredMethod(const BenchScene& scene) {
  /// What one thread needs.
  struct State {
    explicit State(const Scene& s) : engine(s), builder(engine) {}

    ContourEngine engine;
    UnfilteredContourBuilder builder;
    Contour contour;
    EvaluationWorkspace evaluation;
  };

  const auto state = std::make_shared<State>(scene.scene);
  const auto run = [state](std::span<const Receiver> receivers) {
    std::vector<Irradiance> results;
    results.reserve(receivers.size());
    ContourQuery query{state->engine.scene(), {}, 0};
    state->builder.StartBlock({});
    for (const Receiver& receiver : receivers) {
      query.receiver = receiver;
      state->builder.Build(query, state->contour);
      results.push_back(EvaluateContour(query, state->contour,
                                        {.method = Method::kDouble},
                                        state->evaluation));
    }
    return results;
  };
  return {kUnfilteredName, kUnfilteredName, run};
}

Contender ArrangementMethod(const BenchScene& scene,
                            std::size_t max_receivers) {
  Contender method = OracleMethod(scene, "arrangement engine",
                                  {.engine = Engine::kArrangement});
  method.max_receivers = max_receivers;
  return method;
}

Contender SampledMethod(const BenchScene& scene,
                        std::shared_ptr<const ShadowRays> rays,
                        SamplePattern pattern, int count, std::uint64_t seed) {
  const auto sets = std::make_shared<std::vector<EmitterSamples>>();
  for (std::size_t i = 0; i < kSampleSets; ++i)
    sets->push_back(SampleEmitters(scene.scene, pattern, count, seed + i));
  return EachReceiver(
      SampledName(pattern, count), SampledFamily(pattern),
      [rays = std::move(rays), sets](const Receiver& receiver, std::size_t i) {
        return rays->Estimate(receiver, (*sets)[i % kSampleSets]);
      });
}

Contender ScanlineMethod(const BenchScene& scene, int rows) {
  const auto quadrature =
      std::make_shared<const ScanlineQuadrature>(scene.scene);
  return EachReceiver(
      "scanline " + std::to_string(rows), "scanline",
      [quadrature, rows](const Receiver& receiver, std::size_t /*index*/) {
        return quadrature->Evaluate(receiver, rows);
      });
}

Contender PolygonSetMethod(const BenchScene& scene) {
  return EachReceiver(
      kPolygonSetName, kPolygonSetName,
      [scene = scene.scene](const Receiver& receiver, std::size_t /*index*/) {
        return PolygonSetIrradiance(scene, receiver);
      });
}

std::string SampledName(SamplePattern pattern, int count) {
  return SampledFamily(pattern) + " " + std::to_string(count);
}

}  // namespace truelux::bench
