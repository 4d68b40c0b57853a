// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods.h"

#include "truelux/irradiance.h"

#include "polygon_set.h"

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
