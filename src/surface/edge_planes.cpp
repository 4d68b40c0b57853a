// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/edge_planes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "base/stop.h"
#include "exact/number.h"
#include "exact/rational.h"
#include "exact/sign.h"
#include "exact/vec3.h"
#include "scene/newell.h"

namespace truelux {
namespace {

using Ends = std::array<int, 2>;

/// Of a line or of a plane: what is equal exactly for equal ones.
struct Key {
  PrimitiveVector direction;
  Vec3<mpq_class> moment;  ///< of a plane: the offset is in x

  friend bool operator<(const Key& a, const Key& b) {
    return std::tie(a.direction, a.moment.x, a.moment.y, a.moment.z) <
           std::tie(b.direction, b.moment.x, b.moment.y, b.moment.z);
  }
};

RationalVector RationalOf(const PrimitiveVector& v) {
  return {mpq_class(v.x), mpq_class(v.y), mpq_class(v.z)};
}

Vec3<double> DifferenceOf(const Point3& from, const Point3& to) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

double SizeOf(const Vec3<double>& v) {
  return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z);
}

/// The edges of the outlines of all facets, each once. A face that is not
/// planar is a facet for each of its triangles.
std::set<Ends> OutlinesOf(const Scene& scene) {
  std::set<Ends> outlines;
  const auto add = [&outlines](int a, int b) {
    if (a != b) outlines.insert({std::min(a, b), std::max(a, b)});
  };
  for (const Face& face : scene.faces()) {
    const auto facets =
        scene.facets().subspan(static_cast<std::size_t>(face.first_facet),
                               static_cast<std::size_t>(face.facet_count));
    const auto fronts = std::ranges::count_if(
        facets, [](const Facet& f) { return !f.is_back; });
    if (fronts == 1) {
      const auto ring =
          scene.corners().subspan(static_cast<std::size_t>(face.first_corner),
                                  static_cast<std::size_t>(face.corner_count));
      for (std::size_t k = 0; k < ring.size(); ++k)
        add(ring[k], ring[(k + 1) % ring.size()]);
      continue;
    }
    for (const Facet& facet : facets) {
      for (const Triangle& t : scene.triangles().subspan(
               static_cast<std::size_t>(facet.first_triangle),
               static_cast<std::size_t>(facet.triangle_count))) {
        for (std::size_t k = 0; k < 3; ++k)
          add(t.vertices[k], t.vertices[(k + 1) % 3]);
      }
    }
  }
  return outlines;
}

class Finder {
 public:
  Finder(const Scene& scene, const std::array<Point3, 3>& surface,
         const StopFlag* stop)
      : scene_(scene), surface_(surface), stop_(stop) {}

  EdgePlanes Find(std::size_t most_lines) {
    CollectLines();
    const std::size_t count = found_.edges_of_line.size();
    found_.is_complete = count <= most_lines;
    if (found_.is_complete) {
      for (std::size_t i = 0; i < count; ++i) {
        StopIfAsked(stop_);
        for (std::size_t j = i + 1; j < count; ++j)
          AddPair(static_cast<int>(i), static_cast<int>(j));
      }
    } else {
      AddPairsAtVertices();
    }
    for (auto& [key, lines] : planes_) {
      found_.planes.push_back(
          {key.direction, key.moment.x, {lines.begin(), lines.end()}});
    }
    return std::move(found_);
  }

 private:
  [[nodiscard]] const Point3& At(int vertex) const {
    return scene_.vertices()[static_cast<std::size_t>(vertex)];
  }

  void CollectLines() {
    const Vec3<Exact> normal =
        Cross(Displacement<Exact>(surface_[0], surface_[1]),
              Displacement<Exact>(surface_[0], surface_[2]));
    const auto is_level = [&](int vertex) {
      return SignOf(HeightOver(normal, surface_[0], At(vertex))) == Sign::kZero;
    };
    std::map<Key, int> lines;
    for (const Ends& ends : OutlinesOf(scene_)) {
      StopIfAsked(stop_);
      if (is_level(ends[0]) && is_level(ends[1])) continue;
      const PrimitiveVector along = WithoutSign(
          MakePrimitive(Displacement<Exact>(At(ends[0]), At(ends[1]))));
      const Key key = {
          along, Cross(RationalOf(along), truelux::RationalOf(At(ends[0])))};
      const int next = static_cast<int>(lines.size());
      const int line = lines.try_emplace(key, next).first->second;
      if (line == next) found_.edges_of_line.emplace_back();
      found_.edges_of_line[static_cast<std::size_t>(line)].push_back(
          static_cast<int>(found_.edges.size()));
      found_.edges.push_back({ends, line});
    }
  }

  void AddPairsAtVertices() {
    std::map<int, std::set<int>> lines_at;
    for (const SceneEdge& edge : found_.edges) {
      for (const int end : edge.ends)
        lines_at[end].insert(edge.line);
    }
    for (const auto& [vertex, lines] : lines_at) {
      StopIfAsked(stop_);
      for (auto i = lines.begin(); i != lines.end(); ++i) {
        for (auto j = std::next(i); j != lines.end(); ++j)
          AddPair(*i, *j);
      }
    }
  }

  [[nodiscard]] const Ends& EndsOf(int line) const {
    const int edge = found_.edges_of_line[static_cast<std::size_t>(line)][0];
    return found_.edges[static_cast<std::size_t>(edge)].ends;
  }

  /// Adds the plane of two different lines, if they lie in one.
  void AddPair(int i, int j) {
    const auto& [a, b] = EndsOf(i);
    const auto& [c, d] = EndsOf(j);
    if (AreClearlySkew(At(a), At(b), At(c), At(d))) return;
    const Vec3<Exact> along = Displacement<Exact>(At(a), At(b));
    const Vec3<Exact> to_c = Displacement<Exact>(At(a), At(c));
    const Vec3<Exact> to_d = Displacement<Exact>(At(a), At(d));
    Vec3<Exact> normal = Cross(along, to_c);
    if (SignOf(Dot(normal, to_d)) != Sign::kZero) return;
    // c may lie on the first line; d then does not.
    if (IsZero(normal)) normal = Cross(along, to_d);
    const PrimitiveVector n = WithoutSign(MakePrimitive(normal));
    const Key key = {n, {Dot(RationalOf(n), truelux::RationalOf(At(a))), 0, 0}};
    planes_[key].insert({i, j});
  }

  /// Whether double arithmetic proves that four points lie in no plane: its
  /// error is far below 2^-44 of the product of the sizes.
  static bool AreClearlySkew(const Point3& a, const Point3& b, const Point3& c,
                             const Point3& d) {
    const Vec3<double> u = DifferenceOf(a, b);
    const Vec3<double> v = DifferenceOf(a, c);
    const Vec3<double> w = DifferenceOf(a, d);
    const double volume = std::fabs(Determinant(u, v, w));
    const double size = SizeOf(u) * SizeOf(v) * SizeOf(w);
    return std::isfinite(size) && volume > 0x1p-44 * size && volume > 0x1p-900;
  }

  const Scene& scene_;
  const std::array<Point3, 3>& surface_;
  const StopFlag* stop_;  ///< may be null
  EdgePlanes found_;
  std::map<Key, std::set<int>> planes_;  ///< to the lines in them
};

}  // namespace

EdgePlanes EdgePlanesOf(const Scene& scene,
                        const std::array<Point3, 3>& surface,
                        std::size_t most_lines, const StopFlag* stop) {
  return Finder(scene, surface, stop).Find(most_lines);
}

}  // namespace truelux
