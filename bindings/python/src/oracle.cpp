// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "truelux/sphere.h"
#include "truelux/version.h"
#include "truelux/visibility.h"

#include "bindings.h"
#include "errors.h"
#include "interruptible.h"
#include "oracle_options.h"
#include "receivers.h"

namespace py = pybind11;

namespace truelux::python {
namespace {

/// E and its bounds, shapes (n, 3), no bounds if they are not wanted; and how many
/// receivers on no face get 0 and lie behind one (Scene::IsBehindFace).
std::tuple<py::array_t<double>, std::optional<py::array_t<double>>, std::size_t>
Irradiances(const SharedScene& scene, const Choice& choice, const Rows& points,
            const Rows& normals, const Numbers& on_face, bool with_bound) {
  const Receivers receivers(points, normals, on_face, scene.scene);
  const std::vector<py::ssize_t> shape = {
      static_cast<py::ssize_t>(receivers.size()), 3};
  py::array_t<double> values(shape);
  std::optional<py::array_t<double>> bounds;
  if (with_bound) bounds.emplace(shape);
  double* const value = values.mutable_data();
  double* const bound = bounds ? bounds->mutable_data() : nullptr;
  std::atomic<std::size_t> behind = 0;
  {
    const Interruptible interruptible;
    const Oracle oracle(scene.prepared, choice.Options(interruptible.flag()));
    ForBlocks(receivers.size(), choice.threads,
              [&](std::size_t first, std::size_t count) {
                std::vector<Receiver> block;
                receivers.Fill(first, count, block);
                oracle.Evaluate(block, [&](std::size_t i, const Irradiance& e) {
                  for (std::size_t c = 0; c < 3; ++c) {
                    value[3 * (first + i) + c] = e.value[c];
                    if (bound != nullptr)
                      bound[3 * (first + i) + c] = e.bound[c];
                  }
                  if (e.value == Rgb{} && block[i].on_face == 0 &&
                      scene.scene.IsBehindFace(block[i])) {
                    ++behind;
                  }
                });
              });
  }
  return {std::move(values), std::move(bounds), behind.load()};
}

/// Throws InputError for receivers that cannot be used.
void Check(const SharedScene& scene, const Rows& points, const Rows& normals,
           const Numbers& on_face) {
  const Receivers receivers(points, normals, on_face, scene.scene);
}

/// The numbers of the faces that emit, shape (s); their form factors and the
/// bounds, shapes (n, s).
std::tuple<py::array_t<std::int64_t>, py::array_t<double>, py::array_t<double>>
FormFactors(const SharedScene& scene, const Choice& choice, const Rows& points,
            const Rows& normals, const Numbers& on_face) {
  const Receivers receivers(points, normals, on_face, scene.scene);
  std::vector<std::int64_t> faces;
  for (std::size_t f = 0; f < scene.scene.faces().size(); ++f) {
    const Rgb& emission = scene.scene.faces()[f].emission;
    if (emission != Rgb{}) faces.push_back(static_cast<std::int64_t>(f) + 1);
  }
  const std::vector<py::ssize_t> shape = {
      static_cast<py::ssize_t>(receivers.size()),
      static_cast<py::ssize_t>(faces.size())};
  py::array_t<double> values(shape);
  py::array_t<double> bounds(shape);
  double* const value = values.mutable_data();
  double* const bound = bounds.mutable_data();
  {
    const Interruptible interruptible;
    const Oracle oracle(scene.prepared, choice.Options(interruptible.flag()));
    ForBlocks(receivers.size(), choice.threads,
              [&](std::size_t first, std::size_t count) {
                for (std::size_t i = first; i < first + count; ++i) {
                  const FormFactorTable table =
                      oracle.FormFactors(receivers.At(i));
                  if (table.faces.size() != faces.size())
                    throw std::logic_error("form factors: number of sources");
                  for (std::size_t s = 0; s < faces.size(); ++s) {
                    value[faces.size() * i + s] = table.faces[s].value;
                    bound[faces.size() * i + s] = table.faces[s].bound;
                  }
                }
              });
  }
  return {py::array_t<std::int64_t>(static_cast<py::ssize_t>(faces.size()),
                                    faces.data()),
          std::move(values), std::move(bounds)};
}

py::array_t<double> Triples(const std::vector<Vector3>& vectors) {
  py::array_t<double> array(
      {static_cast<py::ssize_t>(vectors.size()), py::ssize_t{3}});
  auto out = array.mutable_unchecked<2>();
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    const auto row = static_cast<py::ssize_t>(i);
    out(row, 0) = vectors[i].x;
    out(row, 1) = vectors[i].y;
    out(row, 2) = vectors[i].z;
  }
  return array;
}

/// Columns of vertices and arcs by name.
py::dict Contour(const SharedScene& scene, const Choice& choice,
                 const Rows& points, const Rows& normals,
                 const Numbers& on_face) {
  const Receivers receivers(points, normals, on_face, scene.scene);
  VisibleContour contour;
  {
    const Interruptible interruptible;
    contour = Oracle(scene.prepared, choice.Options(interruptible.flag()))
                  .Contour(receivers.At(0));
  }
  std::vector<std::string> kinds;
  std::vector<bool> conjunctive;
  std::vector<std::int64_t> planes;
  std::vector<std::int64_t> vertices;
  std::vector<Vector3> directions;
  for (const ContourVertex& v : contour.vertices) {
    kinds.emplace_back(Name(v.kind));
    conjunctive.push_back(v.conjunctive);
    planes.push_back(v.planes);
    vertices.push_back(v.vertex);
    directions.push_back(v.direction);
  }
  std::vector<std::int64_t> from;
  std::vector<std::int64_t> to;
  std::vector<std::int64_t> sources;
  std::vector<std::int64_t> edge_faces;
  std::vector<Vector3> plane_normals;
  for (const ContourArc& arc : contour.arcs) {
    from.push_back(arc.from);
    to.push_back(arc.to);
    sources.push_back(arc.source);
    edge_faces.push_back(arc.edge_face);
    plane_normals.push_back(arc.plane_normal);
  }
  py::dict columns;
  columns["kind"] = kinds;
  columns["conjunctive"] = conjunctive;
  columns["planes"] = planes;
  columns["vertex"] = vertices;
  columns["direction"] = Triples(directions);
  columns["from"] = from;
  columns["to"] = to;
  columns["source"] = sources;
  columns["edge_face"] = edge_faces;
  columns["plane_normal"] = Triples(plane_normals);
  return columns;
}

py::array_t<double> FromSphere(const Rows& points, const Rows& normals,
                               const std::array<double, 3>& center,
                               double radius, const Rgb& exitance) {
  const Scene nothing;
  const Receivers receivers(points, normals, NoFace(), nothing);
  py::array_t<double> values(
      std::vector<py::ssize_t>{static_cast<py::ssize_t>(receivers.size()), 3});
  double* const value = values.mutable_data();
  const Sphere sphere{{center[0], center[1], center[2]}, radius, exitance};
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    try {
      const Rgb e = IrradianceFromSphere(receivers.At(i), sphere);
      for (std::size_t c = 0; c < 3; ++c)
        value[3 * i + c] = e[c];
    } catch (const std::invalid_argument& defect) {
      throw InputError(
          {"receiver " + std::to_string(i) + ": " + defect.what()});
    }
  }
  return values;
}

}  // namespace

void BindOracle(py::module_& module) {
  py::class_<Choice>(module, "Choice")
      .def(py::init([](const std::string& engine, const std::string& method,
                       const std::string& emission, const std::string& formula,
                       double half_side, int threads) {
        return MakeChoice(engine, method, emission, formula, half_side,
                          threads);
      }));
  module.def("irradiances", Irradiances);
  module.def("check", Check);
  module.def("form_factors", FormFactors);
  module.def("contour", Contour);
  module.def("irradiance_from_sphere", FromSphere);
  module.def("version", [] { return std::string(VersionText()); });
}

}  // namespace truelux::python
