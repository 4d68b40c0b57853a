// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers of one case of a regime: the same on every platform, and
// independent of how many numbers other cases have drawn. Two draws never stand
// in one expression whose order the language leaves open.

#ifndef TRUELUX_BASELINES_CASE_RANDOM_H_
#define TRUELUX_BASELINES_CASE_RANDOM_H_

#include <cstdint>

namespace truelux {

/// SplitMix64 (Steele, Lea and Flood 2014), started from a seed and the number
/// of the case.
class CaseRandom {
 public:
  CaseRandom(std::uint64_t seed, std::uint64_t index)
      : state_(Mix(seed) ^ Mix(~index)) {}

  std::uint64_t Bits() { return Mix(state_ += kStep); }

  /// Uniform in [0, count), count small.
  int Below(int count) {
    return static_cast<int>(Bits() % static_cast<std::uint64_t>(count));
  }

  /// Uniform in [lo, hi) up to rounding, 53 random bits.
  double Uniform(double lo, double hi) {
    return lo + (hi - lo) * (static_cast<double>(Bits() >> 11) * 0x1p-53);
  }

  /// -1 or 1.
  double Sign() { return (Bits() >> 63) != 0 ? -1 : 1; }

 private:
  static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15;

  static std::uint64_t Mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

}  // namespace truelux

#endif  // TRUELUX_BASELINES_CASE_RANDOM_H_
