// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "truelux/irradiance.h"

#include "base/receiver_block.h"
#include "polygon_set.h"
#include "radiometry/evaluate.h"
#include "radiometry/evaluation_workspace.h"

namespace truelux::bench {

Contender CertifiedMethod(const BenchScene& scene) {
  return OracleContender(scene.scene, kCertifiedName, {});
}

Contender DoubleMethod(const BenchScene& scene) {
  return OracleContender(scene.scene, kDoubleName, {.method = Method::kDouble});
}

Contender UnfilteredMethod(const BenchScene& scene) {
  return UnfilteredContender(scene.scene, kUnfilteredName);
}

Contender ContourPathMethod(const BenchScene& scene, ContourPath path,
                            const std::string& name) {
  /// What one thread needs.
  struct State {
    State(const Scene& s, ContourPath p) : engine(s, p), builder(engine) {}

    ContourEngine engine;
    ContourBuilder builder;
    Contour contour;
    EvaluationWorkspace evaluation;
  };

  const auto state = std::make_shared<State>(scene.scene, path);
  const auto run = [state](std::span<const Receiver> receivers) {
    std::vector<std::optional<Irradiance>> results;
    results.reserve(receivers.size());
    ContourQuery query{state->engine.scene(), {}, {}, true};
    for (std::size_t i = 0; i < receivers.size(); ++i) {
      if (i % kReceiverBlock == 0) {
        state->builder.StartBlock(receivers.subspan(
            i, std::min(kReceiverBlock, receivers.size() - i)));
      }
      query.receiver = receivers[i];
      state->builder.Build(query, state->contour);
      results.emplace_back(
          EvaluateContour(query, state->contour, {}, state->evaluation));
    }
    return results;
  };
  return {name, name, run};
}

Contender ArrangementMethod(const BenchScene& scene,
                            std::size_t max_receivers) {
  Contender method = OracleContender(scene.scene, "arrangement engine",
                                     {.engine = Engine::kArrangement});
  method.max_receivers = max_receivers;
  return method;
}

Contender PolygonSetMethod(const BenchScene& scene) {
  return EachReceiver(
      kPolygonSetName, kPolygonSetName,
      [scene = scene.scene](const Receiver& receiver, std::size_t /*index*/) {
        return PolygonSetIrradiance(scene, receiver);
      });
}

std::string SampledName(SamplePattern pattern, int count) {
  return SampledGroup(pattern) + " " + std::to_string(count);
}

}  // namespace truelux::bench
