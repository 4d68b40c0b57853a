// SPDX-License-Identifier: GPL-3.0-or-later
// Many methods on the receivers of one scene, beside the certified truth.

#ifndef TRUELUX_STUDY_COMPARISON_H_
#define TRUELUX_STUDY_COMPARISON_H_

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "truelux/geometry.h"
#include "truelux/receiver.h"

namespace truelux {

/// One method's answers.
struct MethodResult {
  std::string name;         ///< e.g. "lambert-edge double", "Embree Sobol 1024"
  std::string group;        ///< e.g. "formula, double"; one colour in the chart
  double microseconds = 0;  ///< per receiver, one thread
  /// One entry per receiver of the comparison; nothing: the method does not
  /// apply there.
  std::vector<std::optional<Rgb>> values;
  /// Of the receivers without a value: on so many it was not tried, for want of
  /// time.
  std::size_t left_out = 0;
  std::string note;  ///< what is particular: "not on all receivers", ...
};

/// Everything that a report shows.
struct Comparison {
  std::string scene;                 ///< its file name
  std::vector<Receiver> receivers;   ///< those that were compared
  std::vector<Rgb> truth;            ///< certified, one per receiver
  std::vector<std::string> reasons;  ///< why a receiver may be hard; may be ""
  std::vector<MethodResult> methods;
  /// Methods that could not be run, each with its reason.
  std::vector<std::string> absent;
  std::string processor;  ///< on which it was measured; may be ""
};

}  // namespace truelux

#endif  // TRUELUX_STUDY_COMPARISON_H_
