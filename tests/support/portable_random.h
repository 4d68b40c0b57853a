// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers that are the same on every platform: raw engine bits only.

#ifndef TRUELUX_TESTS_SUPPORT_PORTABLE_RANDOM_H_
#define TRUELUX_TESTS_SUPPORT_PORTABLE_RANDOM_H_

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

namespace truelux::testing {

class PortableRandom {
 public:
  explicit PortableRandom(std::uint64_t seed) : engine_(seed) {}

  std::uint64_t Bits() { return engine_(); }

  /// Uniform in [lo, hi], integers.
  int Integer(int lo, int hi) {
    const auto count = static_cast<std::uint64_t>(hi - lo) + 1;
    return lo + static_cast<int>(Bits() % count);
  }

  /// Uniform in [0, 1) with 53 bits.
  double Unit() { return static_cast<double>(Bits() >> 11) * 0x1p-53; }

  /// Uniform in [lo, hi) up to rounding, full mantissa.
  double Uniform(double lo, double hi) { return lo + (hi - lo) * Unit(); }

  bool OneIn(int n) { return Integer(1, n) == 1; }

  /// x moved by -1, 0 or +1 unit in the last place.
  double Nudge(double x) {
    const int step = Integer(-1, 1);
    if (step == 0) return x;
    return std::nextafter(x, step > 0 ? HUGE_VAL : -HUGE_VAL);
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_SUPPORT_PORTABLE_RANDOM_H_
