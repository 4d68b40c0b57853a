// SPDX-License-Identifier: GPL-3.0-or-later
// How long the sweeps over random scenes are.
//
// A usual run takes a few scenes of each kind, so that the tests stay short.
// The tests with the label `slow` are the same ones in full; what they differ
// in is the environment: TRUELUX_LONG_TEST=full. TRUELUX_LONG_TEST=N makes
// sweeps over N scenes of each kind, for a night.

#ifndef TRUELUX_TESTS_SUPPORT_SWEEP_H_
#define TRUELUX_TESTS_SUPPORT_SWEEP_H_

#include <cstdlib>
#include <string>

namespace truelux::testing {

/// How many scenes of a kind a sweep takes: `quick` in a usual run, `full`
/// under the label slow, or as many as the environment says.
inline int SweepSize(int quick, int full) {
  const char* text = std::getenv("TRUELUX_LONG_TEST");
  if (text == nullptr) return quick;
  return std::string(text) == "full" ? full : std::stoi(text);
}

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_SUPPORT_SWEEP_H_
