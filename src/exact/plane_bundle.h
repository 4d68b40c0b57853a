// SPDX-License-Identifier: GPL-3.0-or-later
// Several planes at once: the filter stage of one direction against all the
// planes of a cone, four to an instruction where the processor has them.

#ifndef TRUELUX_EXACT_PLANE_BUNDLE_H_
#define TRUELUX_EXACT_PLANE_BUNDLE_H_

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "base/ids.h"
#include "exact/crossing.h"
#include "exact/filter.h"
#include "exact/lanes.h"
#include "exact/rounding.h"
#include "exact/sign.h"

namespace truelux {

/// The signs of one direction against the planes of a bundle. Values and errors
/// that are not used are not cleared, which would cost more than the others.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
struct BundleSides {
  static constexpr std::size_t kMaxPlanes = 8;

  std::uint32_t positive = 0;  ///< bit k: N_k . d > 0
  std::uint32_t negative = 0;  ///< bit k: N_k . d < 0
  /// Whether a plane with neither bit set has sign zero; else it is not known.
  bool complete = false;
  alignas(32) std::array<double, kMaxPlanes> value;  ///< the filter's
  alignas(32) std::array<double, kMaxPlanes> error;  ///< its bound

  [[nodiscard]] Side SideOf(std::size_t k) const {
    const Sign sign = (positive >> k & 1) != 0   ? Sign::kPositive
                      : (negative >> k & 1) != 0 ? Sign::kNegative
                                                 : Sign::kZero;
    return {sign, {value[k], error[k]}};
  }
};

/// Up to BundleSides::kMaxPlanes filtered planes side by side. Unused ones are
/// 0: they have neither sign.
class PlaneBundle {
 public:
  // What is not used is not cleared: it would cost more than what is.
  // A default constructor would clear it where an object is made by {}.
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init,modernize-use-equals-default)
  PlaneBundle() {}

  /// Adds a plane with its id.
  void Add(const FilteredPlane& plane, ViewPlaneId id) {
    assert(size_ < BundleSides::kMaxPlanes);
    Quad& quad = quads_[size_ / kLanes];
    const std::size_t lane = size_ % kLanes;
    if (lane == 0) quad = Quad{};
    quad.x[lane] = plane.v.x;
    quad.y[lane] = plane.v.y;
    quad.z[lane] = plane.v.z;
    quad.a[lane] = plane.a;
    quad.b[lane] = plane.b;
    ids_[size_] = id;
    ++size_;
  }

  [[nodiscard]] std::size_t size() const { return size_; }

  [[nodiscard]] ViewPlaneId id(std::size_t k) const { return ids_[k]; }

  /// A bit for every plane.
  [[nodiscard]] std::uint32_t mask() const { return (1U << size_) - 1; }

  /// FilteredDot of every plane (without error bounds unless kFiltered).
  /// Requires RoundUpward.
  template <bool kFiltered>
  void Filter(const FilteredDirection& d, BundleSides& sides) const {
    assert(IsRoundingUpward());
    sides.complete = false;
    FilterQuad<kFiltered>(0, d, sides);
    if (size_ <= kLanes) return;
    const std::uint32_t positive = sides.positive;
    const std::uint32_t negative = sides.negative;
    FilterQuad<kFiltered>(1, d, sides);
    sides.positive = sides.positive << kLanes | positive;
    sides.negative = sides.negative << kLanes | negative;
  }

 private:
  struct Quad {
    Lanes x;
    Lanes y;
    Lanes z;
    Lanes a;
    Lanes b;
  };

  template <bool kFiltered>
  void FilterQuad(std::size_t q, const FilteredDirection& d,
                  BundleSides& sides) const {
    const Quad& quad = quads_[q];
    const Lanes value = quad.x * d.v.x + quad.y * d.v.y + quad.z * d.v.z;
    Lanes error{};
    if constexpr (kFiltered) {
      const Lanes bound = d.max * quad.a + d.v.error * quad.b + kDotFloor;
      constexpr Lanes kUnknown{HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL};
      error = bound < kNoDotOverflow ? bound : kUnknown;
    }
    std::memcpy(sides.value.data() + q * kLanes, &value, sizeof value);
    std::memcpy(sides.error.data() + q * kLanes, &error, sizeof error);
    sides.positive = Gather(value > error);
    sides.negative = Gather(-value > error);
  }

  std::array<Quad, BundleSides::kMaxPlanes / kLanes> quads_;
  std::array<ViewPlaneId, BundleSides::kMaxPlanes> ids_;
  std::size_t size_ = 0;
};

}  // namespace truelux

#endif  // TRUELUX_EXACT_PLANE_BUNDLE_H_
