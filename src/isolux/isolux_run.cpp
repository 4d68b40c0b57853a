// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/isolux_run.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <memory>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "isolux/contour_lines.h"
#include "isolux/first_mesh.h"
#include "isolux/level_choice.h"
#include "isolux/level_search.h"
#include "isolux/light_features.h"
#include "isolux/surface_side.h"
#include "run/parallel.h"
#include "scene/emitters.h"
#include "surface/named_surface.h"

namespace truelux {
namespace {

/// Where nothing is asked for.
constexpr double kHalfWidth = 1e-9;
constexpr double kChord = 1e-3;
constexpr double kSmallest = 0x1p-16;
constexpr std::size_t kMostTriangles = 4'000'000;
/// Before levels are chosen triangles are at most this share of the size.
constexpr double kCoarse = 1.0 / 16;

Rgb WeightsOf(const Scene& scene, std::optional<ScalarChannel> channel) {
  if (!channel && IsGrey(scene)) return {1, 0, 0};
  switch (channel.value_or(ScalarChannel::kLuminance)) {
    case ScalarChannel::kLuminance:
      break;
    case ScalarChannel::kRed:
      return {1, 0, 0};
    case ScalarChannel::kGreen:
      return {0, 1, 0};
    case ScalarChannel::kBlue:
      return {0, 0, 1};
  }
  return {0.2126, 0.7152, 0.0722};
}

void CheckNumber(const char* name, double value) {
  if (value >= 0 && std::isfinite(value)) return;
  throw std::invalid_argument(
      fmt::format("{}: {} is no length (0 chooses one)", name, value));
}

void Check(const IsoluxOptions& options) {
  CheckThreads(options.threads);
  CheckNumber("half_width", options.half_width);
  CheckNumber("chord", options.chord);
  CheckNumber("smallest", options.smallest);
  if (options.levels.empty() && options.count < 1)
    throw std::invalid_argument("count: expected at least one level");
  for (std::size_t i = 0; i < options.levels.size(); ++i) {
    const double level = options.levels[i];
    if (!(level > 0) || !std::isfinite(level)) {
      throw std::invalid_argument(fmt::format(
          "levels: {} is not above 0; where irradiance is 0, it is so over "
          "whole areas and not on lines",
          level));
    }
    if (i > 0 && !(level > options.levels[i - 1])) {
      throw std::invalid_argument(
          fmt::format("levels: {} does not come after {} in ascending order",
                      level, options.levels[i - 1]));
    }
  }
}

ContourPlace PlaceOf(SideKind kind) {
  switch (kind) {
    case SideKind::kInner:
      break;
    case SideKind::kKink:
      return ContourPlace::kKink;
    case SideKind::kJump:
      return ContourPlace::kJump;
    case SideKind::kOutline:
      return ContourPlace::kOutline;
  }
  return ContourPlace::kInside;
}

class IsoluxFinder {
 public:
  IsoluxFinder(const Oracle& oracle, const IsoluxOptions& options,
               const Watch& watch)
      : oracle_(oracle),
        options_(options),
        watch_(watch),
        weights_(WeightsOf(oracle.scene(), options.channel)) {
    for (const Face& face : oracle.scene().faces()) {
      double exitance = 0;
      for (std::size_t k = 0; k < 3; ++k)
        exitance += weights_[k] * face.emission[k];
      most_exitance_ = std::max(most_exitance_, exitance);
    }
    if (oracle.options().emission == Emission::kRadiance)
      most_exitance_ *= std::numbers::pi;
  }

  Isolux Find(const std::string& surface) {
    NamedSurface named = SurfaceNamed(oracle_.scene(), surface);
    result_.lines.notes = std::move(named.notes);
    const EdgePlanes planes = EdgePlanesOf(
        oracle_.scene(), CornersOfSurface(oracle_.scene(), named.frame),
        kMostEdgeLines, watch_.stop);
    sides_ = SidesOf(oracle_.scene(), named.frame, planes, watch_);
    result_.right = sides_.front().plan.VectorOf({1, 0});
    result_.up = sides_.front().plan.VectorOf({0, 1});
    for (const SurfaceSide& side : sides_)
      Prepare(side, planes);
    SetLevels();
    for (const auto& search : searches_)
      Trace(*search);
    return std::move(result_);
  }

 private:
  void Prepare(const SurfaceSide& side, const EdgePlanes& planes) {
    FirstMesh first =
        FirstMeshOf(oracle_.scene(), side.plan, side.faces, side.lines.lines);
    result_.size = std::max(result_.size, first.scale.size);
    for (SurfaceLine& line : ShownLines(oracle_, side, first.scale.size))
      result_.lines.lines.push_back(std::move(line));
    result_.lines.is_complete =
        result_.lines.is_complete && side.lines.is_complete;
    AddOutline(side.plan, first.mesh);
    auto own = std::make_unique<Parts>(oracle_, side, planes, weights_,
                                       std::move(first.mesh));
    own->search.RefineTo(kCoarse * first.scale.size);
    own->search.SamplePoints(options_.threads, watch_);
    searches_.push_back(std::move(own));
  }

  /// Keeps what refers to each other in place.
  struct Parts {
    Parts(const Oracle& oracle, const SurfaceSide& its_side,
          const EdgePlanes& planes, const Rgb& weights, PlanMesh mesh)
        : side(its_side),
          features(oracle.scene(), side.plan, planes, oracle.options().emission,
                   weights),
          probe(oracle, side.plan, weights),
          search(probe, features, std::move(mesh)) {}

    const SurfaceSide& side;
    LightFeatures features;
    LightProbe probe;
    LevelSearch search;
  };

  void AddOutline(const PlanFrame& plan, const PlanMesh& mesh) {
    for (const PlanTriangle& triangle : mesh.triangles()) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (triangle.kinds[k] != SideKind::kOutline) continue;
        const auto at = [&](std::size_t corner) {
          return plan.PointAt(mesh.points()[static_cast<std::size_t>(
              triangle.corners[corner % 3])]);
        };
        result_.outline.push_back({at(k + 1), at(k + 2)});
      }
    }
  }

  void SetLevels() {
    double least = HUGE_VAL;
    double most = 0;
    for (const auto& own : searches_) {
      for (const LightValue& value : own->search.values()) {
        least = std::min(least, value.value);
        most = std::max(most, value.value);
      }
    }
    result_.levels = options_.levels.empty()
                         ? EvenLevels(least, most, options_.count)
                         : options_.levels;
    if (result_.levels.empty()) {
      result_.lines.notes.push_back(
          {Severity::kNote, "", 0,
           most > 0 ? fmt::format("irradiance is {} wherever it was asked for: "
                                  "there are no levels to choose",
                                  most)
                    : "no light reaches the surface where it was asked for: "
                      "there are no levels to choose"});
    }
  }

  void Trace(Parts& own) {
    SearchLimits limits;
    limits.smallest =
        options_.smallest > 0 ? options_.smallest : kSmallest * result_.size;
    limits.most_triangles =
        options_.most_triangles > 0 ? options_.most_triangles : kMostTriangles;
    own.search.Settle(result_.levels, limits, options_.threads, watch_);
    const std::uint64_t searched = own.probe.count();
    ContourWishes wishes;
    wishes.half_width = options_.half_width > 0 ? options_.half_width
                                                : kHalfWidth * result_.size;
    wishes.chord = options_.chord > 0 ? options_.chord : kChord * result_.size;
    const auto lines =
        ContourLinesOf(own.probe, own.features, own.search, result_.levels,
                       wishes, options_.threads, watch_);
    for (const ContourLine& line : lines)
      AddContour(own.side.plan, line);
    result_.search_evaluations += searched;
    result_.line_evaluations += own.probe.count() - searched;
    AddAreas(own);
    std::ranges::stable_sort(result_.contours, {}, &Contour::level);
  }

  void AddContour(const PlanFrame& plan, const ContourLine& line) {
    Contour& contour = result_.contours.emplace_back();
    contour.level = result_.levels[line.level];
    contour.is_closed = line.is_closed;
    contour.widths = line.widths;
    for (const ContourPoint& point : line.points) {
      contour.vertices.push_back({plan.PointAt(point.at),
                                  plan.VectorOf(point.across), point.half_width,
                                  point.is_certified, PlaceOf(point.on)});
    }
  }

  void AddAreas(const Parts& own) {
    const PlanMesh& mesh = own.search.mesh();
    result_.triangles += mesh.triangles().size();
    bool is_first = result_.area == 0;
    for (const LightValue& value : own.search.values()) {
      result_.least =
          is_first ? value.value : std::min(result_.least, value.value);
      result_.most = std::max(result_.most, value.value);
      is_first = false;
    }
    for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
      const auto triangle = static_cast<int>(i);
      const KnownTriangle& known = own.search.known()[i];
      const double area = mesh.AreaOf(triangle);
      result_.area += area;
      if (known.is_known && known.sight->empty()) result_.dark_area += area;
      if (known.is_settled || result_.levels.empty()) continue;
      result_.open_area += area;
      OpenTriangle& open = result_.open.emplace_back();
      const auto corners = mesh.CornersOf(triangle);
      for (std::size_t k = 0; k < 3; ++k)
        open.corners[k] = own.side.plan.PointAt(corners[k]);
      const auto [least, most] = own.search.RangeOf(triangle);
      open.least = std::max(0.0, least);
      open.most = std::min(most_exitance_, most);
    }
  }

  const Oracle& oracle_;
  const IsoluxOptions& options_;
  const Watch& watch_;
  Rgb weights_;
  double most_exitance_ = 0;
  std::vector<SurfaceSide> sides_;
  std::vector<std::unique_ptr<Parts>> searches_;
  Isolux result_;
};

}  // namespace

SurfaceLines FindSurfaceLines(const Oracle& oracle, const std::string& surface,
                              const Watch& watch) {
  const Scene& scene = oracle.scene();
  NamedSurface named = SurfaceNamed(scene, surface);
  const EdgePlanes planes = EdgePlanesOf(
      scene, CornersOfSurface(scene, named.frame), kMostEdgeLines, watch.stop);
  SurfaceLines result;
  result.notes = std::move(named.notes);
  for (const SurfaceSide& side : SidesOf(scene, named.frame, planes, watch)) {
    const double size =
        FirstMeshOf(scene, side.plan, side.faces, {}).scale.size;
    for (SurfaceLine& line : ShownLines(oracle, side, size))
      result.lines.push_back(std::move(line));
    result.is_complete = result.is_complete && side.lines.is_complete;
  }
  return result;
}

Isolux FindIsolux(const Oracle& oracle, const std::string& surface,
                  const IsoluxOptions& options, const Watch& watch) {
  Check(options);
  return IsoluxFinder(oracle, options, watch).Find(surface);
}

}  // namespace truelux
