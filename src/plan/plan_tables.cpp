// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/plan_tables.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "text/results.h"

namespace truelux {
namespace {

void AppendField(std::string& text, double value) {
  text += ',';
  AppendNumber(text, value);
}

template <class Triple>
void AppendFields(std::string& text, const Triple& p) {
  AppendField(text, p.x);
  AppendField(text, p.y);
  AppendField(text, p.z);
}

/// Three fields, empty if they are not given.
void AppendFields(std::string& text, const Rgb& values, bool is_given) {
  for (const double value : values) {
    if (is_given) {
      AppendField(text, value);
    } else {
      text += ',';
    }
  }
}

}  // namespace

std::vector<int> VertexNumbers(const Scene& scene) {
  std::vector<int> numbers(scene.vertices().size());
  for (std::size_t i = 0; i < scene.corners().size(); ++i) {
    int& number = numbers[static_cast<std::size_t>(scene.corners()[i])];
    if (number == 0) number = scene.corner_numbers()[i];
  }
  return numbers;
}

std::string EdgeText(std::span<const std::array<int, 2>> edges,
                     std::span<const int> vertex_numbers) {
  std::string text;
  for (const std::array<int, 2>& edge : edges) {
    if (!text.empty()) text += ';';
    if (edge[0] < 0 || edge[1] < 0) {
      text += "cut";
      continue;
    }
    text += std::to_string(vertex_numbers[static_cast<std::size_t>(edge[0])]);
    text += '-';
    text += std::to_string(vertex_numbers[static_cast<std::size_t>(edge[1])]);
  }
  return text;
}

std::string ContourCsv(const Isolux& isolux) {
  std::string text =
      "contour,level,closed,vertex,x,y,z,half_width,across_x,across_y,across_z,"
      "certified,on,chord\n";
  for (std::size_t i = 0; i < isolux.contours.size(); ++i) {
    const IsoluxContour& contour = isolux.contours[i];
    std::string start = std::to_string(i + 1);
    AppendField(start, contour.level);
    start += contour.is_closed ? ",1," : ",0,";
    for (std::size_t k = 0; k < contour.vertices.size(); ++k) {
      const IsoluxVertex& vertex = contour.vertices[k];
      text += start + std::to_string(k + 1);
      AppendFields(text, vertex.at);
      AppendField(text, vertex.half_width);
      AppendFields(text, vertex.across);
      text += vertex.is_certified ? ",1," : ",0,";
      text += Name(vertex.on);
      text += ',';
      if (k < contour.widths.size()) AppendNumber(text, contour.widths[k]);
      text += '\n';
    }
  }
  return text;
}

std::string SurfaceLineCsv(const SurfaceLines& lines,
                           std::span<const int> vertex_numbers) {
  std::string text =
      "kind,x0,y0,z0,x1,y1,z1,b_r,b_g,b_b,left_r,left_g,left_b,right_r,right_g,"
      "right_b,faces,edges\n";
  for (const SurfaceLine& line : lines.lines) {
    const bool is_jump = line.kind == SurfaceLineKind::kJump;
    text += Name(line.kind);
    AppendFields(text, line.ends[0]);
    AppendFields(text, line.ends[1]);
    AppendFields(text, line.size, !is_jump);
    AppendFields(text, line.left, is_jump);
    AppendFields(text, line.right, is_jump);
    text += ',';
    for (std::size_t i = 0; i < line.faces.size(); ++i)
      text += (i == 0 ? "" : ";") + std::to_string(line.faces[i]);
    text += ',' + EdgeText(line.edges, vertex_numbers) + '\n';
  }
  return text;
}

std::string ExtremaCsv(const SurfaceExtrema& extrema) {
  std::string text = "kind,x,y,z,E,least,most,radius,on\n";
  for (const SurfaceExtremum& point : extrema.points) {
    text += Name(point.kind);
    AppendFields(text, point.at);
    for (const double value :
         {point.value, point.least, point.most, point.radius})
      AppendField(text, value);
    text += ',';
    text += Name(point.on);
    text += '\n';
  }
  for (const UndecidedRegion& region : extrema.undecided) {
    const auto& [a, b, c] = region.triangles.front();
    const Point3 middle = {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3,
                           (a.z + b.z + c.z) / 3};
    double radius = 0;
    for (const auto& corners : region.triangles) {
      for (const Point3& p : corners) {
        radius = std::max(
            radius, std::hypot(p.x - middle.x, p.y - middle.y, p.z - middle.z));
      }
    }
    text += "undecided";
    AppendFields(text, middle);
    text += ',';
    for (const double value : {region.least, region.most, radius})
      AppendField(text, value);
    text += ",\n";
  }
  return text;
}

}  // namespace truelux
