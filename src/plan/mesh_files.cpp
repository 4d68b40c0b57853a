// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/mesh_files.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <string_view>

#include "text/results.h"

namespace truelux {
namespace {

void AppendRow(std::string& text, std::initializer_list<double> numbers) {
  std::string_view separator;
  for (const double number : numbers) {
    text += separator;
    AppendNumber(text, number);
    separator = " ";
  }
  text += '\n';
}

void AppendRow(std::string& text, const Point3& p) {
  AppendRow(text, {p.x, p.y, p.z});
}

/// What the numbers are, within one line.
std::string Remark(const PlanSubject& subject) {
  std::string names = subject.surface + " of " + subject.scene;
  std::ranges::replace_if(
      names, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return "irradiance E [W/m^2] on " + names + ", of " + subject.channel;
}

std::string DataArray(std::string_view type, std::string_view name,
                      int components, const std::string& rows) {
  std::string text = "<DataArray type=\"";
  text += type;
  text += "\" Name=\"";
  text += name;
  text += '"';
  if (components > 1)
    text += " NumberOfComponents=\"" + std::to_string(components) + '"';
  text += " format=\"ascii\">\n";
  return text + rows + "</DataArray>\n";
}

/// A row a triangle.
template <class F>
std::string Rows(const IsoMesh& mesh, const F& append) {
  std::string text;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    append(text, i, mesh.triangles[i]);
    text += '\n';
  }
  return text;
}

template <class Triple>
void AppendWhole(std::string& text, const Triple& numbers) {
  std::string_view separator;
  for (const auto number : numbers) {
    text += separator;
    text += std::to_string(static_cast<int>(number));
    separator = " ";
  }
}

}  // namespace

std::string MeshObj(const IsoMesh& mesh, const PlanSubject& subject) {
  std::string text = "# " + Remark(subject) + ": in vt E 0\n";
  for (const IsoMeshVertex& vertex : mesh.vertices) {
    text += "v ";
    AppendRow(text, vertex.at);
  }
  for (const IsoMeshVertex& vertex : mesh.vertices) {
    text += "vt ";
    AppendRow(text, {vertex.value, 0});
  }
  for (const IsoMeshTriangle& triangle : mesh.triangles) {
    text += 'f';
    for (const int vertex : triangle.vertices) {
      const std::string number = std::to_string(vertex + 1);
      text += ' ' + number + '/' + number;
    }
    text += '\n';
  }
  return text;
}

std::string MeshPly(const IsoMesh& mesh, const PlanSubject& subject) {
  std::string text = "ply\nformat ascii 1.0\ncomment " + Remark(subject) +
                     "\nelement vertex " +
                     std::to_string(mesh.vertices.size()) + '\n';
  for (const char* name : {"x", "y", "z", "E", "E_r", "E_g", "E_b"})
    text += std::string("property double ") + name + '\n';
  text += "element face " + std::to_string(mesh.triangles.size()) +
          "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const IsoMeshVertex& vertex : mesh.vertices) {
    const Rgb& e = vertex.irradiance;
    AppendRow(text, {vertex.at.x, vertex.at.y, vertex.at.z, vertex.value, e[0],
                     e[1], e[2]});
  }
  return text + Rows(mesh, [](std::string& row, std::size_t /*i*/,
                              const IsoMeshTriangle& triangle) {
           row += "3 ";
           AppendWhole(row, triangle.vertices);
         });
}

std::string MeshVtu(const IsoMesh& mesh) {
  std::string points;
  std::string values;
  std::string colours;
  for (const IsoMeshVertex& vertex : mesh.vertices) {
    const Rgb& e = vertex.irradiance;
    AppendRow(points, vertex.at);
    AppendRow(values, {vertex.value});
    AppendRow(colours, {e[0], e[1], e[2]});
  }
  using Row = const IsoMeshTriangle&;
  const std::string corners =
      Rows(mesh, [](std::string& row, std::size_t /*i*/, Row triangle) {
        AppendWhole(row, triangle.vertices);
      });
  const std::string ends =
      Rows(mesh, [](std::string& row, std::size_t i, Row /*triangle*/) {
        row += std::to_string(3 * (i + 1));
      });
  const std::string types = Rows(mesh, [](std::string& row, std::size_t /*i*/,
                                          Row /*triangle*/) { row += '5'; });
  const std::string faces =
      Rows(mesh, [](std::string& row, std::size_t /*i*/, Row triangle) {
        row += std::to_string(triangle.face);
      });
  const std::string sides =
      Rows(mesh, [](std::string& row, std::size_t /*i*/, Row triangle) {
        AppendWhole(row, triangle.sides);
      });
  return "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
         "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"
         "<Piece NumberOfPoints=\"" +
         std::to_string(mesh.vertices.size()) + "\" NumberOfCells=\"" +
         std::to_string(mesh.triangles.size()) + "\">\n<Points>\n" +
         DataArray("Float64", "Points", 3, points) +
         "</Points>\n<PointData Scalars=\"E\">\n" +
         DataArray("Float64", "E", 1, values) +
         DataArray("Float64", "E_rgb", 3, colours) +
         "</PointData>\n<CellData>\n" + DataArray("Int32", "face", 1, faces) +
         DataArray("Int32", "sides", 3, sides) + "</CellData>\n<Cells>\n" +
         DataArray("Int32", "connectivity", 1, corners) +
         DataArray("Int32", "offsets", 1, ends) +
         DataArray("UInt8", "types", 1, types) +
         "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace truelux
