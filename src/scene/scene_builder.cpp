// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "truelux/diagnostics.h"
#include "truelux/scene.h"

#include "scene/scene_assembly.h"
#include "scene/scene_data.h"

namespace truelux {

struct SceneBuilder::Impl {
  explicit Impl(const std::string& name) : file_name(name), assembly(name) {}

  [[nodiscard]] Face MakeFace(const Rgb& emission, int line) const {
    Face face;
    face.emission = emission;
    face.line = line;
    face.group = group;
    return face;
  }

  std::string file_name;
  SceneAssembly assembly;
  std::vector<std::string> group_names{""};
  std::unordered_map<std::string, int> group_index{{"", 0}};
  int group = 0;
  std::vector<int> vertex_numbers;  ///< of the next face
};

SceneBuilder::SceneBuilder(const std::string& file_name)
    : impl_(std::make_unique<Impl>(file_name)) {}

SceneBuilder::~SceneBuilder() = default;
SceneBuilder::SceneBuilder(SceneBuilder&&) noexcept = default;
SceneBuilder& SceneBuilder::operator=(SceneBuilder&&) noexcept = default;

int SceneBuilder::AddFace(std::vector<Point3> ring, const Rgb& emission,
                          int line) {
  std::vector<int> numbers = std::exchange(impl_->vertex_numbers, {});
  if (numbers.size() != ring.size()) numbers.clear();
  impl_->assembly.AddFace(impl_->MakeFace(emission, line), ring, numbers);
  return impl_->assembly.face_count();
}

void SceneBuilder::SetVertexNumbers(std::vector<int> numbers) {
  impl_->vertex_numbers = std::move(numbers);
}

int SceneBuilder::LeaveOutFace(std::string_view reason, int line) {
  impl_->assembly.LeaveOut(impl_->MakeFace({}, line), reason);
  return impl_->assembly.face_count();
}

void SceneBuilder::SetTwoSided(bool two_sided) {
  impl_->assembly.set_two_sided(two_sided);
}

void SceneBuilder::SetLenient(bool lenient) {
  impl_->assembly.set_lenient(lenient);
}

void SceneBuilder::SetGroup(std::string_view name) {
  const auto [entry, is_new] = impl_->group_index.try_emplace(
      std::string(name), static_cast<int>(impl_->group_names.size()));
  if (is_new) impl_->group_names.emplace_back(name);
  impl_->group = entry->second;
}

Result<Scene> SceneBuilder::Build() {
  const std::unique_ptr<Impl> built =
      std::exchange(impl_, std::make_unique<Impl>(impl_->file_name));
  Result<Scene> result;
  result.diagnostics = built->assembly.TakeDiagnostics();
  if (built->assembly.face_count() == 0) {
    result.diagnostics.push_back(
        {Severity::kNote, built->file_name, 0, "the scene has no faces"});
  }
  const bool has_error = std::ranges::any_of(
      result.diagnostics,
      [](const Diagnostic& d) { return d.severity == Severity::kError; });
  if (has_error) return result;
  const auto data = std::make_shared<Scene::Data>();
  static_cast<SceneArrays&>(*data) = built->assembly.TakeArrays();
  // Of some faces only they would be of no use.
  if (data->corner_numbers.size() != data->corners.size()) {
    data->corner_numbers = data->corners;
    for (int& number : data->corner_numbers)
      ++number;
  }
  data->group_names = std::move(built->group_names);
  result.value.emplace().data_ = data;
  return result;
}

}  // namespace truelux
