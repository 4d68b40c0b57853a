// SPDX-License-Identifier: GPL-3.0-or-later
// Points that are alike or near.

#ifndef TRUELUX_ISOMESH_NEAR_POINTS_H_
#define TRUELUX_ISOMESH_NEAR_POINTS_H_

#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "isolux/plan_frame.h"

namespace truelux {

/// Points by their squares of a grid.
class NearPoints {
 public:
  explicit NearPoints(double distance) : distance_(distance) {}

  void Add(const PlanPoint& p) { squares_[SquareOf(p)].push_back(p); }

  /// The nearest one within the distance.
  [[nodiscard]] const PlanPoint* NearestTo(const PlanPoint& p) const {
    const PlanPoint* nearest = nullptr;
    double least = distance_;
    const auto [s, t] = SquareOf(p);
    for (const double ds : {-1.0, 0.0, 1.0}) {
      for (const double dt : {-1.0, 0.0, 1.0}) {
        const auto square = squares_.find({s + ds, t + dt});
        if (square == squares_.end()) continue;
        for (const PlanPoint& other : square->second) {
          const double length = LengthOf(other - p);
          if (length > least) continue;
          least = length;
          nearest = &other;
        }
      }
    }
    return nearest;
  }

 private:
  [[nodiscard]] std::pair<double, double> SquareOf(const PlanPoint& p) const {
    return {std::floor(p.s / distance_), std::floor(p.t / distance_)};
  }

  double distance_;
  std::map<std::pair<double, double>, std::vector<PlanPoint>> squares_;
};

}  // namespace truelux

#endif  // TRUELUX_ISOMESH_NEAR_POINTS_H_
