// SPDX-License-Identifier: GPL-3.0-or-later
// Four doubles at a time. GCC and Clang compute with these lane by lane on any
// processor, and by one instruction where there is one.

#ifndef TRUELUX_EXACT_LANES_H_
#define TRUELUX_EXACT_LANES_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#ifdef __AVX__
#include <immintrin.h>
#endif

namespace truelux {

inline constexpr std::size_t kLanes = 4;

/// Passed by reference only: by value they would have another ABI on each
/// processor.
using Lanes [[gnu::vector_size(kLanes * sizeof(double))]] = double;

/// What a comparison of Lanes gives: lanes of 0 or of all bits set.
using LaneFlags [[gnu::vector_size(kLanes * sizeof(double))]] = std::int64_t;

/// Bit k: whether lane k is set.
inline std::uint32_t Gather(const LaneFlags& flags) {
#ifdef __AVX__  // one instruction, which no portable expression leads to
  __m256d raw;
  std::memcpy(&raw, &flags, sizeof raw);
  return static_cast<std::uint32_t>(_mm256_movemask_pd(raw));
#else
  constexpr LaneFlags kBit{1, 2, 4, 8};
  const LaneFlags bits = flags & kBit;
  return static_cast<std::uint32_t>(bits[0] | bits[1] | bits[2] | bits[3]);
#endif
}

/// The same numbers as an array, to be stored and passed.
using LaneArray = std::array<double, kLanes>;

inline void Load(const LaneArray& from, Lanes& to) {
  std::memcpy(&to, from.data(), sizeof to);
}

inline void Store(const Lanes& from, LaneArray& to) {
  std::memcpy(to.data(), &from, sizeof from);
}

}  // namespace truelux

#endif  // TRUELUX_EXACT_LANES_H_
