// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolux/isolux_run.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fmt/format.h>
#include <stdexcept>
#include <utility>
#include <vector>

#include "isolux/contour_lines.h"
#include "isolux/level_choice.h"
#include "isolux/level_goal.h"
#include "isolux/mesh_search.h"
#include "isolux/prepared_surface.h"
#include "isolux/surface_side.h"
#include "run/parallel.h"
#include "surface/named_surface.h"

namespace truelux {
namespace {

/// Where nothing is asked for.
constexpr double kHalfWidth = 1e-9;
constexpr double kChord = 1e-3;
constexpr double kSmallest = 0x1p-18;
constexpr double kPlateau = 0x1p-4;
constexpr std::size_t kMostTriangles = 4'000'000;

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

class IsoluxFinder {
 public:
  IsoluxFinder(const Oracle& oracle, const IsoluxOptions& options,
               const Watch& watch)
      : oracle_(oracle), options_(options), watch_(watch) {}

  TracedSurface Find(const std::string& surface) {
    prepared_ = PrepareSurface(oracle_, surface, options_.channel,
                               options_.threads, watch_);
    result_.lines.notes = prepared_.notes;
    result_.size = prepared_.size;
    result_.right = prepared_.sides.front()->plan().VectorOf({1, 0});
    result_.up = prepared_.sides.front()->plan().VectorOf({0, 1});
    for (const auto& side : prepared_.sides) {
      for (SurfaceLine& line :
           ShownLines(oracle_, side->side(), side->first().scale.margin))
        result_.lines.lines.push_back(std::move(line));
      result_.lines.is_complete =
          result_.lines.is_complete && side->side().lines.is_complete;
      for (const auto& [a, b] : OutlineOf(oracle_.scene(), side->side().faces))
        result_.outline.push_back({PointOf(a), PointOf(b)});
    }
    NoteLeftOut();
    SetLevels();
    for (const auto& side : prepared_.sides)
      Trace(*side);
    std::ranges::stable_sort(result_.contours, {}, &IsoluxContour::level);
    return {std::move(prepared_), std::move(lines_), std::move(result_)};
  }

 private:
  void NoteLeftOut() {
    int left_out = 0;
    for (const auto& side : prepared_.sides)
      left_out += side->first().left_out;
    if (left_out == 0) return;
    result_.lines.notes.push_back(
        {Severity::kNote, "", 0,
         fmt::format("{} of the surface, between lines at which light jumps, "
                     "{} as thin as a rounding and not looked at",
                     left_out == 1 ? "1 triangle"
                                   : fmt::format("{} triangles", left_out),
                     left_out == 1 ? "is" : "are")});
  }

  [[nodiscard]] Point3 PointOf(int vertex) const {
    return oracle_.scene().vertices()[static_cast<std::size_t>(vertex)];
  }

  void SetLevels() {
    double least = HUGE_VAL;
    double most = 0;
    for (const auto& side : prepared_.sides) {
      for (const LightValue& value : side->search().values()) {
        least = std::min(least, value.value);
        most = std::max(most, value.value);
      }
    }
    result_.levels = options_.levels.empty()
                         ? EvenLevels(least, most, options_.count)
                         : options_.levels;
    if (!result_.levels.empty()) return;
    result_.lines.notes.push_back(
        {Severity::kNote, "", 0,
         most > 0 ? fmt::format("irradiance is {} wherever it was asked for: "
                                "there are no levels to choose",
                                most)
                  : "no light reaches the surface where it was asked for: "
                    "there are no levels to choose"});
  }

  void Trace(SideSearch& side) {
    SearchLimits limits;
    limits.smallest =
        options_.smallest > 0 ? options_.smallest : kSmallest * result_.size;
    limits.plateau = kPlateau * result_.size;
    limits.most_triangles =
        options_.most_triangles > 0 ? options_.most_triangles : kMostTriangles;
    side.search().Settle(LevelGoal(result_.levels), limits, options_.threads,
                         watch_);
    const std::uint64_t searched = side.probe().count();
    ContourWishes wishes;
    wishes.half_width = options_.half_width > 0 ? options_.half_width
                                                : kHalfWidth * result_.size;
    wishes.chord = options_.chord > 0 ? options_.chord : kChord * result_.size;
    auto lines =
        ContourLinesOf(side.probe(), side.features(), side.search(),
                       result_.levels, wishes, options_.threads, watch_);
    for (const ContourLine& line : lines)
      result_.contours.push_back(ContourOf(side.plan(), line, result_.levels));
    result_.search_evaluations += searched;
    result_.line_evaluations += side.probe().count() - searched;
    lines_.push_back(std::move(lines));
    AddAreas(side);
  }

  void AddAreas(const SideSearch& side) {
    const PlanMesh& mesh = side.search().mesh();
    result_.triangles += mesh.triangles().size();
    bool is_first = result_.area == 0;
    for (const LightValue& value : side.search().values()) {
      result_.least =
          is_first ? value.value : std::min(result_.least, value.value);
      result_.most = std::max(result_.most, value.value);
      is_first = false;
    }
    for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
      const auto triangle = static_cast<int>(i);
      const KnownTriangle& known = side.search().known()[i];
      const double area = mesh.AreaOf(triangle);
      result_.area += area;
      if (known.is_dark) result_.dark_area += area;
      if (known.is_settled || result_.levels.empty()) continue;
      result_.open_area += area;
      OpenTriangle& open = result_.open.emplace_back();
      const auto corners = mesh.CornersOf(triangle);
      for (std::size_t k = 0; k < 3; ++k)
        open.corners[k] = side.plan().PointAt(corners[k]);
      const ValueRange range = side.search().RangeOf(triangle);
      open.least = std::max(0.0, range.least);
      open.most = std::min(prepared_.most_exitance, range.most);
    }
  }

  const Oracle& oracle_;
  const IsoluxOptions& options_;
  const Watch& watch_;
  PreparedSurface prepared_;
  std::vector<std::vector<ContourLine>> lines_;
  Isolux result_;
};

}  // namespace

IsoluxContour ContourOf(const PlanFrame& plan, const ContourLine& line,
                        std::span<const double> levels) {
  IsoluxContour contour;
  contour.level = levels[line.level];
  contour.face = plan.ReceiverAt({}).on_face;
  contour.is_closed = line.is_closed;
  contour.widths = line.widths;
  for (const ContourPoint& point : line.points) {
    contour.vertices.push_back({plan.PointAt(point.at),
                                plan.VectorOf(point.across), point.half_width,
                                point.is_certified, PlaceOf(point.on)});
  }
  return contour;
}

SurfaceLines FindSurfaceLines(const Oracle& oracle, const std::string& surface,
                              const Watch& watch) {
  const Scene& scene = oracle.scene();
  NamedSurface named = SurfaceNamed(scene, surface);
  const EdgePlanes planes = EdgePlanesOf(
      scene, CornersOfSurface(scene, named.frame), kMostEdgeLines, watch.stop);
  SurfaceLines result;
  result.notes = std::move(named.notes);
  for (const SurfaceSide& side : SidesOf(scene, named.frame, planes, watch)) {
    const double margin =
        FirstMeshOf(scene, side.plan, side.faces, {}).scale.margin;
    for (SurfaceLine& line : ShownLines(oracle, side, margin))
      result.lines.push_back(std::move(line));
    result.is_complete = result.is_complete && side.lines.is_complete;
  }
  return result;
}

TracedSurface TraceSurface(const Oracle& oracle, const std::string& surface,
                           const IsoluxOptions& options, const Watch& watch) {
  Check(options);
  return IsoluxFinder(oracle, options, watch).Find(surface);
}

Isolux FindIsolux(const Oracle& oracle, const std::string& surface,
                  const IsoluxOptions& options, const Watch& watch) {
  return TraceSurface(oracle, surface, options, watch).isolux;
}

}  // namespace truelux
