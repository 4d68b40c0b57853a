// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspect/view_titles.h"

#include <fmt/format.h>

#include "explain/edge_text.h"

namespace truelux {
namespace {

std::string TextOfRegion(const InspectedView& inspected, int region) {
  return region < 0
             ? "below the horizon"
             : TitleOfRegion(inspected, static_cast<std::size_t>(region));
}

}  // namespace

std::string DigitsOf(const Vector3& v) {
  return fmt::format("({:.17g}, {:.17g}, {:.17g})", v.x, v.y, v.z);
}

std::string TitleOfRegion(const InspectedView& inspected, std::size_t region) {
  const ViewRegion& r = inspected.view.regions[region];
  const RegionKind kind = KindOf(inspected.scene, r);
  if (kind == RegionKind::kNothing) return Name(kind);
  return fmt::format(
      "{} {}", kind == RegionKind::kBack ? "back of emitting" : Name(kind),
      TextOfFace(inspected.scene, r.face));
}

std::string TitleOfArc(const InspectedView& inspected, std::size_t arc) {
  const WholeViewArc& a = inspected.view.arcs[arc];
  std::string text = Name(a.kind);
  if (a.edge.face > 0) text += ": " + TextOf(inspected.scene, a.edge);
  text += "\nbetween " + TextOfRegion(inspected, a.left);
  text += "\nand " + TextOfRegion(inspected, a.right);
  return text + "\nin the plane " + DigitsOf(a.plane_normal);
}

std::string TitleOfVertex(const InspectedView& inspected, std::size_t vertex) {
  constexpr std::size_t kMostEdges = 10;
  const WholeViewVertex& v = inspected.view.vertices[vertex];
  std::string text = fmt::format("{}{} vertex, {} {}",
                                 v.vertex.conjunctive ? "conjunctive, " : "",
                                 Name(v.vertex.kind), v.vertex.planes,
                                 v.vertex.planes == 1 ? "edge" : "edges");
  if (v.planes_with_hidden > v.vertex.planes) {
    text += fmt::format(" ({} with those hidden behind)", v.planes_with_hidden);
  }
  text += "\ndirection " + DigitsOf(v.vertex.direction);
  if (v.vertex.vertex >= 0) {
    const Point3& p =
        inspected.scene.vertices()[static_cast<std::size_t>(v.vertex.vertex)];
    text += "\nat " + DigitsOf({p.x, p.y, p.z});
  }
  for (std::size_t e = 0; e < v.edges.size(); ++e) {
    if (e == kMostEdges) {
      return text + fmt::format("\nand {} more", v.edges.size() - e);
    }
    text += "\n" + TextOf(inspected.scene, v.edges[e]);
  }
  return text;
}

}  // namespace truelux
