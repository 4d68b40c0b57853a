// SPDX-License-Identifier: GPL-3.0-or-later
// Which faces emit.

#ifndef TRUELUX_SCENE_EMITTERS_H_
#define TRUELUX_SCENE_EMITTERS_H_

#include <vector>

#include "truelux/scene.h"

namespace truelux {

/// Whether a face emits in some channel.
[[nodiscard]] bool Emits(const Face& face);

/// The faces that emit and have facets, as indices into Scene::faces(), in
/// their order.
[[nodiscard]] std::vector<int> EmittersOf(const Scene& scene);

/// Whether every face emits the same in red, green and blue.
[[nodiscard]] bool IsGrey(const Scene& scene);

}  // namespace truelux

#endif  // TRUELUX_SCENE_EMITTERS_H_
