// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/paper.h"

#include <algorithm>
#include <cmath>

#include "base/vector_math.h"
#include "plan/plan_points.h"

namespace truelux {

Paper::Paper(const Isolux& isolux, const LabelBox& room)
    : right_(isolux.right), up_(isolux.up) {
  area_ = {room.left, room.top, room.left, room.top};
  double right = 0;
  double bottom = 0;
  bool is_first = true;
  ForEachPlanPoint(isolux, [&](const Point3& p) {
    if (is_first) base_ = p;
    is_first = false;
    const PaperPoint place = PlaceOf(p);
    left_ = std::min(left_, place.x);
    right = std::max(right, place.x);
    top_ = std::max(top_, place.y);
    bottom = std::min(bottom, place.y);
  });
  const double width = right - left_;
  const double height = top_ - bottom;
  if (width > 0 || height > 0) {
    scale_ =
        std::min(width > 0 ? (room.right - room.left) / width : HUGE_VAL,
                 height > 0 ? (room.bottom - room.top) / height : HUGE_VAL);
  }
  area_.right += scale_ * width;
  area_.bottom += scale_ * height;
}

PaperPoint Paper::PlaceOf(const Point3& p) const {
  const Vector3 from_base = FromTo(base_, p);
  return {Dot(from_base, right_), Dot(from_base, up_)};
}

PaperPoint Paper::At(const Point3& p) const {
  const PaperPoint place = PlaceOf(p);
  return {area_.left + scale_ * (place.x - left_),
          area_.top + scale_ * (top_ - place.y)};
}

PaperPath Paper::PathOf(const IsoluxContour& contour) const {
  constexpr double kNear = 0.3;
  PaperPath path;
  for (std::size_t i = 0; i < contour.vertices.size(); ++i) {
    const PaperPoint p = At(contour.vertices[i].at);
    const bool is_last = i + 1 == contour.vertices.size();
    if (!path.empty() && !is_last &&
        std::hypot(p.x - path.back().x, p.y - path.back().y) < kNear)
      continue;
    path.push_back(p);
  }
  if (contour.is_closed && !path.empty()) path.push_back(path.front());
  return path;
}

}  // namespace truelux
