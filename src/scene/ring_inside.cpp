// SPDX-License-Identifier: GPL-3.0-or-later
// The ring's edges are cut at its points, and pieces that are run through as
// often forward as backward (bridges) are taken out. The numbers on the two
// sides of a piece differ by how often it is run through: more than once is
// kOther, and so is a crossing of two pieces: around it the numbers take at
// least three values, unless a third piece crosses there (see the header). What remains is a plane graph whose edges have 1 more on
// their left than on their right; one look at each tells which numbers.
#include "scene/ring_inside.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "exact/rounding.h"
#include "exact/sign.h"

namespace truelux {
namespace {

/// A piece of an edge of the ring, from one of its points to another.
struct BoundaryStep {
  int from = 0;
  int to = 0;
};

/// The pieces of a ring's image.
class RingSteps {
 public:
  explicit RingSteps(const ProjectedRing& ring) : ring_(ring) {
    NamePoints();
    for (int i = 0; i < ring_.size(); ++i)
      CutEdge(i, i + 1 < ring_.size() ? i + 1 : 0);
  }

  /// The pieces that are not run through as often backward as forward, each
  /// once, in its sense. False if one is run through more than once.
  [[nodiscard]] bool Boundary(std::vector<BoundaryStep>& boundary) const {
    for (const auto& [ends, net] : net_) {
      if (net > 1 || net < -1) return false;
      if (net == 1) boundary.push_back({ends.first, ends.second});
      if (net == -1) boundary.push_back({ends.second, ends.first});
    }
    return true;
  }

 private:
  /// Points that coincide get the name of the first of them.
  void NamePoints() {
    const auto n = static_cast<std::size_t>(ring_.size());
    std::vector<int> sorted(n);
    std::iota(sorted.begin(), sorted.end(), 0);
    std::ranges::sort(sorted, [this](int i, int j) {
      const Sign order = ring_.Order(i, j);
      return order == Sign::kZero ? i < j : order == Sign::kPositive;
    });
    name_.resize(n);
    for (std::size_t k = 0; k < n; ++k) {
      const bool same =
          k > 0 && ring_.Order(sorted[k - 1], sorted[k]) == Sign::kZero;
      name_[static_cast<std::size_t>(sorted[k])] =
          same ? name_[static_cast<std::size_t>(sorted[k - 1])] : sorted[k];
    }
  }

  [[nodiscard]] int NameOf(int i) const {
    return name_[static_cast<std::size_t>(i)];
  }

  /// Whether point k lies on the edge from i to j, but not at its ends.
  [[nodiscard]] bool IsInside(int i, int j, int k) const {
    return !ring_.SurelyApart(i, j, k, k) &&
           ring_.Orientation(i, j, k) == Sign::kZero &&
           ring_.Order(i, k) * ring_.Order(k, j) == Sign::kPositive;
  }

  /// Counts the pieces of the edge from i to j.
  void CutEdge(int i, int j) {
    if (NameOf(i) == NameOf(j)) return;  // not in space, but in the image
    std::vector<int> between;
    for (int k = 0; k < ring_.size(); ++k) {
      if (NameOf(k) == k && IsInside(i, j, k)) between.push_back(k);
    }
    const Sign sense = ring_.Order(i, j);
    std::ranges::sort(between,
                      [&](int a, int b) { return ring_.Order(a, b) == sense; });
    int from = NameOf(i);
    for (const int to : between)
      Count(std::exchange(from, to), to);
    Count(from, NameOf(j));
  }

  void Count(int from, int to) {
    net_[std::minmax(from, to)] += from < to ? 1 : -1;
  }

  const ProjectedRing& ring_;
  std::vector<int> name_;
  /// By its ends, how often a piece is run through from the lower one, less
  /// how often backward. (Not a list of all passages: there can be n^2.)
  std::map<std::pair<int, int>, int> net_;
};

/// Whether two pieces cross in a point that is an end of neither.
bool Cross(const ProjectedRing& ring, const BoundaryStep& a,
           const BoundaryStep& b) {
  if (ring.SurelyApart(a.from, a.to, b.from, b.to)) return false;
  const auto parts = [&ring](const BoundaryStep& line,
                             const BoundaryStep& ends) {
    return ring.Orientation(line.from, line.to, ends.from) *
               ring.Orientation(line.from, line.to, ends.to) ==
           Sign::kNegative;
  };
  return parts(a, b) && parts(b, a);
}

bool AnyCross(const ProjectedRing& ring,
              const std::vector<BoundaryStep>& boundary) {
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    for (std::size_t k = i + 1; k < boundary.size(); ++k) {
      if (Cross(ring, boundary[i], boundary[k])) return true;
    }
  }
  return false;
}

/// The winding number of the points just to the left of a piece's middle M.
///
/// It is the number of pieces that a ray from there along +u meets, those that
/// rise (in v) less those that fall. The ray starts a little above M, so that
/// it meets no end; of the piece itself it meets nothing if the left is on the
/// side of +u, and the piece, rising, if it is not. A level piece going along
/// +u has its left above; one going along -u has its right there.
int WindingLeftOf(const ProjectedRing& ring,
                  const std::vector<BoundaryStep>& boundary, std::size_t own) {
  const auto& [a, b] = boundary[own];
  int winding = 0;
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    if (i == own) continue;
    const auto& [c, d] = boundary[i];
    const bool from_below = ring.MiddleAbove(a, b, c) != Sign::kNegative;
    const bool to_below = ring.MiddleAbove(a, b, d) != Sign::kNegative;
    if (from_below == to_below) continue;
    const Sign side = ring.MiddleSide(c, d, a, b);
    if (from_below && side == Sign::kPositive) ++winding;
    if (to_below && side == Sign::kNegative) --winding;
  }
  const Sign rise = ring.Rise(a, b);
  const bool left_is_right =
      rise == Sign::kPositive ||
      (rise == Sign::kZero && ring.Order(a, b) == Sign::kNegative);
  return winding + (left_is_right ? 1 : 0);
}

}  // namespace

RingInside FindInside(const ProjectedRing& ring) {
  assert(IsRoundingUpward());
  std::vector<BoundaryStep> boundary;
  if (!RingSteps(ring).Boundary(boundary)) return RingInside::kOther;
  if (boundary.empty()) return RingInside::kNothing;
  if (AnyCross(ring, boundary)) return RingInside::kOther;
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    if (WindingLeftOf(ring, boundary, i) != 1) return RingInside::kOther;
  }
  return RingInside::kOnce;
}

}  // namespace truelux
