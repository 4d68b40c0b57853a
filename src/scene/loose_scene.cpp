// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/loose_scene.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <utility>

#include "scene/polygon.h"
#include "scene/scene_data.h"
#include "scene/scene_variants.h"

namespace truelux {
namespace {

std::size_t Index(int i) {
  return static_cast<std::size_t>(i);
}

/// The numbers that faces use, each once.
std::vector<int> UsedNumbers(std::span<const int> corners) {
  std::vector<int> numbers(corners.begin(), corners.end());
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

int IndexOfNumber(const std::vector<int>& numbers, int number) {
  const auto at = std::ranges::lower_bound(numbers, number);
  return at != numbers.end() && *at == number
             ? static_cast<int>(at - numbers.begin())
             : -1;
}

std::span<const Facet> FacetsOfFace(const Scene& scene, const Face& face) {
  return scene.facets().subspan(Index(face.first_facet),
                                Index(face.facet_count));
}

/// A triangle that is a facet of its own.
struct LooseTriangle {
  std::array<int, 3> vertices{};
  bool is_back = false;
};

void AppendFace(const Face& face, std::span<const LooseTriangle> triangles,
                SceneArrays& arrays) {
  Face copy = face;
  copy.first_facet = static_cast<int>(arrays.facets.size());
  copy.facet_count = static_cast<int>(triangles.size());
  const auto index = static_cast<int>(arrays.faces.size());
  for (const LooseTriangle& triangle : triangles) {
    const auto facet = static_cast<int>(arrays.facets.size());
    const auto first = static_cast<int>(arrays.triangles.size());
    arrays.facets.push_back({index, triangle.is_back, first, 1});
    arrays.triangles.push_back({triangle.vertices, facet});
  }
  arrays.faces.push_back(copy);
}

/// A triangle that begins with its least corner.
std::array<int, 3> Rotated(std::array<int, 3> triangle) {
  std::rotate(triangle.begin(), std::ranges::min_element(triangle),
              triangle.end());
  return triangle;
}

}  // namespace

VertexId LooseScene::VertexOf(int number) const {
  return VertexId(IndexOfNumber(numbers, number));
}

LooseScene LooseSceneOf(const Scene& scene) {
  return {SceneVariants::Loose(scene), UsedNumbers(scene.corner_numbers())};
}

bool SceneVariants::IsLoose(const Scene& scene) {
  return scene.data_->is_loose;
}

Scene SceneVariants::Loose(const Scene& scene) {
  const std::span<const int> of_corners = scene.corner_numbers();
  const std::vector<int> numbers = UsedNumbers(of_corners);
  const auto data = std::make_shared<Scene::Data>();
  data->is_loose = true;
  data->group_names.assign(scene.group_names().begin(),
                           scene.group_names().end());
  data->left_out.assign(scene.left_out().begin(), scene.left_out().end());
  data->vertices.resize(numbers.size());
  for (std::size_t i = 0; i < of_corners.size(); ++i) {
    const int vertex = IndexOfNumber(numbers, of_corners[i]);
    data->corners.push_back(vertex);
    data->vertices[Index(vertex)] = scene.vertices()[Index(scene.corners()[i])];
  }
  data->corner_numbers.assign(of_corners.begin(), of_corners.end());
  for (const Face& face : scene.faces()) {
    // A corner of the face that is in the place of a vertex of the scene.
    const auto loose = [&](int vertex) {
      const auto ring = scene.corners().subspan(Index(face.first_corner),
                                                Index(face.corner_count));
      const auto at = std::ranges::find(ring, vertex) - ring.begin();
      return data
          ->corners[Index(face.first_corner) + static_cast<std::size_t>(at)];
    };
    std::vector<LooseTriangle> triangles;
    for (const Facet& facet : FacetsOfFace(scene, face)) {
      for (const Triangle& triangle : scene.triangles().subspan(
               Index(facet.first_triangle), Index(facet.triangle_count))) {
        const auto [a, b, c] = triangle.vertices;
        triangles.push_back({{loose(a), loose(b), loose(c)}, facet.is_back});
      }
    }
    AppendFace(face, triangles, *data);
  }
  Scene result;
  result.data_ = data;
  return result;
}

Scene SceneVariants::WithTriangles(
    const Scene& loose,
    const std::map<std::size_t, std::vector<std::array<int, 3>>>& triangles) {
  const auto data = std::make_shared<Scene::Data>();
  static_cast<SceneArrays&>(*data) = *loose.data_;
  data->is_loose = true;
  data->faces.clear();
  data->facets.clear();
  data->triangles.clear();
  for (std::size_t i = 0; i < loose.faces().size(); ++i) {
    const Face& face = loose.faces()[i];
    const std::span<const Facet> facets = FacetsOfFace(loose, face);
    std::vector<LooseTriangle> own;
    const auto other = triangles.find(i);
    if (other != triangles.end()) {
      const bool has_back = std::ranges::any_of(facets, &Facet::is_back);
      for (const std::array<int, 3>& t : other->second)
        own.push_back({t, false});
      for (const auto& [a, b, c] : other->second) {
        if (has_back) own.push_back({{a, c, b}, true});
      }
    } else {
      for (const Facet& facet : facets) {
        own.push_back({loose.triangles()[Index(facet.first_triangle)].vertices,
                       facet.is_back});
      }
    }
    AppendFace(face, own, *data);
  }
  Scene result;
  result.data_ = data;
  return result;
}

std::optional<Scene> WithDisplacedTriangles(const LooseScene& loose,
                                            VertexId vertex,
                                            const Vec3<Exact>& step) {
  std::map<std::size_t, std::vector<std::array<int, 3>>> changed;
  PolygonReader reader;
  const Scene& scene = loose.scene;
  for (std::size_t i = 0; i < scene.faces().size(); ++i) {
    const Face& face = scene.faces()[i];
    const auto corners = scene.corners().subspan(Index(face.first_corner),
                                                 Index(face.corner_count));
    if (corners.size() < 4 || face.facet_count == 0 ||
        std::ranges::find(corners, vertex.value()) == corners.end()) {
      continue;
    }
    std::vector<Point3> ring;
    RingDisplacement displacement{{}, step};
    for (const int corner : corners) {
      ring.push_back(scene.vertices()[Index(corner)]);
      displacement.is_displaced.push_back(corner == vertex.value());
    }
    if (!reader.ReadDisplaced(ring, displacement)) continue;
    std::vector<std::array<int, 3>> triangles;
    std::vector<std::array<int, 3>> sorted;
    for (const auto& [a, b, c] : reader.triangles()) {
      triangles.push_back(
          {corners[Index(a)], corners[Index(b)], corners[Index(c)]});
      sorted.push_back(Rotated(triangles.back()));
    }
    std::vector<std::array<int, 3>> before;
    for (const Facet& facet : FacetsOfFace(scene, face)) {
      if (facet.is_back) continue;
      before.push_back(
          Rotated(scene.triangles()[Index(facet.first_triangle)].vertices));
    }
    std::ranges::sort(sorted);
    std::ranges::sort(before);
    if (sorted != before) changed.emplace(i, std::move(triangles));
  }
  if (changed.empty()) return std::nullopt;
  return SceneVariants::WithTriangles(scene, changed);
}

}  // namespace truelux
