// SPDX-License-Identifier: GPL-3.0-or-later
#include "truelux/isomesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <string>
#include <vector>

#include "bindings.h"
#include "isolux_arrays.h"
#include "oracle_options.h"
#include "rows.h"

namespace py = pybind11;

namespace truelux::python {
namespace {

py::tuple TupleOf(const InterpolationError& error) {
  return py::make_tuple(error.most, error.at_99, error.mean);
}

py::dict DictOf(const IsoMesh& mesh) {
  NumberRows points;
  NumberRows irradiance;
  NumberRows values;
  for (const IsoMeshVertex& vertex : mesh.vertices) {
    points.Add(vertex.at);
    irradiance.Add(vertex.irradiance);
    values.Add(vertex.value);
  }
  std::vector<std::int64_t> triangles;
  Codes sides;
  std::vector<std::int64_t> faces;
  for (const IsoMeshTriangle& triangle : mesh.triangles) {
    triangles.insert(triangles.end(), triangle.vertices.begin(),
                     triangle.vertices.end());
    for (const MeshSide side : triangle.sides)
      sides.Add(side);
    faces.push_back(triangle.face);
  }
  py::dict all;
  all["points"] = points.Array({3});
  all["irradiance"] = irradiance.Array({3});
  all["values"] = values.Array();
  all["triangles"] = ArrayOf(triangles, {3});
  all["sides"] = sides.Array({3});
  all["faces"] = ArrayOf(faces);
  all["isolux"] = IsoluxDictOf(mesh.isolux);
  all["error"] = mesh.error;
  all["unfinished"] = mesh.unfinished;
  all["interpolation"] = TupleOf(mesh.interpolation);
  all["uniform"] = TupleOf(mesh.uniform);
  all["uniform_vertices"] = mesh.uniform_vertices;
  all["least_angle"] = mesh.least_angle;
  all["drawn"] = mesh.drawn;
  all["most_drawn"] = mesh.most_drawn;
  all["evaluations"] = mesh.evaluations;
  return all;
}

/// numbers: error, smallest. threads: 0: as many as `choice` has.
py::dict IsoMeshArrays(const SharedScene& scene, const Choice& choice,
                       const std::string& surface,
                       const ContourArguments& contours,
                       const std::array<double, 2>& numbers,
                       std::size_t most_vertices, int threads,
                       const py::object& told) {
  IsoMeshOptions options;
  options.contours = ContourOptionsOf(choice, contours, threads, told);
  options.error = numbers[0];
  options.smallest = numbers[1];
  options.most_vertices = most_vertices;
  return DictOf(Found(scene, choice, [&](const Oracle& oracle) {
    return IsoMeshOf(oracle, surface, options);
  }));
}

}  // namespace

void BindIsoMesh(py::module_& module) {
  module.def("iso_mesh", IsoMeshArrays);
  module.attr("MESH_SIDES") =
      NamesOf({MeshSide::kInside, MeshSide::kContour, MeshSide::kKink,
               MeshSide::kJump, MeshSide::kOutline});
}

}  // namespace truelux::python
