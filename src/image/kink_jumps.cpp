// SPDX-License-Identifier: GPL-3.0-or-later
#include "image/kink_jumps.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <gmpxx.h>

#include "truelux/derivatives.h"

#include "exact/rational.h"
#include "image/surface_trace.h"
#include "run/parallel.h"
#include "run/progress.h"
#include "scene/emitters.h"
#include "surface/edge_planes.h"
#include "surface/plane_sight.h"
#include "surface/surface_lines.h"

namespace truelux {
namespace {

using Step = SurfaceTrace::Step;

/// A place of a trace at which the gradient is to be measured.
struct Crossing {
  Step step;
  std::array<Receiver, 2> sides;  ///< on both sides of the trace
};

/// A step aside of 2^-20 pixels, or more if coordinates are too coarse for it:
/// rounding moves a point by less than a 64th of the step.
mpq_class AsideFor(const PixelPlane& pixels) {
  constexpr int kFine = 20;
  constexpr int kRoundingBits = 6;
  const int bits = std::clamp(pixels.BitsPerPixel() - kRoundingBits, 2, kFine);
  return {1, static_cast<unsigned long>(1) << static_cast<unsigned>(bits)};
}

std::vector<SourceTriangle> SourcesOf(const Scene& scene) {
  std::vector<SourceTriangle> sources;
  for (const int face : EmittersOf(scene)) {
    const Face& f = scene.faces()[static_cast<std::size_t>(face)];
    for (const Facet& facet :
         scene.facets().subspan(static_cast<std::size_t>(f.first_facet),
                                static_cast<std::size_t>(f.facet_count))) {
      for (const Triangle& t : scene.triangles().subspan(
               static_cast<std::size_t>(facet.first_triangle),
               static_cast<std::size_t>(facet.triangle_count))) {
        SourceTriangle& source = sources.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
          source[k] = scene.vertices()[static_cast<std::size_t>(t.vertices[k])];
        }
      }
    }
  }
  return sources;
}

/// A point with rounded coordinates.
Point3 NearPointOf(const RationalVector& p) {
  return {NearestTo(p.x), NearestTo(p.y), NearestTo(p.z)};
}

class CrossingFinder {
 public:
  CrossingFinder(const Scene& scene, const SurfaceFrame& frame,
                 const PixelReceivers& receivers, const Watch& watch)
      : scene_(scene),
        receivers_(receivers),
        pixels_(scene, frame, receivers.width(), receivers.height()),
        aside_(AsideFor(pixels_)),
        at_(CornersOfSurface(scene, frame)[0]),
        sources_(SourcesOf(scene)),
        watch_(watch),
        found_(EdgePlanesOf(scene, CornersOfSurface(scene, frame),
                            kMostEdgeLines, watch.stop)) {}

  [[nodiscard]] bool is_complete() const { return found_.is_complete; }

  /// Of all planes; nothing if there are more than pixels.
  std::optional<std::vector<Crossing>> Find(int threads) {
    std::vector<std::vector<Crossing>> by_plane(found_.planes.size());
    std::atomic<std::size_t> count = 0;
    const std::size_t most = static_cast<std::size_t>(pixels_.width()) *
                             static_cast<std::size_t>(pixels_.height());
    Progress progress(by_plane.size(), "planes", watch_);
    ForEachInParallel(by_plane.size(), threads, progress, [&](std::size_t i) {
      if (count > most) return;
      by_plane[i] = CrossingsOf(found_.planes[i]);
      count += by_plane[i].size();
    });
    if (count > most) return std::nullopt;
    std::vector<Crossing> all;
    for (const std::vector<Crossing>& crossings : by_plane)
      all.insert(all.end(), crossings.begin(), crossings.end());
    return all;
  }

 private:
  [[nodiscard]] std::vector<PlaneEdge> EdgesIn(const EdgePlane& plane) const {
    std::vector<PlaneEdge> edges;
    for (const int line : plane.lines) {
      for (const int index :
           found_.edges_of_line[static_cast<std::size_t>(line)]) {
        const auto& ends = found_.edges[static_cast<std::size_t>(index)].ends;
        const auto at = [this](int vertex) {
          return scene_.vertices()[static_cast<std::size_t>(vertex)];
        };
        edges.push_back({{at(ends[0]), at(ends[1])}, line});
      }
      for (const int index :
           found_.cuts_of_line[static_cast<std::size_t>(line)]) {
        const auto& [from, to] =
            found_.cuts[static_cast<std::size_t>(index)].ends;
        edges.push_back({{NearPointOf(from), NearPointOf(to)}, line});
      }
    }
    return edges;
  }

  [[nodiscard]] std::vector<Crossing> CrossingsOf(
      const EdgePlane& plane) const {
    const RationalVector normal = {mpq_class(plane.normal.x),
                                   mpq_class(plane.normal.y),
                                   mpq_class(plane.normal.z)};
    const auto trace = SurfaceTrace::Of(pixels_, normal, plane.offset);
    if (!trace) return {};
    const std::vector<Step> steps = trace->Steps();
    if (steps.empty()) return {};
    const std::vector<PlaneEdge> edges = EdgesIn(plane);
    const Vector3 n = ToDouble(plane.normal);
    // Faces of a surface may look to either side.
    std::optional<PlaneSight> sight;
    Vector3 up;
    std::vector<Crossing> crossings;
    for (const Step& step : steps) {
      const auto receiver = receivers_.At(step.x, step.y);
      if (!receiver) continue;
      if (!sight || !(receiver->normal == up)) {
        up = receiver->normal;
        sight.emplace(edges, sources_, Vec3<double>{n.x, n.y, n.z},
                      Vec3<double>{up.x, up.y, up.z}, at_);
      }
      if (!sight->MayHaveKinkAt(
              pixels_.NearPointAt(step.near_x, step.near_y))) {
        continue;
      }
      if (const auto sides = SidesOf(*trace, step, *receiver))
        crossings.push_back({step, *sides});
    }
    return crossings;
  }

  /// Nothing if one of them is off the surface.
  [[nodiscard]] std::optional<std::array<Receiver, 2>> SidesOf(
      const SurfaceTrace& trace, const Step& step,
      const Receiver& receiver) const {
    std::array<Receiver, 2> sides = {receiver, receiver};
    for (std::size_t k = 0; k < 2; ++k) {
      const auto [x, y] = trace.At(step, k == 0 ? mpq_class(-aside_) : aside_);
      if (!pixels_.Covers(x.get_d(), y.get_d())) return std::nullopt;
      sides[k].position = pixels_.PointAt(x, y);
    }
    return sides;
  }

  const Scene& scene_;
  const PixelReceivers& receivers_;
  PixelPlane pixels_;
  mpq_class aside_;
  Point3 at_;
  std::vector<SourceTriangle> sources_;
  const Watch& watch_;
  EdgePlanes found_;
};

double SizeOf(const Vector3& v) {
  return std::hypot(v.x, v.y, v.z);
}

double LengthBetween(const Point3& a, const Point3& b) {
  return SizeOf({b.x - a.x, b.y - a.y, b.z - a.z});
}

/// The length of the jump from one side to the other; 0 if E jumps there.
Rgb JumpAt(const Oracle& oracle, const Crossing& crossing) {
  std::array<Derivatives, 2> sides;
  oracle.Derivatives(crossing.sides, {.sphere = false, .jacobian = false},
                     [&](std::size_t i, const Derivatives& derivatives) {
                       sides[i] = derivatives;
                     });
  Rgb jump{};
  for (const Derivatives& side : sides) {
    if (side.smoothness == Smoothness::kDiscontinuous) return jump;
  }
  const double apart =
      LengthBetween(crossing.sides[0].position, crossing.sides[1].position);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& [a, b] = sides;
    const Vector3& slope_a = a.channels[k].tangential;
    const Vector3& slope_b = b.channels[k].tangential;
    const double steepest = std::max(SizeOf(slope_a), SizeOf(slope_b));
    const double e_a = a.irradiance.value[k];
    const double e_b = b.irradiance.value[k];
    // Twice what the slopes explain, and rounding.
    if (std::fabs(e_b - e_a) >
        2 * steepest * apart + 1e-12 * std::max(e_a, e_b)) {
      continue;
    }
    jump[k] = SizeOf(
        {slope_b.x - slope_a.x, slope_b.y - slope_a.y, slope_b.z - slope_a.z});
  }
  return jump;
}

}  // namespace

KinkJumps FindKinkJumps(const Oracle& oracle, const SurfaceFrame& frame,
                        const PixelReceivers& receivers, int threads,
                        const Watch& watch) {
  KinkJumps result;
  result.lengths = Raster<Rgb>(receivers.width(), receivers.height());
  CrossingFinder finder(oracle.scene(), frame, receivers, watch);
  result.is_partial = !finder.is_complete();
  const auto crossings = finder.Find(threads);
  if (!crossings) {
    result.is_left_out = true;
    return result;
  }
  std::vector<Rgb> jumps(crossings->size());
  Progress progress(crossings->size(), "kink candidates", watch);
  ForEachInParallel(crossings->size(), threads, progress, [&](std::size_t i) {
    jumps[i] = JumpAt(oracle, (*crossings)[i]);
  });
  for (std::size_t i = 0; i < jumps.size(); ++i) {
    const Step& step = (*crossings)[i].step;
    Rgb& largest = result.lengths.At(step.x, step.y);
    for (std::size_t k = 0; k < 3; ++k)
      largest[k] = std::max(largest[k], jumps[i][k]);
  }
  return result;
}

}  // namespace truelux
