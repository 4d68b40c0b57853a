// SPDX-License-Identifier: GPL-3.0-or-later
#include "truelux/scene.h"

#include <memory>
#include <span>
#include <string>

#include "scene/scene_data.h"

namespace truelux {

Scene::Scene() : data_(std::make_shared<const Data>()) {}

std::span<const Point3> Scene::vertices() const {
  return data_->vertices;
}

std::span<const Triangle> Scene::triangles() const {
  return data_->triangles;
}

std::span<const Facet> Scene::facets() const {
  return data_->facets;
}

std::span<const Face> Scene::faces() const {
  return data_->faces;
}

std::span<const int> Scene::corners() const {
  return data_->corners;
}

std::span<const std::string> Scene::group_names() const {
  return data_->group_names;
}

std::span<const LeftOutFaces> Scene::left_out() const {
  return data_->left_out;
}

}  // namespace truelux
