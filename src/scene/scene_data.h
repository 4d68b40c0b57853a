// SPDX-License-Identifier: GPL-3.0-or-later
// What a Scene shares between its copies.

#ifndef TRUELUX_SCENE_SCENE_DATA_H_
#define TRUELUX_SCENE_SCENE_DATA_H_

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
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
  std::vector<int> corner_numbers;  ///< parallel to corners
  std::vector<std::string> group_names{""};
  std::vector<LeftOutFaces> left_out;
};

/// Appends the backs of the facets first_facet .. end - 1 of the last face.
void AppendBacks(int first_facet, int end, SceneArrays& arrays);

class FaceFinder;
class SceneIndex;

struct Scene::Data : SceneArrays {
  /// What is made when it is first asked for.
  struct Lazy {
    std::once_flag index_is_made;
    std::shared_ptr<const SceneIndex> index;
    std::mutex mutex;  ///< of finders
    /// By the name of an object or a group.
    std::map<std::string, std::shared_ptr<const FaceFinder>, std::less<>>
        finders;
  };

  mutable Lazy lazy;
  /// Whether vertices may be displaced: nothing is then known to be coplanar.
  bool is_loose = false;
};

}  // namespace truelux

#endif  // TRUELUX_SCENE_SCENE_DATA_H_
