// SPDX-License-Identifier: GPL-3.0-or-later
#include "baselines/scanline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "baselines/scanline_strips.h"
#include "exact/recipe.h"
#include "scene/scene_access.h"
#include "visibility/contour.h"

namespace truelux {
namespace {

using Vec = Vec3<double>;

Vec Between(const Point3& from, const Point3& to) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

Vec Unit(const Vec& a) {
  return 1 / std::sqrt(Dot(a, a)) * a;
}

/// The edges of a facet's triangles that no two of them share.
std::vector<std::array<VertexId, 2>> Boundary(const Scene& scene,
                                              const Facet& facet) {
  std::map<std::pair<VertexId, VertexId>, int> uses;
  for (const Triangle& triangle : TrianglesOf(scene, facet)) {
    const auto corners = CornersOf(triangle);
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId a = corners[k];
      const VertexId b = corners[(k + 1) % 3];
      ++uses[{std::min(a, b), std::max(a, b)}];
    }
  }
  std::vector<std::array<VertexId, 2>> boundary;
  for (const auto& [edge, count_of_uses] : uses) {
    if (count_of_uses == 1) boundary.push_back({edge.first, edge.second});
  }
  return boundary;
}

/// The integral of (a + b x) / (x^2 + d)^2 along a row.
class RowIntegral {
 public:
  RowIntegral(double a, double b, double d)
      : a_(a), b_(b), d_(d), root_(std::sqrt(d)) {}

  [[nodiscard]] double Between(double from, double to) const {
    const double from_square = from * from + d_;
    const double to_square = to * to + d_;
    // One arctangent for the difference of two: the angle is below pi.
    const double angle = std::atan2(root_ * (to - from), d_ + from * to);
    return a_ / (2 * d_) *
               (to / to_square - from / from_square + angle / root_) -
           b_ / 2 * (1 / to_square - 1 / from_square);
  }

 private:
  double a_;
  double b_;
  double d_;
  double root_;
};

/// The shadows on the current row, in the order of their beginnings.
class ActiveShadows {
 public:
  struct Interval {
    double begin = 0;
    double end = 0;
    const Strip* strip = nullptr;
  };

  explicit ActiveShadows(std::vector<Strip>& strips) : strips_(strips) {
    std::ranges::sort(strips_, {}, &Strip::first);
  }

  /// Rows must come in increasing order. The order of the shadows changes
  /// little from row to row, so that insertion sort is quick.
  const std::vector<Interval>& MoveTo(int row, double y) {
    std::erase_if(active_,
                  [row](const Interval& i) { return i.strip->end <= row; });
    for (; next_ < strips_.size() && strips_[next_].first <= row; ++next_) {
      if (strips_[next_].end > row) active_.push_back({0, 0, &strips_[next_]});
    }
    for (std::size_t i = 0; i < active_.size(); ++i) {
      const Strip* strip = active_[i].strip;
      const Interval moved{strip->left.At(y), strip->right.At(y), strip};
      std::size_t at = i;
      for (; at > 0 && active_[at - 1].begin > moved.begin; --at)
        active_[at] = active_[at - 1];
      active_[at] = moved;
    }
    return active_;
  }

 private:
  std::vector<Strip>& strips_;
  std::vector<Interval> active_;
  std::size_t next_ = 0;
};

/// Where the boundary of a source crosses a row, in order.
void FindCrossings(const std::vector<std::array<ShadowPoint, 2>>& boundary,
                   double y, std::vector<double>& crossings) {
  crossings.clear();
  for (const auto& [a, b] : boundary) {
    if ((a.y <= y) == (b.y <= y)) continue;
    crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
  }
  std::ranges::sort(crossings);
}

/// The integral over begin .. end without the shadows.
double IntegrateVisible(const RowIntegral& integral,
                        const std::vector<ActiveShadows::Interval>& shadows,
                        double begin, double end) {
  double sum = 0;
  for (const ActiveShadows::Interval& shadow : shadows) {
    if (shadow.begin >= end || begin >= end) break;
    if (shadow.begin > begin) sum += integral.Between(begin, shadow.begin);
    begin = std::max(begin, shadow.end);
  }
  return begin < end ? sum + integral.Between(begin, end) : sum;
}

/// The part of begin .. end with a + b x > 0.
std::pair<double, double> AboveHorizon(double a, double b, double begin,
                                       double end) {
  if (b > 0) return {std::max(begin, -a / b), end};
  if (b < 0) return {begin, std::min(end, -a / b)};
  return a > 0 ? std::pair{begin, end} : std::pair{0.0, 0.0};
}

}  // namespace

ScanlineQuadrature::ScanlineQuadrature(Scene scene) : scene_(std::move(scene)) {
  const auto vertices = VerticesOf(scene_);
  for (const FacetId id : FacetsOf(scene_).ids()) {
    const Facet& facet = FacetsOf(scene_)[id];
    const Face& face = FacesOf(scene_)[FaceOf(facet)];
    if (face.emission == Rgb{}) continue;
    const auto corners = CornersOf(TrianglesOf(scene_)[FirstTriangleOf(facet)]);
    const Point3 a = vertices[corners[0]];
    Source source;
    source.facet = id;
    source.exitance = face.emission;
    source.u = Unit(Between(a, vertices[corners[1]]));
    source.n = Unit(Cross(source.u, Between(a, vertices[corners[2]])));
    source.v = Cross(source.n, source.u);
    source.origin = a;
    source.boundary = Boundary(scene_, facet);
    sources_.push_back(std::move(source));
  }
}

double ScanlineQuadrature::FormFactor(const Source& source,
                                      const Receiver& receiver,
                                      const IdVector<FacetId, bool>& ignored,
                                      int row_count) const {
  const Point3& r = receiver.position;
  const double h = Dot(source.n, Between(source.origin, r));
  if (!(h > 0)) return 0;
  IdVector<VertexId, ShadowPoint> images;
  images.reserve(scene_.vertices().size());
  for (const Point3& p : scene_.vertices()) {
    const Vec d = Between(r, p);
    images.push_back(
        {Dot(source.u, d), Dot(source.v, d), -Dot(source.n, d) / h});
  }
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Window window{kFar, -kFar, kFar, -kFar};
  std::vector<std::array<ShadowPoint, 2>> boundary;
  for (const auto& edge : source.boundary) {
    boundary.push_back({images[edge[0]], images[edge[1]]});
    for (const ShadowPoint& p : boundary.back()) {
      window.x_low = std::min(window.x_low, p.x);
      window.x_high = std::max(window.x_high, p.x);
      window.y_low = std::min(window.y_low, p.y);
      window.y_high = std::max(window.y_high, p.y);
    }
  }
  const Rows rows{window.y_low, (window.y_high - window.y_low) / row_count,
                  row_count};
  std::vector<Strip> strips;
  for (const Triangle& t : scene_.triangles()) {
    if (FacetOf(t) == source.facet) continue;
    if (!ignored.empty() && ignored[FacetOf(t)]) continue;
    const auto [a, b, c] = CornersOf(t);
    AppendShadow({images[a], images[b], images[c]}, window, rows, strips);
  }
  const Vec n = Unit({receiver.normal.x, receiver.normal.y, receiver.normal.z});
  const double slope = Dot(n, source.u);
  ActiveShadows active(strips);
  std::vector<double> crossings;
  double sum = 0;
  for (int row = 0; row < row_count; ++row) {
    const double y = rows.At(row);
    const double cosine = y * Dot(n, source.v) - h * Dot(n, source.n);
    const RowIntegral integral(cosine, slope, y * y + h * h);
    const auto& shadows = active.MoveTo(row, y);
    FindCrossings(boundary, y, crossings);
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
      const auto [begin, end] =
          AboveHorizon(cosine, slope, crossings[k], crossings[k + 1]);
      sum += IntegrateVisible(integral, shadows, begin, end);
    }
  }
  return sum * rows.step * h / std::numbers::pi;
}

Rgb ScanlineQuadrature::Evaluate(const Receiver& receiver, int rows) const {
  const IdVector<FacetId, bool> ignored = IgnoredFacets({scene_, receiver});
  Rgb sum{};
  for (const Source& source : sources_) {
    if (!ignored.empty() && ignored[source.facet]) continue;
    const double factor = FormFactor(source, receiver, ignored, rows);
    for (std::size_t c = 0; c < sum.size(); ++c)
      sum[c] += source.exitance[c] * factor;
  }
  return sum;
}

}  // namespace truelux
