// SPDX-License-Identifier: GPL-3.0-or-later
// The ways to find an irradiance that are compared.

#ifndef TRUELUX_BENCH_METHODS_H_
#define TRUELUX_BENCH_METHODS_H_

#include <cstddef>
#include <string>

#include "baselines/contender.h"
#include "scenes.h"
#include "visibility/edges/contour_engine.h"

namespace truelux::bench {

/// The names under which results are looked up.
inline constexpr const char* kCertifiedName = "truelux certified";
inline constexpr const char* kDoubleName = "truelux double";
inline constexpr const char* kUnfilteredName = "unfiltered predicates";
inline constexpr const char* kBlockersName = "contour by blockers";
inline constexpr const char* kChainName = "contour by chain";
inline constexpr const char* kPolygonSetName = "CGAL Polygon_set_2";

/// E by the default engine: the nearest binary64.
Contender CertifiedMethod(const BenchScene& scene);

/// The same visibility, summed in double.
Contender DoubleMethod(const BenchScene& scene);

/// The default engine with predicates in double without any filter, summed in
/// double. May be wrong. For one thread.
Contender UnfilteredMethod(const BenchScene& scene);

/// E by the default engine made to find contours one way, as the oracle does
/// it: blocks of receivers share what they find. For one thread.
Contender ContourPathMethod(const BenchScene& scene, ContourPath path,
                            const std::string& name);

/// The second engine, on a few receivers.
Contender ArrangementMethod(const BenchScene& scene, std::size_t max_receivers);

/// CGAL's Boolean operations on the projections, exact kernel. For scenes
/// whose only source is face 1 with nothing behind it.
Contender PolygonSetMethod(const BenchScene& scene);

/// "Embree Sobol 1024", "Embree streams 1024".
std::string SampledName(SamplePattern pattern, int count);

}  // namespace truelux::bench

#endif  // TRUELUX_BENCH_METHODS_H_
