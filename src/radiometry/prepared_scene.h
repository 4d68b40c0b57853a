// SPDX-License-Identifier: GPL-3.0-or-later
// What a PreparedScene holds, for the oracles over it.

#ifndef TRUELUX_RADIOMETRY_PREPARED_SCENE_H_
#define TRUELUX_RADIOMETRY_PREPARED_SCENE_H_

#include <memory>
#include <utility>

#include "truelux/prepared_scene.h"
#include "truelux/scene.h"

#include "base/pool.h"
#include "radiometry/evaluation_workspace.h"
#include "visibility/contour.h"
#include "visibility/edges/contour_engine.h"

namespace truelux {

/// What one thread needs for one receiver after the other, whatever the
/// options of the oracle that asks. It carries no result over; a user starts a
/// block of receivers, or ends the last one, before the first contour.
struct OracleWorkspace {
  explicit OracleWorkspace(const ContourEngine& engine) : builder(engine) {}

  ContourBuilder builder;
  Contour contour;
  EvaluationWorkspace evaluation;
};

/// What is prepared once; shared by the copies of a PreparedScene.
struct PreparedScene::Data {
  explicit Data(Scene given) : scene(std::move(given)), engine(scene) {}

  /// An idle workspace, or a new one.
  Pool<OracleWorkspace>::Loan Borrow() {
    return workspaces.Borrow(
        [this] { return std::make_unique<OracleWorkspace>(engine); });
  }

  Scene scene;
  ContourEngine engine;
  Pool<OracleWorkspace> workspaces;
};

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_PREPARED_SCENE_H_
