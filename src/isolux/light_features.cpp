// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/light_features.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <tuple>
#include <utility>

#include "isolux/lamp_pieces.h"
#include "isolux/line_cover.h"
#include "scene/facet_normal.h"
#include "scene/index/convex_pieces.h"
#include "scene/index/scene_index.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

using Ends = std::array<int, 2>;

/// The facets beside each edge. Inner edges of a facet are not there.
std::map<Ends, std::vector<FacetSide>> SidesOf(const Scene& scene) {
  std::map<Ends, std::vector<FacetSide>> sides;
  for (std::size_t i = 0; i < scene.facets().size(); ++i) {
    const Facet& facet = scene.facets()[i];
    if (facet.is_back) continue;
    std::map<Ends, std::vector<bool>> own;
    for (const Triangle& triangle : TrianglesOf(scene, facet)) {
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = triangle.vertices[k];
        const int b = triangle.vertices[(k + 1) % 3];
        own[{std::min(a, b), std::max(a, b)}].push_back(a < b);
      }
    }
    for (const auto& [ends, senses] : own) {
      if (senses.size() == 1)
        sides[ends].push_back({static_cast<int>(i), senses.front()});
    }
  }
  return sides;
}

LightPlane PlaneOf(const Scene& scene, const PlanFrame& frame, int facet) {
  const Vector3 n = FacetNormal(scene, facet);
  const double length = std::hypot(n.x, n.y, n.z);
  LightPlane plane;
  plane.normal = frame.DirectionOf({n.x / length, n.y / length, n.z / length});
  const Facet& f = scene.facets()[static_cast<std::size_t>(facet)];
  const Triangle& triangle =
      scene.triangles()[static_cast<std::size_t>(f.first_triangle)];
  plane.offset = Dot(
      plane.normal,
      frame.PlaceOf(
          scene.vertices()[static_cast<std::size_t>(triangle.vertices[0])]));
  return plane;
}

/// A few points whose hull holds all points of a plane: they themselves, each
/// once, or the corners of a rectangle around them.
std::vector<Vec3<double>> HullOf(const Vec3<double>& normal,
                                 std::vector<Vec3<double>> points) {
  constexpr std::size_t kMostPoints = 8;
  const auto name = [](const Vec3<double>& p) {
    return std::tie(p.x, p.y, p.z);
  };
  std::ranges::sort(points, [&](const Vec3<double>& a, const Vec3<double>& b) {
    return name(a) < name(b);
  });
  const auto rest = std::ranges::unique(
      points, [&](const Vec3<double>& a, const Vec3<double>& b) {
        return name(a) == name(b);
      });
  points.erase(rest.begin(), rest.end());
  if (points.size() <= kMostPoints) return points;
  const Vec3<double> axis =
      std::fabs(normal.x) < 0.5 ? Vec3<double>{1, 0, 0} : Vec3<double>{0, 1, 0};
  const Vec3<double> u = UnitOf(axis - Dot(axis, normal) * normal);
  const Vec3<double> v = Cross(normal, u);
  std::array<double, 2> least = {HUGE_VAL, HUGE_VAL};
  std::array<double, 2> most = {-HUGE_VAL, -HUGE_VAL};
  for (const Vec3<double>& p : points) {
    const std::array<double, 2> at = {Dot(p, u), Dot(p, v)};
    for (std::size_t k = 0; k < 2; ++k) {
      least[k] = std::min(least[k], at[k]);
      most[k] = std::max(most[k], at[k]);
    }
  }
  const Vec3<double> base = Dot(points[0], normal) * normal;
  return {base + least[0] * u + least[1] * v, base + most[0] * u + least[1] * v,
          base + most[0] * u + most[1] * v, base + least[0] * u + most[1] * v};
}

/// The point of a segment at height 0. The heights of its ends differ in sign.
Vec3<double> FootOf(const Vec3<double>& low, const Vec3<double>& high) {
  const double share = -low.z / (high.z - low.z);
  Vec3<double> foot = low + share * (high - low);
  foot.z = 0;
  return foot;
}

}  // namespace

LightFeatures::LightFeatures(const Scene& scene, const PlanFrame& frame,
                             const EdgePlanes& planes, Emission emission,
                             const Rgb& weights) {
  for (const Point3& vertex : scene.vertices()) {
    const Vec3<double> p = frame.PlaceOf(vertex);
    size_ = std::max({size_, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }
  AddLamps(scene, frame, emission, weights);
  AddEdges(scene, frame, planes);
  AddBlockers(scene, frame);
  FindCoplanarLines(planes);
}

void LightFeatures::AddLamps(const Scene& scene, const PlanFrame& frame,
                             Emission emission, const Rgb& weights) {
  for (std::size_t i = 0; i < scene.facets().size(); ++i) {
    const Facet& facet = scene.facets()[i];
    const Rgb& m = scene.faces()[static_cast<std::size_t>(facet.face)].emission;
    Lamp lamp;
    lamp.exitance = weights[0] * m[0] + weights[1] * m[1] + weights[2] * m[2];
    if (emission == Emission::kRadiance) lamp.exitance *= std::numbers::pi;
    if (!(lamp.exitance > 0)) continue;
    lamp.plane = PlaneOf(scene, frame, static_cast<int>(i));
    for (const Triangle& triangle : TrianglesOf(scene, facet)) {
      std::array<Vec3<double>, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) {
        corners[k] = frame.PlaceOf(
            scene.vertices()[static_cast<std::size_t>(triangle.vertices[k])]);
      }
      if (std::ranges::all_of(corners, [&](const Vec3<double>& c) {
            return c.z <= 0x1p-40 * size_;
          })) {
        continue;
      }
      lamp.hull.insert(lamp.hull.end(), corners.begin(), corners.end());
      lamp.triangles.push_back(corners);
    }
    if (lamp.triangles.empty()) continue;
    lamp.hull = HullOf(lamp.plane.normal, std::move(lamp.hull));
    lamps_.push_back(std::move(lamp));
  }
}

void LightFeatures::AddEdges(const Scene& scene, const PlanFrame& frame,
                             const EdgePlanes& planes) {
  const auto sides = SidesOf(scene);
  for (std::size_t i = 0; i < planes.edges_of_line.size(); ++i) {
    LineCover cover(scene);
    for (const int edge : planes.edges_of_line[i]) {
      const Ends& ends = planes.edges[static_cast<std::size_t>(edge)].ends;
      if (const auto found = sides.find(ends); found != sides.end())
        cover.Add(ends, found->second);
    }
    for (const LinePiece& piece : cover.Pieces())
      AddEdge(scene, frame, piece, static_cast<int>(i));
  }
  for (const SceneCut& cut : planes.cuts) {
    LightEdge edge;
    edge.line = cut.line;
    for (std::size_t k = 0; k < 2; ++k) {
      const RationalVector& end = cut.ends[k];
      edge.ends[k] =
          frame.PlaceOf({NearestTo(end.x), NearestTo(end.y), NearestTo(end.z)});
    }
    AddAboveSurface(edge);
  }
}

void LightFeatures::AddAboveSurface(LightEdge edge) {
  auto& [a, b] = edge.ends;
  for (Vec3<double>& end : edge.ends) {
    if (std::fabs(end.z) <= 0x1p-48 * size_) end.z = 0;
  }
  if (a.z <= 0 && b.z <= 0) return;
  if (a.z < 0) a = FootOf(a, b);
  if (b.z < 0) b = FootOf(b, a);
  edges_.push_back(edge);
}

void LightFeatures::AddEdge(const Scene& scene, const PlanFrame& frame,
                            const LinePiece& piece, int line) {
  LightEdge edge;
  edge.line = line;
  for (std::size_t k = 0; k < 2; ++k) {
    edge.ends[k] = frame.PlaceOf(
        scene.vertices()[static_cast<std::size_t>(piece.ends[k])]);
  }
  if (piece.facets.size() == 2) {
    const FacetSide& one = piece.facets[0];
    const FacetSide& other = piece.facets[1];
    edge.has_two_facets = true;
    edge.planes = {PlaneOf(scene, frame, one.facet),
                   PlaneOf(scene, frame, other.facet)};
    if (one.is_forward == other.is_forward) {
      // The facets look to opposite sides of what they bound together.
      edge.planes[1].normal = -edge.planes[1].normal;
      edge.planes[1].offset = -edge.planes[1].offset;
    }
  }
  AddAboveSurface(edge);
}

void LightFeatures::AddBlockers(const Scene& scene, const PlanFrame& frame) {
  const ConvexPieces& pieces = SceneIndex::Of(scene).pieces();
  for (const Piece& piece : pieces.pieces()) {
    if (scene.facets()[static_cast<std::size_t>(piece.facet.value())].is_back)
      continue;
    Blocker blocker;
    double high = 0;
    for (const VertexId vertex : pieces.CornersOf(piece)) {
      blocker.corners.push_back(frame.PlaceOf(
          scene.vertices()[static_cast<std::size_t>(vertex.value())]));
      high = std::max(high, blocker.corners.back().z);
    }
    if (high <= 0x1p-40 * size_) continue;
    blocker.plane = PlaneOf(scene, frame, piece.facet.value());
    blockers_.push_back(std::move(blocker));
  }
}

void LightFeatures::FindCoplanarLines(const EdgePlanes& planes) {
  coplanar_.resize(planes.edges_of_line.size());
  for (std::size_t i = 0; i < coplanar_.size(); ++i)
    coplanar_[i].push_back(static_cast<int>(i));
  for (const EdgePlane& plane : planes.planes) {
    for (const int i : plane.lines) {
      auto& own = coplanar_[static_cast<std::size_t>(i)];
      own.insert(own.end(), plane.lines.begin(), plane.lines.end());
    }
  }
  for (std::vector<int>& own : coplanar_) {
    std::ranges::sort(own);
    const auto rest = std::ranges::unique(own);
    own.erase(rest.begin(), rest.end());
  }
}

}  // namespace truelux
