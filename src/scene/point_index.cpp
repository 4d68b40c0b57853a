// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/point_index.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace truelux {
namespace {

constexpr int kFree = -1;
constexpr std::size_t kFirstSize = 64;

double WithoutNegativeZero(double x) {
  return x == 0 ? 0.0 : x;
}

std::uint64_t Mix(std::uint64_t hash, double coordinate) {
  hash =
      (hash ^ std::bit_cast<std::uint64_t>(coordinate)) * 0x9E3779B97F4A7C15U;
  return hash ^ (hash >> 32U);
}

}  // namespace

/// The slot that holds the point, or the free one where it belongs.
std::size_t PointIndex::SlotOf(const Point3& point) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = Mix(Mix(Mix(0, point.x), point.y), point.z) & mask;
  while (slots_[slot] != kFree &&
         points_[static_cast<std::size_t>(slots_[slot])] != point) {
    slot = (slot + 1) & mask;
  }
  return slot;
}

void PointIndex::Grow() {
  slots_.assign(std::max(kFirstSize, 2 * slots_.size()), kFree);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    slots_[SlotOf(points_[i])] = static_cast<int>(i);
  }
}

int PointIndex::Insert(const Point3& point) {
  if (2 * points_.size() >= slots_.size()) Grow();
  const Point3 key{WithoutNegativeZero(point.x), WithoutNegativeZero(point.y),
                   WithoutNegativeZero(point.z)};
  const std::size_t slot = SlotOf(key);
  if (slots_[slot] == kFree) {
    slots_[slot] = static_cast<int>(points_.size());
    points_.push_back(key);
  }
  return slots_[slot];
}

std::vector<Point3> PointIndex::TakePoints() {
  slots_.clear();
  return std::exchange(points_, {});
}

}  // namespace truelux
