// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/gap_label.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace truelux {
namespace {

/// Whether the axes of `a` part the two.
bool AxesPart(const GapLabel& a, const GapLabel& b) {
  double left = HUGE_VAL;
  double right = -HUGE_VAL;
  double top = HUGE_VAL;
  double bottom = -HUGE_VAL;
  for (const PaperPoint& corner : b.Corners()) {
    const PaperPoint at = a.PlaceOf(corner);
    left = std::min(left, at.x);
    right = std::max(right, at.x);
    top = std::min(top, at.y);
    bottom = std::max(bottom, at.y);
  }
  return left >= a.half_width || right <= -a.half_width ||
         top >= a.half_height || bottom <= -a.half_height;
}

/// The part [from, to] of the way from a to b that is in a label; from > to:
/// none is.
std::pair<double, double> PartInside(const GapLabel& label, const PaperPoint& a,
                                     const PaperPoint& b) {
  const double reach = label.half_width + label.half_height;
  if (std::min(a.x, b.x) > label.middle.x + reach ||
      std::max(a.x, b.x) < label.middle.x - reach ||
      std::min(a.y, b.y) > label.middle.y + reach ||
      std::max(a.y, b.y) < label.middle.y - reach)
    return {1, 0};
  const PaperPoint p = label.PlaceOf(a);
  const PaperPoint q = label.PlaceOf(b);
  double from = 0;
  double to = 1;
  const auto cut = [&](double start, double end, double limit) {
    const double step = end - start;
    if (step == 0) {
      if (std::abs(start) >= limit) to = -1;
      return;
    }
    const double one = (-limit - start) / step;
    const double other = (limit - start) / step;
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
  };
  cut(p.x, q.x, label.half_width);
  cut(p.y, q.y, label.half_height);
  return {from, to};
}

}  // namespace

PaperPoint GapLabel::PlaceOf(const PaperPoint& p) const {
  const double turn = angle * std::numbers::pi / 180;
  const double x = p.x - middle.x;
  const double y = p.y - middle.y;
  return {x * std::cos(turn) + y * std::sin(turn),
          y * std::cos(turn) - x * std::sin(turn)};
}

bool GapLabel::Holds(const PaperPoint& p) const {
  const PaperPoint at = PlaceOf(p);
  return std::abs(at.x) <= half_width && std::abs(at.y) <= half_height;
}

bool GapLabel::Overlaps(const GapLabel& other) const {
  const double reach =
      half_width + half_height + other.half_width + other.half_height;
  if (std::abs(middle.x - other.middle.x) > reach ||
      std::abs(middle.y - other.middle.y) > reach)
    return false;
  return !AxesPart(*this, other) && !AxesPart(other, *this);
}

std::array<PaperPoint, 4> GapLabel::Corners() const {
  const double turn = angle * std::numbers::pi / 180;
  const PaperPoint u = {half_width * std::cos(turn),
                        half_width * std::sin(turn)};
  const PaperPoint v = {-half_height * std::sin(turn),
                        half_height * std::cos(turn)};
  const auto at = [&](int i, int k) {
    return PaperPoint{middle.x + i * u.x + k * v.x,
                      middle.y + i * u.y + k * v.y};
  };
  return {at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)};
}

std::vector<PaperPath> OutsideLabels(const PaperPath& path,
                                     std::span<const GapLabel> labels) {
  std::vector<PaperPath> pieces;
  PaperPath piece;
  const auto end_piece = [&] {
    if (piece.size() > 1) pieces.push_back(std::move(piece));
    piece.clear();
  };
  for (std::size_t i = 1; i < path.size(); ++i) {
    const PaperPoint& a = path[i - 1];
    const PaperPoint& b = path[i];
    std::vector<std::pair<double, double>> hidden;
    for (const GapLabel& label : labels) {
      const auto part = PartInside(label, a, b);
      if (part.first < part.second) hidden.push_back(part);
    }
    std::ranges::sort(hidden);
    hidden.emplace_back(1, 1);
    double shown_from = 0;
    for (const auto& [from, to] : hidden) {
      const auto at = [&](double t) {
        return PaperPoint{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
      };
      if (from > shown_from) {
        if (piece.empty()) piece.push_back(at(shown_from));
        piece.push_back(at(from));
      }
      if (to > shown_from && to > from) end_piece();
      shown_from = std::max(shown_from, to);
    }
  }
  end_piece();
  return pieces;
}

}  // namespace truelux
