// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/group_selection.h"

#include <algorithm>
#include <cstddef>
#include <string>

namespace truelux {
namespace {

bool StandsFor(std::string_view name, std::string_view group) {
  if (group == name) return true;
  if (group.size() <= name.size()) return false;
  const std::size_t rest = group.size() - name.size();
  return (group.starts_with(name) && group[name.size()] == '/') ||
         (group.ends_with(name) && group[rest - 1] == '/');
}

}  // namespace

std::vector<int> GroupsNamed(const Scene& scene, std::string_view name) {
  std::vector<int> groups;
  for (std::size_t i = 0; i < scene.group_names().size(); ++i) {
    if (StandsFor(name, scene.group_names()[i]))
      groups.push_back(static_cast<int>(i));
  }
  return groups;
}

std::vector<int> FacesOf(const Scene& scene, std::span<const int> groups) {
  std::vector<int> faces;
  for (std::size_t i = 0; i < scene.faces().size(); ++i) {
    const int group = scene.faces()[i].group;
    if (std::ranges::find(groups, group) != groups.end())
      faces.push_back(static_cast<int>(i));
  }
  return faces;
}

}  // namespace truelux
