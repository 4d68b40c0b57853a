// SPDX-License-Identifier: GPL-3.0-or-later
#include "contour_distances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "truelux/derivatives.h"

namespace truelux::bench {

SortedNumbers::SortedNumbers(std::vector<double> all)
    : sorted_(std::move(all)) {
  std::ranges::sort(sorted_);
}

double SortedNumbers::At(double share) const {
  if (sorted_.empty()) return 0;
  const auto last = static_cast<double>(sorted_.size() - 1);
  return sorted_[static_cast<std::size_t>(share * last)];
}

std::vector<DrawnContour> DrawnContoursOf(const Isolux& isolux) {
  std::vector<DrawnContour> drawn;
  for (const IsoluxContour& contour : isolux.contours) {
    DrawnContour& line = drawn.emplace_back();
    line.level = contour.level;
    line.is_closed = contour.is_closed;
    for (const IsoluxVertex& vertex : contour.vertices)
      line.points.push_back(vertex.at);
  }
  return drawn;
}

ContourDistances::ContourDistances(const IsoluxFloor& floor,
                                   const Oracle& oracle, const Isolux& isolux)
    : floor_(floor), oracle_(oracle), isolux_(isolux) {
  const Vector3& r = isolux.right;
  const Vector3& u = isolux.up;
  normal_ = {r.y * u.z - r.z * u.y, r.z * u.x - r.x * u.z,
             r.x * u.y - r.y * u.x};
}

double ContourDistances::DistanceAt(const Point3& from, double level) const {
  const double most = 0.01 * isolux_.size;
  Point3 p = from;
  for (int i = 0; i < 6; ++i) {
    const Derivatives d = oracle_.Derivatives(
        Receiver{p, normal_, 1}, {.sphere = false, .jacobian = false});
    const Vector3& g = d.channels[0].tangential;
    const double square = g.x * g.x + g.y * g.y + g.z * g.z;
    if (!(square > 0)) return most;
    const double step = (level - d.irradiance.value[0]) / square;
    p = {p.x + step * g.x, p.y + step * g.y, p.z + step * g.z};
    const double moved = std::hypot(p.x - from.x, p.y - from.y, p.z - from.z);
    if (!(moved < most)) return most;
    if (std::fabs(step) * std::sqrt(square) < 1e-12 * isolux_.size)
      return moved;
  }
  return std::hypot(p.x - from.x, p.y - from.y, p.z - from.z);
}

SortedNumbers ContourDistances::OfContours(
    std::span<const DrawnContour> contours) const {
  constexpr std::size_t kMeasured = 4000;
  const auto chords = [](const DrawnContour& contour) {
    const std::size_t count = contour.points.size();
    return contour.is_closed || count == 0 ? count : count - 1;
  };
  std::size_t total = 0;
  for (const DrawnContour& contour : contours)
    total += chords(contour);
  const std::size_t stride = std::max<std::size_t>(1, total / kMeasured);
  std::vector<double> all;
  std::size_t seen = 0;
  for (const DrawnContour& contour : contours) {
    for (std::size_t i = 0; i < chords(contour); ++i) {
      if (seen++ % stride != 0) continue;
      const Point3& a = contour.points[i];
      const Point3& b = contour.points[(i + 1) % contour.points.size()];
      // The contour passes through both ends.
      const double half = std::hypot(b.x - a.x, b.y - a.y, b.z - a.z) / 2;
      const Point3 middle = {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
      all.push_back(std::min(half, DistanceAt(middle, contour.level)));
    }
  }
  return SortedNumbers(std::move(all));
}

template <class Value, class At>
void ContourDistances::AddSquare(int x, int y, const Value& value, const At& at,
                                 double level, std::size_t& seen,
                                 std::vector<double>& all) const {
  const std::array<std::array<int, 2>, 4> corners = {
      {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}};
  std::vector<std::array<double, 2>> hits;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& [ax, ay] = corners[k];
    const auto& [bx, by] = corners[(k + 1) % 4];
    const double ea = value(ax, ay);
    const double eb = value(bx, by);
    if ((ea < level) == (eb < level)) continue;
    const double share = (level - ea) / (eb - ea);
    hits.push_back({ax + share * (bx - ax), ay + share * (by - ay)});
  }
  if (hits.size() != 2 || seen++ % 16 != 0) return;
  all.push_back(DistanceAt(
      at((hits[0][0] + hits[1][0]) / 2, (hits[0][1] + hits[1][1]) / 2), level));
}

SortedNumbers ContourDistances::OfMarchingSquares(double evaluations) const {
  const auto columns =
      static_cast<int>(std::sqrt(evaluations * floor_.width / floor_.height));
  const auto rows = static_cast<int>(evaluations / columns);
  const auto at = [&](double x, double y) {
    const Vector3& r = isolux_.right;
    const Vector3& u = isolux_.up;
    const double a = floor_.width * x / (columns - 1);
    const double b = floor_.height * y / (rows - 1);
    return Point3{floor_.corner.x + a * r.x + b * u.x,
                  floor_.corner.y + a * r.y + b * u.y,
                  floor_.corner.z + a * r.z + b * u.z};
  };
  std::vector<double> values;
  for (int y = 0; y < rows; ++y) {
    std::vector<Receiver> row;
    row.reserve(static_cast<std::size_t>(columns));
    for (int x = 0; x < columns; ++x)
      row.push_back({at(x, y), normal_, 1});
    for (const Irradiance& e : oracle_.Evaluate(row))
      values.push_back(e.value[0]);
  }
  const auto value = [&](int x, int y) {
    return values[static_cast<std::size_t>(y) *
                      static_cast<std::size_t>(columns) +
                  static_cast<std::size_t>(x)];
  };
  std::vector<double> all;
  std::size_t seen = 0;
  for (int y = 0; y + 1 < rows; ++y) {
    for (int x = 0; x + 1 < columns; ++x) {
      for (const double level : isolux_.levels)
        AddSquare(x, y, value, at, level, seen, all);
    }
  }
  return SortedNumbers(std::move(all));
}

}  // namespace truelux::bench
