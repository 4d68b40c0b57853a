// SPDX-License-Identifier: GPL-3.0-or-later
// The ways to find an irradiance that are compared.

#ifndef TRUELUX_BASELINES_CONTENDER_H_
#define TRUELUX_BASELINES_CONTENDER_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "truelux/irradiance.h"
#include "truelux/receiver.h"
#include "truelux/scene.h"
#include "truelux/stop.h"

#include "baselines/emitter_samples.h"
#include "baselines/sampled.h"

namespace truelux {

/// A method prepared for one scene; preparing is not part of its time.
struct Contender {
  std::string name;   ///< e.g. "Embree Sobol 1024"
  std::string group;  ///< e.g. "Embree Sobol": methods that differ in effort
  /// The irradiance at each receiver, nothing where the method does not apply;
  /// bounds and statistics as far as the method has them.
  std::function<std::vector<std::optional<Irradiance>>(
      std::span<const Receiver>)>
      run;
  /// It is run on so many receivers only; 0: on all.
  std::size_t max_receivers = 0;
  std::string note = {};  ///< what a reader must know about it
  /// Runs add the seconds that are not the method's own; null: there are none.
  std::shared_ptr<double> not_counted = {};
  /// Set from outside, a run ends with Stopped; null: it does not look.
  std::shared_ptr<StopFlag> stop = {};
};

/// A method that takes the receivers one by one. one(receiver, index) gives an
/// Rgb or an std::optional<Rgb>.
template <class OneReceiver>
Contender EachReceiver(std::string name, std::string group, OneReceiver one) {
  const auto run = [one](std::span<const Receiver> receivers) {
    std::vector<std::optional<Irradiance>> results;
    results.reserve(receivers.size());
    for (const Receiver& receiver : receivers) {
      const std::optional<Rgb> value = one(receiver, results.size());
      auto& result = results.emplace_back();
      if (value) result.emplace().value = *value;
    }
    return results;
  };
  return {std::move(name), std::move(group), run};
}

/// E by the oracle with these options, but for `stop`, which is the contender's.
Contender OracleContender(const Scene& scene, const std::string& name,
                          OracleOptions options);

/// The default engine with predicates in double without any filter, summed in
/// double. May be wrong. For one thread.
Contender UnfilteredContender(const Scene& scene, const std::string& name);

/// Shadow rays. The samples are drawn beforehand, in a few independent sets
/// that the receivers use in turn. rays: of the same scene.
Contender SampledContender(const Scene& scene,
                           std::shared_ptr<const ShadowRays> rays,
                           SamplePattern pattern, int count,
                           std::uint64_t seed);

/// The row by row quadrature.
Contender ScanlineContender(const Scene& scene, int rows);

/// "Embree Sobol", "Embree streams", "Embree random".
std::string SampledGroup(SamplePattern pattern);

}  // namespace truelux

#endif  // TRUELUX_BASELINES_CONTENDER_H_
