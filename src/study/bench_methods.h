// SPDX-License-Identifier: GPL-3.0-or-later
// The methods that truelux bench compares.

#ifndef TRUELUX_STUDY_BENCH_METHODS_H_
#define TRUELUX_STUDY_BENCH_METHODS_H_

#include <cstdint>
#include <string>
#include <vector>

#include "truelux/scene.h"

#include "baselines/contender.h"

namespace truelux {

/// Which methods are wanted.
struct MethodChoice {
  bool quick = false;        ///< fewer efforts per method
  bool arrangement = false;  ///< the arrangement engine on any scene
  std::uint64_t seed = 1;    ///< of random samples
};

/// The methods, prepared for one scene.
struct MethodList {
  /// The first one is the oracle, whose values are the truth.
  std::vector<Contender> methods;
  /// Methods that cannot be run, each with its reason: "NAME: why".
  std::vector<std::string> absent;
};

/// To add methods, add a function to the table in bench_methods.cpp.
MethodList PrepareMethods(const Scene& scene, const MethodChoice& choice);

/// With more triangles the arrangement engine is left out unless asked for.
inline constexpr std::size_t kArrangementTriangles = 300;

/// It is run on so many receivers, since it is a thousand times slower.
inline constexpr std::size_t kArrangementReceivers = 20;

}  // namespace truelux

#endif  // TRUELUX_STUDY_BENCH_METHODS_H_
