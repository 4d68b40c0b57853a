// SPDX-License-Identifier: GPL-3.0-or-later
// Places for labels beside points, so that none covers another.

#ifndef TRUELUX_DRAW_LABEL_LAYOUT_H_
#define TRUELUX_DRAW_LABEL_LAYOUT_H_

#include <optional>
#include <string_view>
#include <vector>

namespace truelux {

/// A rectangle in a picture [px], y downwards.
struct LabelBox {
  double left = 0;
  double top = 0;
  double right = 0;
  double bottom = 0;

  [[nodiscard]] bool Overlaps(const LabelBox& other) const {
    return left < other.right && other.left < right && top < other.bottom &&
           other.top < bottom;
  }

  [[nodiscard]] bool Contains(const LabelBox& other) const {
    return left <= other.left && other.right <= right && top <= other.top &&
           other.bottom <= bottom;
  }
};

/// Where a label is written: its baseline and which end is there.
struct LabelPlace {
  double x = 0;
  double y = 0;
  const char* anchor = "start";
};

/// Hands out places one after the other.
class LabelLayout {
 public:
  /// Labels stay within `frame`.
  explicit LabelLayout(const LabelBox& frame) : frame_(frame) {}

  /// Something that labels must not cover.
  void Avoid(const LabelBox& box) { taken_.push_back(box); }

  /// A free place around a point, on the right if possible; taken from then
  /// on. Nothing if there is none.
  std::optional<LabelPlace> Place(double x, double y, std::string_view text,
                                  int font_size);

 private:
  LabelBox frame_;
  std::vector<LabelBox> taken_;
};

}  // namespace truelux

#endif  // TRUELUX_DRAW_LABEL_LAYOUT_H_
