// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/surface_lines.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>

#include "base/stop.h"
#include "scene/scene_access.h"
#include "surface/kink_pieces.h"
#include "surface/surface_clip.h"

namespace truelux {
namespace {

/// Heights of a triangle's corners over the lit side of a surface.
struct Standing {
  std::array<RationalVector, 3> corners;
  std::array<mpq_class, 3> heights;

  [[nodiscard]] bool ReachesAbove() const {
    return std::ranges::any_of(heights, [](const auto& h) { return h > 0; });
  }

  /// The points of the outline at height 0, each once.
  [[nodiscard]] std::vector<RationalVector> Feet() const {
    std::vector<RationalVector> feet;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      if (heights[k] == 0) feet.push_back(corners[k]);
      if (sgn(heights[k]) * sgn(heights[next]) < 0) {
        const mpq_class share = heights[k] / (heights[k] - heights[next]);
        feet.push_back(corners[k] + share * (corners[next] - corners[k]));
      }
    }
    return feet;
  }
};

bool IsBefore(const RationalVector& a, const RationalVector& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

bool IsSame(const ExactSegment& a, const ExactSegment& b) {
  const auto equal = [](const RationalVector& p, const RationalVector& q) {
    return p.x == q.x && p.y == q.y && p.z == q.z;
  };
  return equal(a.from, b.from) && equal(a.to, b.to);
}

}  // namespace

std::vector<int> FacesOfSide(const SurfaceFrame& frame, bool is_reverse) {
  std::vector<int> faces;
  for (const int face : frame.faces) {
    const bool looks_back = std::ranges::binary_search(frame.reversed, face);
    if (looks_back == is_reverse) faces.push_back(face);
  }
  return faces;
}

std::vector<std::array<int, 2>> OutlineOf(const Scene& scene,
                                          std::span<const int> faces) {
  std::map<std::array<int, 2>, int> sides;
  for (const int face : faces) {
    const Face& f = scene.faces()[static_cast<std::size_t>(face)];
    for (const Facet& facet :
         scene.facets().subspan(static_cast<std::size_t>(f.first_facet),
                                static_cast<std::size_t>(f.facet_count))) {
      if (facet.is_back) continue;
      for (const Triangle& triangle : TrianglesOf(scene, facet)) {
        for (std::size_t k = 0; k < 3; ++k) {
          const int a = triangle.vertices[k];
          const int b = triangle.vertices[(k + 1) % 3];
          ++sides[{std::min(a, b), std::max(a, b)}];
        }
      }
    }
  }
  std::vector<std::array<int, 2>> outline;
  for (const auto& [ends, count] : sides) {
    if (count == 1) outline.push_back(ends);
  }
  return outline;
}

std::array<Point3, 3> CornersOfSurface(const Scene& scene,
                                       const SurfaceFrame& frame) {
  const Face& face =
      scene.faces()[static_cast<std::size_t>(frame.faces.front())];
  const Facet& facet =
      scene.facets()[static_cast<std::size_t>(face.first_facet)];
  const Triangle& triangle =
      scene.triangles()[static_cast<std::size_t>(facet.first_triangle)];
  std::array<Point3, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    corners[k] =
        scene.vertices()[static_cast<std::size_t>(triangle.vertices[k])];
  }
  return corners;
}

std::vector<ExactSurfaceLine> JumpLinesOf(const Scene& scene,
                                          const SurfaceFrame& frame,
                                          std::span<const int> faces,
                                          bool is_reverse,
                                          const StopFlag* stop) {
  // The first face looks to the side to which its corners turn left; where it
  // begins with a corner that turns right, u x v points the other way.
  const std::array<Point3, 3> surface = CornersOfSurface(scene, frame);
  const RationalVector base = RationalOf(surface[0]);
  RationalVector up =
      Cross(RationalOf(surface[1]) - base, RationalOf(surface[2]) - base);
  if (is_reverse) up = -up;
  const SurfaceClip clip(scene, frame, faces);
  std::vector<std::pair<ExactSegment, std::vector<int>>> found;
  for (const Triangle& triangle : scene.triangles()) {
    StopIfAsked(stop);
    Standing standing;
    for (std::size_t k = 0; k < 3; ++k) {
      standing.corners[k] = RationalOf(
          scene.vertices()[static_cast<std::size_t>(triangle.vertices[k])]);
      standing.heights[k] = Dot(up, standing.corners[k] - base);
    }
    if (!standing.ReachesAbove()) continue;
    std::vector<RationalVector> feet = standing.Feet();
    if (feet.size() != 2) continue;
    if (IsBefore(feet[1], feet[0])) std::swap(feet[0], feet[1]);
    const Facet& facet =
        scene.facets()[static_cast<std::size_t>(triangle.facet)];
    for (ExactSegment& part : clip.PartsOf({feet[0], feet[1]})) {
      const auto same = std::ranges::find_if(
          found, [&](const auto& f) { return IsSame(f.first, part); });
      auto& entry =
          same != found.end()
              ? *same
              : found.emplace_back(std::move(part), std::vector<int>());
      if (std::ranges::find(entry.second, facet.face + 1) ==
          entry.second.end()) {
        entry.second.push_back(facet.face + 1);
      }
    }
  }
  std::vector<ExactSurfaceLine> lines;
  for (auto& [segment, numbers] : found) {
    ExactSurfaceLine& line = lines.emplace_back();
    line.from = segment.from;
    line.to = segment.to;
    line.is_jump = true;
    line.faces = std::move(numbers);
  }
  return lines;
}

ExactSurfaceLines SurfaceLinesOf(const Scene& scene, const SurfaceFrame& frame,
                                 const EdgePlanes& planes, bool is_reverse,
                                 const StopFlag* stop) {
  const std::vector<int> faces = FacesOfSide(frame, is_reverse);
  ExactSurfaceLines all;
  all.is_complete = planes.is_complete;
  all.lines = JumpLinesOf(scene, frame, faces, is_reverse, stop);
  const SurfaceClip clip(scene, frame, faces);
  for (std::size_t i = 0; i < planes.planes.size(); ++i) {
    StopIfAsked(stop);
    const EdgePlane& plane = planes.planes[i];
    for (const ExactSegment& trace :
         clip.TraceOf(RationalOf(plane.normal), plane.offset)) {
      for (const ExactSegment& part : clip.PartsOf(trace)) {
        for (KinkPiece& kink : KinkPiecesOf(scene, frame, planes, i, part.from,
                                            part.to, is_reverse, stop)) {
          ExactSurfaceLine& line = all.lines.emplace_back();
          line.from = std::move(kink.from);
          line.to = std::move(kink.to);
          line.size = kink.size;
          line.faces = std::move(kink.faces);
          line.edges = std::move(kink.edges);
        }
      }
    }
  }
  return all;
}

}  // namespace truelux
