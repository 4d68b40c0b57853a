// SPDX-License-Identifier: GPL-3.0-or-later
// What a receiver sees of a light: the arcs that bound the visible part, and
// what their ends are.

#include <cstddef>
#include <cstdio>
#include <string>

#include "truelux/truelux.h"

int main() {
  truelux::SceneBuilder builder;
  // A square light overhead, and a triangle below it that hides part of it.
  // One edge of the triangle is seen to pass exactly through a corner of the
  // light: more than two edges meet there, the vertex is conjunctive.
  builder.AddFace({{-2, -2, 2}, {-2, 2, 2}, {2, 2, 2}, {2, -2, 2}}, {1, 1, 1});
  builder.AddFace({{0, 0, 1}, {3, 3, 1}, {3, 0, 1}});
  const truelux::Result<truelux::Scene> scene = builder.Build();
  if (!scene.ok()) return 1;

  const truelux::Oracle oracle(*scene.value);
  const truelux::VisibleContour contour =
      oracle.Contour({{0, 0, 0}, {0, 0, 1}});
  for (std::size_t i = 0; i < contour.vertices.size(); ++i) {
    const truelux::ContourVertex& v = contour.vertices[i];
    const std::string kind(Name(v.kind));
    std::printf("vertex %zu: %s%s, direction (%g, %g, %g)\n", i, kind.c_str(),
                v.conjunctive ? ", conjunctive" : "", v.direction.x,
                v.direction.y, v.direction.z);
  }
  for (const truelux::ContourArc& arc : contour.arcs) {
    std::printf("arc %d -> %d of face %d, along an edge of face %d\n", arc.from,
                arc.to, arc.source, arc.edge_face);
  }
  return 0;
}
