// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/occlusion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace truelux {

Occluder::Occluder(const Blocker& blocker, std::span<const PlanPoint> corners,
                   double slack)
    : slack_(slack) {
  Vec3<double> middle{0, 0, 0};
  for (const Vec3<double>& corner : blocker.corners) {
    middle =
        middle + (1 / static_cast<double>(blocker.corners.size())) * corner;
  }
  for (const PlanPoint& p : corners) {
    const double height = blocker.plane.HeightOf(p);
    const bool is_same_side =
        (height > 0) == (blocker.plane.HeightOf(corners[0]) > 0);
    is_usable_ = is_usable_ && is_same_side && std::fabs(height) > slack;
    Cone& cone = cones_.emplace_back();
    cone.apex = {p.s, p.t, 0};
    for (std::size_t i = 0; i < blocker.corners.size(); ++i) {
      const Vec3<double>& a = blocker.corners[i];
      const Vec3<double>& b = blocker.corners[(i + 1) % blocker.corners.size()];
      Vec3<double> normal = Cross(a - cone.apex, b - cone.apex);
      const double inward = Dot(normal, middle - cone.apex);
      const double length = std::sqrt(Dot(normal, normal));
      is_usable_ = is_usable_ && length > 0;
      normal = (inward > 0 ? 1 / length : -1 / length) * normal;
      cone.normals.push_back(normal);
    }
    if (!is_usable_) return;
  }
}

EdgePart Occluder::HiddenOf(const Vec3<double>& a, const Vec3<double>& b,
                            const EdgePart& part) const {
  EdgePart hidden = part;
  for (const Cone& cone : cones_) {
    for (const Vec3<double>& normal : cone.normals) {
      const double at_a = Dot(normal, a - cone.apex) - slack_;
      const double at_b = Dot(normal, b - cone.apex) - slack_;
      if (at_a <= 0 && at_b <= 0) return {1, 0};
      if (at_a > 0 && at_b > 0) continue;
      const double share = at_a / (at_a - at_b);
      if (at_a > 0) {
        hidden.to = std::min(hidden.to, share);
      } else {
        hidden.from = std::max(hidden.from, share);
      }
      if (hidden.from >= hidden.to) return {1, 0};
    }
  }
  return hidden;
}

bool Occluder::Hides(const Vec3<double>& p) const {
  return std::ranges::all_of(cones_, [&](const Cone& cone) {
    return std::ranges::all_of(cone.normals, [&](const Vec3<double>& normal) {
      return Dot(normal, p - cone.apex) > slack_;
    });
  });
}

}  // namespace truelux
