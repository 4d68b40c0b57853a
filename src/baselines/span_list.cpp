// SPDX-License-Identifier: GPL-3.0-or-later
#include "baselines/span_list.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace truelux {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// How far it is counter-clockwise [rad], in [0, 2 pi).
double AngleBetween(const SpanDirection& from, const SpanDirection& to) {
  const double angle = to.theta - from.theta;
  return angle < 0 ? angle + kTurn : angle;
}

/// Whether a is in front of b in direction theta [rad].
bool IsNearer(const SpanContent& a, const SpanContent& b, double theta) {
  if (a.depth != b.depth) return a.depth < b.depth;
  const double x = std::cos(theta);
  const double y = std::sin(theta);
  return a.slope_x * x + a.slope_y * y > b.slope_x * x + b.slope_y * y;
}

/// Half of C k atan(C (a x + b y)).
double VertexTerm(double x, double y, const SpanDirection& direction) {
  const double a = direction.a;
  const double b = direction.b;
  const double k = a * y - b * x;
  const double c = 1 / std::sqrt(a * a + b * b + k * k);
  return c * k * std::atan(c * (a * x + b * y)) / 2;
}

}  // namespace

SpanDirection MakeImageDirection(double a, double b) {
  const double theta = std::atan2(b, a);
  return {a, b, theta > -std::numbers::pi ? theta : std::numbers::pi};
}

bool IsMoreThanHalfTurn(const ImageSector& sector) {
  return AngleBetween(sector.from, sector.to) > 0.75 * kTurn;
}

void SpanList::Clear() {
  spans_.clear();
  around_ = {};
}

std::size_t SpanList::SplitAt(const SpanDirection& direction) {
  const auto at = std::ranges::lower_bound(
      spans_, direction.theta, {}, [](const Span& s) { return s.begin.theta; });
  const auto index =
      static_cast<std::size_t>(std::distance(spans_.begin(), at));
  if (at != spans_.end() && at->begin.theta == direction.theta) return index;
  SpanContent content = around_;
  if (!spans_.empty())
    content =
        at == spans_.begin() ? spans_.back().content : std::prev(at)->content;
  spans_.insert(at, {direction, content});
  return index;
}

void SpanList::Cover(std::size_t span, const SpanContent& content) {
  const Span& next = spans_[(span + 1) % spans_.size()];
  double width = AngleBetween(spans_[span].begin, next.begin);
  if (spans_.size() == 1) width = kTurn;
  const double middle = spans_[span].begin.theta + width / 2;
  if (IsNearer(content, spans_[span].content, middle))
    spans_[span].content = content;
}

void SpanList::Insert(const ImageSector& sector, const SpanContent& content) {
  if (sector.from.theta == sector.to.theta) return;
  SplitAt(sector.from);
  const std::size_t end = SplitAt(sector.to);
  // Only now, since the second split can move what the first one made.
  for (std::size_t i = SplitAt(sector.from); i != end;
       i = (i + 1) % spans_.size())
    Cover(i, content);
}

void SpanList::InsertFull(const SpanContent& content) {
  for (std::size_t i = 0; i < spans_.size(); ++i)
    Cover(i, content);
  if (spans_.empty() && IsNearer(content, around_, 0)) around_ = content;
}

void SpanList::InsertCommonPart(const std::vector<ImageSector>& sectors,
                                const SpanContent& content) {
  if (sectors.size() == 1) return Insert(sectors.front(), content);
  ends_.clear();
  for (const ImageSector& sector : sectors) {
    ends_.push_back(sector.from);
    ends_.push_back(sector.to);
  }
  std::ranges::sort(ends_, {}, &SpanDirection::theta);
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    const ImageSector part{ends_[i], ends_[(i + 1) % ends_.size()]};
    const auto holds_part = [&part](const ImageSector& sector) {
      return AngleBetween(sector.from, part.from) <
             AngleBetween(sector.from, sector.to);
    };
    if (std::ranges::all_of(sectors, holds_part)) Insert(part, content);
  }
}

Rgb SpanList::Contribution(double x, double y) const {
  Rgb sum{};
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    const Rgb& here = spans_[i].content.exitance;
    const Rgb& before =
        spans_[(i == 0 ? spans_.size() : i) - 1].content.exitance;
    if (here == before) continue;
    const double term = VertexTerm(x, y, spans_[i].begin);
    for (std::size_t c = 0; c < sum.size(); ++c)
      sum[c] += (here[c] - before[c]) * term;
  }
  return sum;
}

}  // namespace truelux
