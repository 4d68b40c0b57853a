// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/gradients/nearest_gradient.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/vector_math.h"

namespace truelux {
namespace {

/// Corners of the set of gradients less the value, at most four.
using Corners = std::vector<Vector3>;

/// Whether 0 is inside the tetrahedron of four corners.
bool IsAroundZero(const Corners& c) {
  const auto volume = [](const Vector3& p, const Vector3& q, const Vector3& r) {
    return Dot(p, Cross(q, r));
  };
  const double a = volume(c[1], c[2], c[3]);
  const double b = -volume(c[0], c[2], c[3]);
  const double d = volume(c[0], c[1], c[3]);
  const double e = -volume(c[0], c[1], c[2]);
  return (a > 0 && b > 0 && d > 0 && e > 0) ||
         (a < 0 && b < 0 && d < 0 && e < 0);
}

/// The point of least length in the plane, line or point that the corners with
/// the indices span; nothing if it is not between them, or they are too many.
std::optional<Vector3> LeastBetween(const Corners& all,
                                    const std::vector<std::size_t>& indices) {
  const Vector3& a = all[indices[0]];
  if (indices.size() == 1) return a;
  const Vector3 u = Difference(all[indices[1]], a);
  if (indices.size() == 2) {
    const double t = -Dot(a, u) / Dot(u, u);
    if (!(t > 0 && t < 1)) return std::nullopt;
    return Sum(a, Times(t, u));
  }
  const Vector3 v = Difference(all[indices[2]], a);
  const Vector3 n = Cross(u, v);
  const double square = Dot(n, n);
  // a = (height) n + what lies in the plane, which is -s u - t v.
  const Vector3 foot = Times(Dot(a, n) / square, n);
  const Vector3 in_plane = Difference(foot, a);
  const double s = Dot(Cross(in_plane, v), n) / square;
  const double t = Dot(Cross(u, in_plane), n) / square;
  if (!(s > 0 && t > 0 && s + t < 1)) return std::nullopt;
  return foot;
}

/// Leaves the corners of the face of their hull that is nearest to 0, and gives
/// its point of least length. With four corners around 0: (0, 0, 0).
Vector3 Reduce(Corners& corners) {
  const std::size_t count = corners.size();
  if (count == 4 && IsAroundZero(corners)) return {};
  Vector3 best = corners[0];
  double least = HUGE_VAL;
  std::vector<std::size_t> kept;
  for (unsigned subset = 1; subset < (1U << count); ++subset) {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < count; ++i)
      if ((subset >> i & 1U) != 0) indices.push_back(i);
    if (indices.size() > 3) continue;
    const auto point = LeastBetween(corners, indices);
    if (!point || !(LengthOf(*point) < least)) continue;
    least = LengthOf(*point);
    best = *point;
    kept = indices;
  }
  Corners next;
  for (const std::size_t i : kept)
    next.push_back(corners[i]);
  corners = next;
  return best;
}

}  // namespace

Vector3 NearestGradient(const Vector3& mean, std::span<const Kink> kinks,
                        std::size_t channel, const Vector3& value) {
  const Vector3 start = Difference(mean, value);
  if (!std::isfinite(LengthOf(start))) return mean;
  double scale = LengthOf(mean);
  for (const Kink& kink : kinks)
    scale += std::abs(kink.size[channel]);
  // The corner of mean + sum of +-b m that is farthest in a direction.
  const auto farthest = [&](const Vector3& ahead) {
    Vector3 corner = start;
    for (const Kink& kink : kinks) {
      const double b = std::abs(kink.size[channel]);
      const double side = Dot(kink.normal, ahead) < 0 ? -b : b;
      corner = Sum(corner, Times(side, kink.normal));
    }
    return corner;
  };
  // Gilbert, Johnson and Keerthi, 1988: towards 0 from corner to corner, of
  // which the nearest face is kept.
  constexpr int kRounds = 200;
  constexpr double kNear = 2e-15;
  Corners corners = {farthest(Times(-1, start))};
  Vector3 nearest = corners[0];
  for (int round = 0; round < kRounds; ++round) {
    const double length = LengthOf(nearest);
    if (length <= kNear * scale) return value;
    const Vector3 corner = farthest(Times(-1, nearest));
    // No corner is nearer than the plane through the point found.
    if (Dot(nearest, Difference(nearest, corner)) <= kNear * scale * length)
      break;
    corners.push_back(corner);
    const Vector3 next = Reduce(corners);
    if (!(LengthOf(next) < length)) break;
    nearest = next;
  }
  return Sum(value, nearest);
}

}  // namespace truelux
