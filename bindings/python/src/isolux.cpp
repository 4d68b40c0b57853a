// SPDX-License-Identifier: GPL-3.0-or-later
#include "truelux/isolux.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <string>
#include <utility>
#include <vector>

#include "bindings.h"
#include "errors.h"
#include "interruptible.h"
#include "oracle_options.h"
#include "progress.h"

namespace py = pybind11;

namespace truelux::python {
namespace {

/// Numbers that become an array, row by row.
class NumberRows {
 public:
  void Add(double x) { numbers_.push_back(x); }

  void Add(const Rgb& rgb) {
    numbers_.insert(numbers_.end(), rgb.begin(), rgb.end());
  }

  void Add(const Point3& p) { Add(Rgb{p.x, p.y, p.z}); }

  void Add(const Vector3& v) { Add(Rgb{v.x, v.y, v.z}); }

  template <std::size_t kCount>
  void Add(const std::array<Point3, kCount>& points) {
    for (const Point3& p : points)
      Add(p);
  }

  /// Of the shape (n, ...row).
  [[nodiscard]] py::array_t<double> Array(
      std::initializer_list<py::ssize_t> row = {}) const {
    py::ssize_t width = 1;
    for (const py::ssize_t size : row)
      width *= size;
    std::vector<py::ssize_t> shape = {
        static_cast<py::ssize_t>(numbers_.size()) / width};
    shape.insert(shape.end(), row);
    return py::array_t<double>(shape, numbers_.data());
  }

 private:
  std::vector<double> numbers_;
};

/// Of enumerators: indices into their names.
class Codes {
 public:
  template <class T>
  void Add(T value) {
    codes_.push_back(static_cast<std::uint8_t>(value));
  }

  [[nodiscard]] py::array_t<std::uint8_t> Array() const {
    return py::array_t<std::uint8_t>(static_cast<py::ssize_t>(codes_.size()),
                                     codes_.data());
  }

 private:
  std::vector<std::uint8_t> codes_;
};

template <class T>
py::list NamesOf(std::initializer_list<T> values) {
  py::list names;
  for (const T value : values)
    names.append(std::string(Name(value)));
  return names;
}

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

py::dict DictOf(const truelux::Contour& contour) {
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

py::dict DictOf(const Isolux& isolux) {
  NumberRows levels;
  for (const double level : isolux.levels)
    levels.Add(level);
  py::list contours;
  for (const truelux::Contour& contour : isolux.contours)
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

/// find(oracle) without the interpreter's lock.
template <class F>
auto Found(const SharedScene& scene, const Choice& choice, const F& find) {
  return Checked([&] {
    const Interruptible interruptible;
    return find(Oracle(scene.prepared, choice.Options(interruptible.flag())));
  });
}

py::dict SurfaceLineArrays(const SharedScene& scene, const Choice& choice,
                           const std::string& surface) {
  return DictOf(Found(scene, choice, [&](const Oracle& oracle) {
    return SurfaceLinesOf(oracle, surface);
  }));
}

/// threads: 0: as many as `choice` has. lengths: half_width, chord, smallest.
py::dict IsoluxArrays(const SharedScene& scene, const Choice& choice,
                      const std::string& surface, std::vector<double> levels,
                      int count, const std::optional<std::string>& channel,
                      const std::array<double, 3>& lengths,
                      std::size_t most_triangles, int threads,
                      const py::object& told) {
  IsoluxOptions options;
  options.levels = std::move(levels);
  options.count = count;
  options.channel = ChannelOf(channel);
  options.half_width = lengths[0];
  options.chord = lengths[1];
  options.smallest = lengths[2];
  options.most_triangles = most_triangles;
  options.threads = threads > 0 ? threads : choice.ThreadCount();
  options.progress = HookOf(told);
  return DictOf(Found(scene, choice, [&](const Oracle& oracle) {
    return IsoluxOf(oracle, surface, options);
  }));
}

/// threads: as of IsoluxArrays.
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
