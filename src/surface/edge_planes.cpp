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
    const std::set<Ends> outlines = OutlinesOf(scene_);
    CollectEdges(outlines);
    found_.is_complete = found_.edges_of_line.size() <= most_lines;
    if (found_.is_complete) {
      CollectCuts(outlines);
      found_.is_complete = found_.edges_of_line.size() <= most_lines;
    }
    const std::size_t count = found_.edges_of_line.size();
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

  [[nodiscard]] RationalVector RationalAt(int vertex) const {
    return RationalOf(At(vertex));
  }

  /// The line through a point; new ones are added.
  int LineOf(const PrimitiveVector& along, const RationalVector& point) {
    const PrimitiveVector direction = WithoutSign(along);
    const Key key = {direction, Cross(RationalOf(direction), point)};
    const int next = static_cast<int>(lines_.size());
    const int line = lines_.try_emplace(key, next).first->second;
    if (line == next) {
      found_.edges_of_line.emplace_back();
      found_.cuts_of_line.emplace_back();
    }
    return line;
  }

  void CollectEdges(const std::set<Ends>& outlines) {
    const Vec3<Exact> normal =
        Cross(Displacement<Exact>(surface_[0], surface_[1]),
              Displacement<Exact>(surface_[0], surface_[2]));
    const auto is_level = [&](int vertex) {
      return SignOf(HeightOver(normal, surface_[0], At(vertex))) == Sign::kZero;
    };
    for (const Ends& ends : outlines) {
      StopIfAsked(stop_);
      if (is_level(ends[0]) && is_level(ends[1])) continue;
      const int line =
          LineOf(MakePrimitive(Displacement<Exact>(At(ends[0]), At(ends[1]))),
                 RationalAt(ends[0]));
      found_.edges_of_line[static_cast<std::size_t>(line)].push_back(
          static_cast<int>(found_.edges.size()));
      found_.edges.push_back({ends, line});
    }
  }

  void CollectCuts(const std::set<Ends>& outlines) {
    const RationalVector at = RationalOf(surface_[0]);
    const RationalVector normal =
        Cross(RationalOf(surface_[1]) - at, RationalOf(surface_[2]) - at);
    for (FaceCut& ends : FaceCutsOf(scene_, outlines, stop_)) {
      if (Dot(normal, ends[0] - at) == 0 && Dot(normal, ends[1] - at) == 0)
        continue;
      const int line = LineOf(MakePrimitive(ends[1] - ends[0]), ends[0]);
      found_.cuts_of_line[static_cast<std::size_t>(line)].push_back(
          static_cast<int>(found_.cuts.size()));
      found_.cuts.push_back({std::move(ends), line});
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

  /// Two points of a line.
  [[nodiscard]] FaceCut PointsOf(int line) const {
    const auto index = static_cast<std::size_t>(line);
    if (found_.edges_of_line[index].empty()) {
      const int cut = found_.cuts_of_line[index][0];
      return found_.cuts[static_cast<std::size_t>(cut)].ends;
    }
    const int edge = found_.edges_of_line[index][0];
    const Ends& ends = found_.edges[static_cast<std::size_t>(edge)].ends;
    return {RationalAt(ends[0]), RationalAt(ends[1])};
  }

  /// The same of a line with an edge; null if it has none.
  [[nodiscard]] const Ends* EndsOf(int line) const {
    const auto& edges = found_.edges_of_line[static_cast<std::size_t>(line)];
    if (edges.empty()) return nullptr;
    return &found_.edges[static_cast<std::size_t>(edges[0])].ends;
  }

  /// Adds the plane of two different lines, if they lie in one.
  void AddPair(int i, int j) {
    const Ends* first = EndsOf(i);
    const Ends* second = EndsOf(j);
    if (first != nullptr && second != nullptr) {
      const auto& [a, b] = *first;
      const auto& [c, d] = *second;
      if (AreClearlySkew(At(a), At(b), At(c), At(d))) return;
      const Vec3<Exact> along = Displacement<Exact>(At(a), At(b));
      AddPlaneOf(along, Displacement<Exact>(At(a), At(c)),
                 Displacement<Exact>(At(a), At(d)), RationalAt(a), {i, j});
    } else {
      const auto [a, b] = PointsOf(i);
      const auto [c, d] = PointsOf(j);
      AddPlaneOf<mpq_class>(b - a, c - a, d - a, a, {i, j});
    }
  }

  /// Adds the plane through a point with two lines, one of which goes along
  /// `along`, while the other one has two points, if there is one.
  template <class NT>
  void AddPlaneOf(const Vec3<NT>& along, const Vec3<NT>& to_c,
                  const Vec3<NT>& to_d, const RationalVector& point,
                  const std::array<int, 2>& lines) {
    Vec3<NT> normal = Cross(along, to_c);
    if (Dot(normal, to_d) != 0) return;
    // c may lie on the first line; d then does not.
    if (normal.x == 0 && normal.y == 0 && normal.z == 0)
      normal = Cross(along, to_d);
    const PrimitiveVector n = WithoutSign(MakePrimitive(normal));
    const Key key = {n, {Dot(RationalOf(n), point), 0, 0}};
    planes_[key].insert(lines.begin(), lines.end());
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
  std::map<Key, int> lines_;
  std::map<Key, std::set<int>> planes_;  ///< to the lines in them
};

}  // namespace

EdgePlanes EdgePlanesOf(const Scene& scene,
                        const std::array<Point3, 3>& surface,
                        std::size_t most_lines, const StopFlag* stop) {
  return Finder(scene, surface, stop).Find(most_lines);
}

}  // namespace truelux
