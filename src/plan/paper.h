// SPDX-License-Identifier: GPL-3.0-or-later
// A surface on paper, as its lit side is seen.

#ifndef TRUELUX_PLAN_PAPER_H_
#define TRUELUX_PLAN_PAPER_H_

#include "truelux/isolux.h"

#include "draw/label_layout.h"
#include "draw/paper_path.h"

namespace truelux {

/// Puts points of the surface on paper, all lengths by one scale.
class Paper {
 public:
  /// room: the surface fills it in width or in height, and lies in its upper
  /// left corner.
  Paper(const Isolux& isolux, const LabelBox& room);

  [[nodiscard]] PaperPoint At(const Point3& p) const;

  /// A contour, without vertices that eyes cannot tell from the one before.
  [[nodiscard]] PaperPath PathOf(const IsoluxContour& contour) const;

  /// What the surface covers.
  [[nodiscard]] const LabelBox& area() const { return area_; }

  /// Pixels a unit of length.
  [[nodiscard]] double scale() const { return scale_; }

 private:
  /// Of a point, along right and up.
  [[nodiscard]] PaperPoint PlaceOf(const Point3& p) const;

  Point3 base_;
  Vector3 right_;
  Vector3 up_;
  double left_ = 0;  ///< least place along right
  double top_ = 0;   ///< largest place along up
  double scale_ = 1;
  LabelBox area_;
};

}  // namespace truelux

#endif  // TRUELUX_PLAN_PAPER_H_
