// SPDX-License-Identifier: GPL-3.0-or-later
// Objects and groups by name.

#ifndef TRUELUX_SCENE_GROUP_SELECTION_H_
#define TRUELUX_SCENE_GROUP_SELECTION_H_

#include <span>
#include <string_view>
#include <vector>

#include "truelux/scene.h"

namespace truelux {

/// The groups that a name stands for, as indices into Scene::group_names():
/// those called so, and those called "name/..." (the groups of an object) or
/// ".../name" (a group in any object). In their order; empty if there is none.
[[nodiscard]] std::vector<int> GroupsNamed(const Scene& scene,
                                           std::string_view name);

/// The faces of some groups, as indices into Scene::faces(), in their order.
[[nodiscard]] std::vector<int> FacesOf(const Scene& scene,
                                       std::span<const int> groups);

}  // namespace truelux

#endif  // TRUELUX_SCENE_GROUP_SELECTION_H_
