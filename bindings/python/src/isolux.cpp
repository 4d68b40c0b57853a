// SPDX-License-Identifier: GPL-3.0-or-later
#include "truelux/isolux.h"

#include <array>
#include <optional>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <string>

#include "bindings.h"
#include "errors.h"
#include "isolux_arrays.h"
#include "oracle_options.h"
#include "progress.h"
#include "rows.h"

namespace py = pybind11;

namespace truelux::python {
namespace {

py::dict DictOf(const SurfaceLines& lines) {
  Codes kind;
  NumberRows ends;
  NumberRows size;
  NumberRows left;
  NumberRows right;
  py::list faces;
  py::list edges;
  for (const SurfaceLine& line : lines.lines) {
    kind.Add(line.kind);
    ends.Add(line.ends);
    size.Add(line.size);
    left.Add(line.left);
    right.Add(line.right);
    faces.append(line.faces);
    py::list pairs;
    for (const auto& [a, b] : line.edges)
      pairs.append(py::make_tuple(a, b));
    edges.append(pairs);
  }
  py::dict all;
  all["kind"] = kind.Array();
  all["ends"] = ends.Array({2, 3});
  all["size"] = size.Array({3});
  all["left"] = left.Array({3});
  all["right"] = right.Array({3});
  all["faces"] = faces;
  all["edges"] = edges;
  all["is_complete"] = lines.is_complete;
  all["notes"] = MessagesOf(lines.notes);
  return all;
}

py::dict DictOf(const truelux::IsoluxContour& contour) {
  NumberRows vertices;
  NumberRows across;
  NumberRows half_width;
  Codes certified;
  Codes on;
  NumberRows widths;
  for (const IsoluxVertex& vertex : contour.vertices) {
    vertices.Add(vertex.at);
    across.Add(vertex.across);
    half_width.Add(vertex.half_width);
    certified.Add(vertex.is_certified);
    on.Add(vertex.on);
  }
  for (const double width : contour.widths)
    widths.Add(width);
  py::dict all;
  all["level"] = contour.level;
  all["face"] = contour.face;
  all["closed"] = contour.is_closed;
  all["vertices"] = vertices.Array({3});
  all["across"] = across.Array({3});
  all["half_width"] = half_width.Array();
  all["certified"] = certified.Array();
  all["on"] = on.Array();
  all["widths"] = widths.Array();
  return all;
}

py::dict DictOf(const SurfaceExtrema& extrema) {
  Codes kind;
  NumberRows at;
  NumberRows value;
  NumberRows range;
  NumberRows radius;
  Codes on;
  for (const SurfaceExtremum& point : extrema.points) {
    kind.Add(point.kind);
    at.Add(point.at);
    value.Add(point.value);
    range.Add(point.least);
    range.Add(point.most);
    radius.Add(point.radius);
    on.Add(point.on);
  }
  py::list undecided;
  for (const UndecidedRegion& region : extrema.undecided) {
    NumberRows triangles;
    for (const std::array<Point3, 3>& triangle : region.triangles)
      triangles.Add(triangle);
    undecided.append(
        py::make_tuple(triangles.Array({3, 3}), region.least, region.most));
  }
  py::dict all;
  all["kind"] = kind.Array();
  all["at"] = at.Array({3});
  all["value"] = value.Array();
  all["range"] = range.Array({2});
  all["radius"] = radius.Array();
  all["on"] = on.Array();
  all["undecided"] = undecided;
  all["undecided_area"] = extrema.undecided_area;
  all["area"] = extrema.area;
  all["dark_area"] = extrema.dark_area;
  all["least"] = extrema.least;
  all["most"] = extrema.most;
  all["size"] = extrema.size;
  all["evaluations"] = extrema.evaluations;
  all["notes"] = MessagesOf(extrema.notes);
  return all;
}

py::dict SurfaceLineArrays(const SharedScene& scene, const Choice& choice,
                           const std::string& surface) {
  return DictOf(Found(scene, choice, [&](const Oracle& oracle) {
    return SurfaceLinesOf(oracle, surface);
  }));
}

py::dict IsoluxArrays(const SharedScene& scene, const Choice& choice,
                      const std::string& surface,
                      const ContourArguments& arguments, int threads,
                      const py::object& told) {
  const IsoluxOptions options =
      ContourOptionsOf(choice, arguments, threads, told);
  return IsoluxDictOf(Found(scene, choice, [&](const Oracle& oracle) {
    return IsoluxOf(oracle, surface, options);
  }));
}

/// threads: as of ContourOptionsOf.
py::dict ExtremaArrays(const SharedScene& scene, const Choice& choice,
                       const std::string& surface,
                       const std::optional<std::string>& channel, int threads,
                       const py::object& told) {
  ExtremaOptions options;
  options.channel = ChannelOf(channel);
  options.threads = threads > 0 ? threads : choice.ThreadCount();
  options.progress = HookOf(told);
  return DictOf(Found(scene, choice, [&](const Oracle& oracle) {
    return ExtremaOf(oracle, surface, options);
  }));
}

}  // namespace

IsoluxOptions ContourOptionsOf(const Choice& choice,
                               const ContourArguments& arguments, int threads,
                               const py::object& told) {
  const auto& [levels, count, channel, lengths, most_triangles] = arguments;
  IsoluxOptions options;
  options.levels = levels;
  options.count = count;
  options.channel = ChannelOf(channel);
  options.half_width = lengths[0];
  options.chord = lengths[1];
  options.smallest = lengths[2];
  options.most_triangles = most_triangles;
  options.threads = threads > 0 ? threads : choice.ThreadCount();
  options.progress = HookOf(told);
  return options;
}

py::dict IsoluxDictOf(const Isolux& isolux) {
  NumberRows levels;
  for (const double level : isolux.levels)
    levels.Add(level);
  py::list contours;
  for (const truelux::IsoluxContour& contour : isolux.contours)
    contours.append(DictOf(contour));
  NumberRows outline;
  for (const std::array<Point3, 2>& side : isolux.outline)
    outline.Add(side);
  NumberRows open;
  NumberRows open_range;
  for (const OpenTriangle& triangle : isolux.open) {
    open.Add(triangle.corners);
    open_range.Add(triangle.least);
    open_range.Add(triangle.most);
  }
  py::dict all;
  all["levels"] = levels.Array();
  all["contours"] = contours;
  all["lines"] = DictOf(isolux.lines);
  all["outline"] = outline.Array({2, 3});
  all["open"] = open.Array({3, 3});
  all["open_range"] = open_range.Array({2});
  all["size"] = isolux.size;
  all["area"] = isolux.area;
  all["open_area"] = isolux.open_area;
  all["dark_area"] = isolux.dark_area;
  all["least"] = isolux.least;
  all["most"] = isolux.most;
  all["search_evaluations"] = isolux.search_evaluations;
  all["line_evaluations"] = isolux.line_evaluations;
  all["triangles"] = isolux.triangles;
  return all;
}

void BindIsolux(py::module_& module) {
  module.def("surface_lines", SurfaceLineArrays);
  module.def("isolux", IsoluxArrays);
  module.def("extrema", ExtremaArrays);
  module.attr("SURFACE_LINE_KINDS") =
      NamesOf({SurfaceLineKind::kJump, SurfaceLineKind::kKink});
  module.attr("CONTOUR_PLACES") =
      NamesOf({ContourPlace::kInside, ContourPlace::kKink, ContourPlace::kJump,
               ContourPlace::kOutline});
  module.attr("EXTREMUM_KINDS") = NamesOf(
      {ExtremumKind::kMaximum, ExtremumKind::kMinimum, ExtremumKind::kSaddle});
}

}  // namespace truelux::python
