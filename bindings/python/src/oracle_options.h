// SPDX-License-Identifier: GPL-3.0-or-later
// How an oracle answers, out of words.

#ifndef TRUELUX_BINDINGS_PYTHON_ORACLE_OPTIONS_H_
#define TRUELUX_BINDINGS_PYTHON_ORACLE_OPTIONS_H_

#include <optional>
#include <string>

#include "truelux/irradiance.h"
#include "truelux/picture.h"
#include "truelux/stop.h"

namespace truelux::python {

/// OracleOptions without a stop flag, and how many threads there may be.
struct Choice {
  Engine engine = Engine::kContour;
  Method method = Method::kCertified;
  Emission emission = Emission::kExitance;
  Formula formula = Formula::kAuto;
  double half_side = 0x1p20;
  int threads = 0;  ///< 0: as many as there are cores

  [[nodiscard]] OracleOptions Options(const StopFlag* stop) const;

  /// At least 1.
  [[nodiscard]] int ThreadCount() const;
};

/// Throws InputError for a word that is none of those of its kind, naming all.
[[nodiscard]] Choice MakeChoice(const std::string& engine,
                                const std::string& method,
                                const std::string& emission,
                                const std::string& formula, double half_side,
                                int threads);

/// By its name: "luminance", "r", "g", "b"; nothing: nothing. Throws InputError
/// for other words.
[[nodiscard]] std::optional<ScalarChannel> ChannelOf(
    const std::optional<std::string>& name);

}  // namespace truelux::python

#endif  // TRUELUX_BINDINGS_PYTHON_ORACLE_OPTIONS_H_
