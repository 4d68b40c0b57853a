// SPDX-License-Identifier: GPL-3.0-or-later
// A scene whose vertices can be displaced, with its engine.

#ifndef TRUELUX_RADIOMETRY_DERIVATIVES_LOOSE_ENGINE_H_
#define TRUELUX_RADIOMETRY_DERIVATIVES_LOOSE_ENGINE_H_

#include "scene/loose_scene.h"
#include "visibility/edges/contour_engine.h"

namespace truelux {

struct LooseEngine {
  explicit LooseEngine(const Scene& given)
      : scene(LooseSceneOf(given)), engine(scene.scene) {}

  LooseScene scene;
  ContourEngine engine;
};

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_DERIVATIVES_LOOSE_ENGINE_H_
