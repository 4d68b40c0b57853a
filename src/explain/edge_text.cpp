// SPDX-License-Identifier: GPL-3.0-or-later
#include "explain/edge_text.h"

#include <cstddef>
#include <fmt/format.h>

#include "scene/io/quoted.h"
#include "scene/scene_access.h"
#include "text/results.h"

namespace truelux {
namespace {

std::string TextOfVertex(const Scene& scene, int vertex) {
  return TextOf(VerticesOf(scene)[VertexId(vertex)]);
}

}  // namespace

std::string TextOf(const Point3& point) {
  std::string text = "(";
  AppendNumber(text, point.x);
  text += ", ";
  AppendNumber(text, point.y);
  text += ", ";
  AppendNumber(text, point.z);
  return text + ")";
}

std::string TextOfFace(const Scene& scene, int face) {
  const Face& f = FacesOf(scene)[IndexOf(FaceNumber(face))];
  const std::string& group =
      scene.group_names()[static_cast<std::size_t>(f.group)];
  std::string where = f.line > 0 ? fmt::format("line {}", f.line) : "";
  if (!group.empty()) where += (where.empty() ? "" : ", ") + Shown(group);
  return fmt::format("face {}{}", face,
                     where.empty() ? "" : " (" + where + ")");
}

std::string TextOf(const Scene& scene, const SeenEdge& edge) {
  if (edge.a < 0) {
    return TextOfFace(scene, edge.face) + " where it meets the plane of " +
           TextOfFace(scene, edge.other_face);
  }
  return TextOfFace(scene, edge.face) + ", edge " +
         TextOfVertex(scene, edge.a) + " to " + TextOfVertex(scene, edge.b);
}

}  // namespace truelux
