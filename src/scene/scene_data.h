// SPDX-License-Identifier: GPL-3.0-or-later
// What a Scene shares between its copies.

#ifndef TRUELUX_SCENE_SCENE_DATA_H_
#define TRUELUX_SCENE_SCENE_DATA_H_

#include <string>
#include <vector>

#include "truelux/scene.h"

namespace truelux {

/// The arrays of a scene while it is built.
struct SceneArrays {
  std::vector<Point3> vertices;
  std::vector<Triangle> triangles;
  std::vector<Facet> facets;
  std::vector<Face> faces;
  std::vector<int> corners;
  std::vector<std::string> group_names{""};
  std::vector<LeftOutFaces> left_out;
};

/// Appends the backs of the facets first_facet .. end - 1 of the last face.
void AppendBacks(int first_facet, int end, SceneArrays& arrays);

struct Scene::Data : SceneArrays {};

}  // namespace truelux

#endif  // TRUELUX_SCENE_SCENE_DATA_H_
