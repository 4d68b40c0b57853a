// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <optional>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "truelux/io.h"
#include "truelux/stop.h"

#include "bindings.h"
#include "errors.h"
#include "interruptible.h"
#include "receivers.h"

namespace py = pybind11;

namespace truelux::python {
namespace {

/// A scene and the lines of its notes; throws if there is none.
std::pair<SharedScene, std::vector<std::string>> Taken(
    const Result<Scene>& result) {
  std::vector<std::string> notes;
  std::vector<std::string> errors;
  for (const Diagnostic& d : result.diagnostics)
    (d.severity == Severity::kError ? errors : notes).push_back(d.Text());
  if (!result.ok()) throw InputError(std::move(errors));
  return {SharedScene(*result.value), std::move(notes)};
}

/// The same for Python.
std::pair<SharedScene, py::list> WithTexts(
    std::pair<SharedScene, std::vector<std::string>> taken) {
  return {std::move(taken.first), TextsOf(taken.second)};
}

std::pair<SharedScene, py::list> ReadFile(const std::string& path, bool lenient,
                                          bool two_sided,
                                          std::optional<double> opaque_from) {
  return WithTexts([&] {
    const Interruptible interruptible;
    return Taken(ReadScene(path, {.lenient = lenient,
                                  .opaque_from = opaque_from,
                                  .two_sided = two_sided,
                                  .stop = interruptible.flag()}));
  }());
}

void StopIfAsked(const Interruptible& interruptible) {
  if (*interruptible.flag()) throw Stopped();
}

/// corners: of all faces, indices into vertices; sizes: how many of each face.
/// The shapes have been checked.
std::pair<SharedScene, py::list> FromArrays(
    const py::array_t<double, py::array::c_style>& vertices,
    const py::array_t<std::int64_t, py::array::c_style>& corners,
    const py::array_t<std::int64_t, py::array::c_style>& sizes,
    const py::array_t<double, py::array::c_style>& emission,
    const std::vector<std::string>& groups, bool lenient, bool two_sided) {
  const auto points = vertices.unchecked<2>();
  const auto indices = corners.unchecked<1>();
  const auto counts = sizes.unchecked<1>();
  const auto ke = emission.unchecked<2>();
  const auto build = [&] {
    const Interruptible interruptible;
    SceneBuilder builder("scene");
    builder.SetLenient(lenient);
    builder.SetTwoSided(two_sided);
    std::vector<std::string> defects;
    py::ssize_t next = 0;
    for (py::ssize_t f = 0; f < counts.shape(0); ++f) {
      StopIfAsked(interruptible);
      std::vector<Point3> ring;
      std::vector<int> numbers;
      for (std::int64_t k = 0; k < counts(f); ++k) {
        const std::int64_t v = indices(next++);
        if (v < 0 || v >= points.shape(0)) {
          defects.push_back("face " + std::to_string(f + 1) + ": vertex " +
                            std::to_string(v) + " does not exist; there are " +
                            std::to_string(points.shape(0)) +
                            ", counted from 0");
          continue;
        }
        ring.push_back({points(v, 0), points(v, 1), points(v, 2)});
        numbers.push_back(static_cast<int>(v) + 1);
      }
      if (!groups.empty())
        builder.SetGroup(groups[static_cast<std::size_t>(f)]);
      builder.SetVertexNumbers(std::move(numbers));
      builder.AddFace(std::move(ring), {ke(f, 0), ke(f, 1), ke(f, 2)},
                      static_cast<int>(f) + 1);
    }
    if (!defects.empty()) throw InputError(std::move(defects));
    return Taken(builder.Build());
  };
  return WithTexts(build());
}

py::array_t<double> VerticesOf(const SharedScene& scene) {
  const auto vertices = scene.scene.vertices();
  py::array_t<double> array(
      {static_cast<py::ssize_t>(vertices.size()), py::ssize_t{3}});
  auto out = array.mutable_unchecked<2>();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto row = static_cast<py::ssize_t>(i);
    out(row, 0) = vertices[i].x;
    out(row, 1) = vertices[i].y;
    out(row, 2) = vertices[i].z;
  }
  return array;
}

template <class T, class Get>
py::array_t<T> FaceArray(const SharedScene& scene, const Get& get) {
  const auto faces = scene.scene.faces();
  py::array_t<T> array(static_cast<py::ssize_t>(faces.size()));
  auto out = array.template mutable_unchecked<1>();
  for (std::size_t i = 0; i < faces.size(); ++i)
    out(static_cast<py::ssize_t>(i)) = get(faces[i]);
  return array;
}

py::array_t<double> EmissionOf(const SharedScene& scene) {
  const auto faces = scene.scene.faces();
  py::array_t<double> array(
      {static_cast<py::ssize_t>(faces.size()), py::ssize_t{3}});
  auto out = array.mutable_unchecked<2>();
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c)
      out(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(c)) =
          faces[i].emission[c];
  }
  return array;
}

template <class T>
py::array_t<std::int64_t> IntegersOf(std::span<const T> values) {
  py::array_t<std::int64_t> array(static_cast<py::ssize_t>(values.size()));
  auto out = array.mutable_unchecked<1>();
  for (std::size_t i = 0; i < values.size(); ++i)
    out(static_cast<py::ssize_t>(i)) = values[i];
  return array;
}

/// The number of the face that each receiver lies on; 0 where there is none.
py::array_t<std::int64_t> FacesNear(const SharedScene& scene,
                                    const Rows& points, const Rows& normals,
                                    const std::optional<std::string>& name,
                                    std::optional<double> limit, int threads) {
  const Receivers receivers(points, normals, NoFace(), scene.scene);
  py::array_t<std::int64_t> found(static_cast<py::ssize_t>(receivers.size()));
  std::int64_t* out = found.mutable_data();
  const Interruptible interruptible;
  ForBlocks(
      receivers.size(), threads, [&](std::size_t first, std::size_t count) {
        StopIfAsked(interruptible);
        for (std::size_t i = first; i < first + count; ++i) {
          const auto face = name ? scene.scene.FaceNear(receivers.At(i), *name)
                                 : scene.scene.FaceNear(receivers.At(i), limit);
          out[i] = face ? face->number : 0;
        }
      });
  return found;
}

/// The same scene, of which the faces that emit do so to both sides.
SharedScene TwoSided(const SharedScene& shared) {
  const Interruptible interruptible;
  const Scene& scene = shared.scene;
  SceneBuilder builder("scene");
  builder.SetTwoSided(true);
  for (const Face& face : scene.faces()) {
    StopIfAsked(interruptible);
    std::vector<Point3> ring;
    std::vector<int> numbers;
    for (int k = 0; k < face.corner_count; ++k) {
      const auto corner = static_cast<std::size_t>(face.first_corner + k);
      ring.push_back(
          scene.vertices()[static_cast<std::size_t>(scene.corners()[corner])]);
      numbers.push_back(scene.corner_numbers()[corner]);
    }
    builder.SetGroup(scene.group_names()[static_cast<std::size_t>(face.group)]);
    if (face.facet_count == 0) {
      builder.LeaveOutFace("no area", face.line);
      continue;
    }
    builder.SetVertexNumbers(std::move(numbers));
    builder.AddFace(std::move(ring), face.emission, face.line);
  }
  return Taken(builder.Build()).first;
}

}  // namespace

void BindScene(py::module_& module) {
  py::class_<SharedScene>(module, "Scene")
      .def_static("read", ReadFile)
      .def_static("from_arrays", FromArrays)
      .def("vertices", VerticesOf)
      .def("corners",
           [](const SharedScene& s) { return IntegersOf(s.scene.corners()); })
      .def("corner_numbers",
           [](const SharedScene& s) {
             return IntegersOf(s.scene.corner_numbers());
           })
      .def("corner_counts",
           [](const SharedScene& s) {
             return FaceArray<std::int64_t>(
                 s, [](const Face& f) { return f.corner_count; });
           })
      .def("groups",
           [](const SharedScene& s) {
             return FaceArray<std::int64_t>(
                 s, [](const Face& f) { return f.group; });
           })
      .def("group_names",
           [](const SharedScene& s) {
             const auto names = s.scene.group_names();
             return TextsOf({names.begin(), names.end()});
           })
      .def("emission", EmissionOf)
      .def("face_count",
           [](const SharedScene& s) { return s.scene.faces().size(); })
      .def("vertex_count",
           [](const SharedScene& s) { return s.scene.vertices().size(); })
      .def("faces_near", FacesNear)
      .def("two_sided", TwoSided);
}

}  // namespace truelux::python
