// The ways to find an irradiance that are compared.

#ifndef TRUELUX_BENCH_METHODS_H_
#define TRUELUX_BENCH_METHODS_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "truelux/irradiance.h"
#include "truelux/receiver.h"

#include "baselines/emitter_samples.h"
#include "baselines/sampled.h"
#include "scenes.h"

namespace truelux::bench {

/// A method prepared for one scene; preparing is not part of its time.
struct Contender {
  std::string name;    ///< e.g. "Embree Sobol 1024"
  std::string family;  ///< e.g. "Embree Sobol": methods that differ in effort
  /// The irradiance at each receiver; bounds and statistics as far as the
  /// method has them.
  std::function<std::vector<Irradiance>(std::span<const Receiver>)> run;
  /// It is run on so many of the scene's first receivers only; 0: on all.
  std::size_t max_receivers = 0;
};

/// The names under which results are looked up.
inline constexpr const char* kCertifiedName = "truelux certified";
inline constexpr const char* kDoubleName = "truelux double";
inline constexpr const char* kUnfilteredName = "unfiltered predicates";
inline constexpr const char* kPolygonSetName = "CGAL Polygon_set_2";

/// E by the default engine: the nearest binary64.
Contender CertifiedMethod(const BenchScene& scene);

/// The same visibility, summed in double.
Contender DoubleMethod(const BenchScene& scene);

/// The default engine with predicates in double without any filter, summed in
/// double. May be wrong. For one thread.
Contender UnfilteredMethod(const BenchScene& scene);

/// The second engine, on a few receivers.
Contender ArrangementMethod(const BenchScene& scene, std::size_t max_receivers);

/// Shadow rays. The samples are drawn beforehand, in a few independent sets
/// that the receivers use in turn. rays: of the same scene.
Contender SampledMethod(const BenchScene& scene,
                        std::shared_ptr<const ShadowRays> rays,
                        SamplePattern pattern, int count, std::uint64_t seed);

/// The row by row quadrature.
Contender ScanlineMethod(const BenchScene& scene, int rows);

/// CGAL's Boolean operations on the projections, exact kernel. For scenes
/// whose only source is face 1 with nothing behind it.
Contender PolygonSetMethod(const BenchScene& scene);

/// "Embree Sobol 1024", "Embree streams 1024".
std::string SampledName(SamplePattern pattern, int count);

}  // namespace truelux::bench

#endif  // TRUELUX_BENCH_METHODS_H_
