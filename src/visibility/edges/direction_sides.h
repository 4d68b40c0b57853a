// SPDX-License-Identifier: GPL-3.0-or-later
// The sides of directions to the planes of one cone, each asked for once.

#ifndef TRUELUX_VISIBILITY_EDGES_DIRECTION_SIDES_H_
#define TRUELUX_VISIBILITY_EDGES_DIRECTION_SIDES_H_

#include <cstddef>
#include <memory>
#include <vector>

#include "base/ids.h"
#include "base/stamped_table.h"
#include "exact/plane_bundle.h"

namespace truelux {

/// Keeps the sides of directions to the planes of one bundle after the other.
/// Allocates nothing in the steady state.
template <class Geometry>
class DirectionSides {
 public:
  /// The geometry must outlive the object.
  explicit DirectionSides(Geometry& geometry) : geometry_(geometry) {}

  /// Chooses the bundle and forgets all sides, also those to this bundle.
  void SetBundle(BundleId bundle) {
    bundle_ = bundle;
    by_direction_.Clear();
    used_ = 0;
  }

  /// The bundle that Of is about.
  [[nodiscard]] BundleId bundle() const { return bundle_; }

  /// The complete sides of a direction to the planes of the bundle. The
  /// reference is valid until SetBundle, whatever is asked in between.
  BundleSides& Of(ViewDirectionId direction) {
    BundleSides* const* const found = by_direction_.Find(direction);
    return found != nullptr ? **found : MakeSides(direction);
  }

 private:
  BundleSides& MakeSides(ViewDirectionId direction) {
    if (used_ == storage_.size()) {
      storage_.push_back(std::make_unique<BundleSides>());
    }
    BundleSides& sides = *storage_[used_++];
    geometry_.FilterSides(bundle_, direction, sides);
    geometry_.CompleteSides(bundle_, direction, sides);
    by_direction_.Cover(geometry_.direction_count());
    by_direction_.Set(direction, &sides);
    return sides;
  }

  Geometry& geometry_;
  BundleId bundle_;
  StampedTable<BundleSides*, ViewDirectionId> by_direction_;
  std::vector<std::unique_ptr<BundleSides>> storage_;  ///< these never move
  std::size_t used_ = 0;                               ///< of storage_
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_EDGES_DIRECTION_SIDES_H_
