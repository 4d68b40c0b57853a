// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene_variants.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "scene/emitters.h"
#include "scene/scene_data.h"

namespace truelux {
namespace {

std::size_t Index(int i) {
  return static_cast<std::size_t>(i);
}

/// One flag per face of the scene.
std::vector<bool> FlagsOf(const Scene& scene, std::span<const int> faces) {
  std::vector<bool> flags(scene.faces().size(), false);
  for (const int face : faces)
    flags[Index(face)] = true;
  return flags;
}

/// Copies the facets of one face behind those that `arrays` has already.
void AppendFacets(const Scene& scene, const Face& face, bool reversed,
                  SceneArrays& arrays) {
  for (const Facet& facet : scene.facets().subspan(Index(face.first_facet),
                                                   Index(face.facet_count))) {
    const int number = static_cast<int>(arrays.facets.size());
    Facet copy = facet;
    copy.first_triangle = static_cast<int>(arrays.triangles.size());
    arrays.facets.push_back(copy);
    for (Triangle triangle : scene.triangles().subspan(
             Index(facet.first_triangle), Index(facet.triangle_count))) {
      triangle.facet = number;
      if (reversed) std::swap(triangle.vertices[1], triangle.vertices[2]);
      arrays.triangles.push_back(triangle);
    }
  }
}

bool IsTwoSided(const Scene& scene, const Face& face) {
  return face.facet_count > 0 &&
         scene.facets()[Index(face.first_facet + face.facet_count - 1)].is_back;
}

}  // namespace

Scene SceneVariants::Changed(
    const Scene& scene,
    const std::function<void(std::size_t, FaceChange&)>& change) {
  const auto data = std::make_shared<Scene::Data>();
  data->vertices.assign(scene.vertices().begin(), scene.vertices().end());
  data->corners.assign(scene.corners().begin(), scene.corners().end());
  data->corner_numbers = scene.data_->corner_numbers;
  data->group_names.assign(scene.group_names().begin(),
                           scene.group_names().end());
  data->left_out.assign(scene.left_out().begin(), scene.left_out().end());
  for (std::size_t i = 0; i < scene.faces().size(); ++i) {
    const Face& face = scene.faces()[i];
    FaceChange changed;
    changed.emission = face.emission;
    change(i, changed);
    Face copy = face;
    copy.emission = changed.emission;
    copy.first_facet = static_cast<int>(data->facets.size());
    if (changed.removed) {
      copy.facet_count = 0;
      copy.emission = {};
    } else {
      AppendFacets(scene, face, changed.reversed, *data);
      if (changed.two_sided && !IsTwoSided(scene, face)) {
        AppendBacks(copy.first_facet, copy.first_facet + copy.facet_count,
                    *data);
        copy.facet_count *= 2;
      }
    }
    if (changed.reversed && face.corner_count > 0) {
      // The ring still begins at its first corner.
      for (std::vector<int>* corners :
           {&data->corners, &data->corner_numbers}) {
        const auto first = corners->begin() + face.first_corner;
        std::reverse(first + 1, first + face.corner_count);
      }
    }
    data->faces.push_back(copy);
  }
  Scene variant;
  variant.data_ = data;
  return variant;
}

Scene WithUnitExitance(const Scene& scene) {
  return SceneVariants::Changed(scene, [&](std::size_t i, FaceChange& change) {
    if (Emits(scene.faces()[i])) change.emission = {1, 1, 1};
  });
}

Scene WithReversedEmitters(const Scene& scene) {
  return SceneVariants::Changed(scene, [&](std::size_t i, FaceChange& change) {
    change.reversed = Emits(scene.faces()[i]);
  });
}

Scene WithTwoSidedEmitters(const Scene& scene) {
  return SceneVariants::Changed(scene, [&](std::size_t i, FaceChange& change) {
    change.two_sided = Emits(scene.faces()[i]);
  });
}

Scene WithoutFaces(const Scene& scene, std::span<const int> faces) {
  const std::vector<bool> removed = FlagsOf(scene, faces);
  return SceneVariants::Changed(scene, [&](std::size_t i, FaceChange& change) {
    change.removed = removed[i];
  });
}

Scene WithBlackFaces(const Scene& scene, std::span<const int> faces) {
  const std::vector<bool> black = FlagsOf(scene, faces);
  return SceneVariants::Changed(scene, [&](std::size_t i, FaceChange& change) {
    if (black[i]) change.emission = {};
  });
}

Scene WithOneEmitter(const Scene& scene, int face) {
  return SceneVariants::Changed(scene, [&](std::size_t i, FaceChange& change) {
    if (i != Index(face)) change.emission = {};
  });
}

}  // namespace truelux
