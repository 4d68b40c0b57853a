// SPDX-License-Identifier: GPL-3.0-or-later
#include "truelux/scene.h"

#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "scene/group_selection.h"
#include "scene/index/face_finder.h"
#include "scene/scene_data.h"

namespace truelux {
namespace {

/// Whether a position is finite and a normal is finite and not zero.
bool IsUsable(const Receiver& receiver) {
  const auto [x, y, z] = receiver.position;
  const auto [nx, ny, nz] = receiver.normal;
  return std::isfinite(x) && std::isfinite(y) && std::isfinite(z) &&
         std::isfinite(nx) && std::isfinite(ny) && std::isfinite(nz) &&
         (nx != 0 || ny != 0 || nz != 0);
}

}  // namespace

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

std::span<const int> Scene::corner_numbers() const {
  return data_->corner_numbers;
}

std::span<const std::string> Scene::group_names() const {
  return data_->group_names;
}

std::span<const LeftOutFaces> Scene::left_out() const {
  return data_->left_out;
}

std::optional<NearFace> Scene::FaceNear(const Receiver& receiver,
                                        std::optional<double> limit) const {
  if (!IsUsable(receiver)) return std::nullopt;
  return FaceWithin(*this, receiver, limit);
}

std::optional<NearFace> Scene::FaceNear(const Receiver& receiver,
                                        std::string_view name) const {
  if (!IsUsable(receiver)) return std::nullopt;
  const std::shared_ptr<const FaceFinder> finder = [&] {
    Data::Lazy& lazy = data_->lazy;
    const std::scoped_lock lock(lazy.mutex);
    const auto found = lazy.finders.find(name);
    if (found != lazy.finders.end()) return found->second;
    const std::vector<int> own = FacesOf(*this, GroupsNamed(*this, name));
    auto made = std::make_shared<const FaceFinder>(*this, own);
    lazy.finders.emplace(name, made);
    return made;
  }();
  return finder->Nearest(*this, receiver);
}

bool Scene::IsBehindFace(const Receiver& receiver) const {
  return IsUsable(receiver) && truelux::IsBehindFace(*this, receiver);
}

}  // namespace truelux
